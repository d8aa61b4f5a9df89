#pragma once
#include <cstdint>

#include "sph_solver/domain/kind.h"
#include "sph_solver/fields/field_table.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/sweeps/records.h"

namespace tw {

/// The particles of a level, structure of arrays, kept sorted in space: their state, and what the sweeps over the pairs
/// read and write of them. Positions in double precision; density as the deviation from rho0, so that single precision
/// loses nothing. A further quantity is one more line.
struct Particles : FieldTable {
    FieldOf<double> x{*this, "x", Kept::saved}, y{*this, "y", Kept::saved}, z{*this, "z", Kept::saved};  ///< [m]
    FieldOf<float> u{*this, "u", Kept::saved}, v{*this, "v", Kept::saved}, w{*this, "w", Kept::saved};   ///< [m/s]
    FieldOf<float> drho{*this, "drho", Kept::saved};     ///< rho - rho0 [kg/m3]
    FieldOf<std::int64_t> id{*this, "id", Kept::saved};  ///< never reused
    FieldOf<Kind> kind{*this, "kind", Kept::saved};

    FieldOf<Trend> trend{*this, "trend", Kept::moved, With::coarser};                 ///< meaningful for guards
    FieldOf<EdgeDistance> from_edge{*this, "from_edge", Kept::moved, With::coarser};  ///< of the own zone
    FieldOf<Children> children{*this, "children", Kept::saved, With::finer};
    /// Of band: rate of the finer level's density there [kg/m3/s].
    FieldOf<float> compression{*this, "compression", Kept::saved, With::finer};
    FieldOf<EdgeDistance> from_finer_edge{*this, "from_finer_edge", Kept::moved, With::finer};

    FieldOf<PlaceRecord, Law::place> place{*this, "place", Kept::sorted};
    FieldOf<VelocityDensityRecord, Law::hydrostatic> velocity_density{*this, "velocity_density", Kept::sorted};
    FieldOf<GradientPressureRecord, Law::hydrostatic> gradient_pressure{*this, "gradient_pressure", Kept::sorted};
    FieldOf<ShiftSupportRecord> shift_support{*this, "shift_support", Kept::sorted};
    FieldOf<RateRecord> rate{*this, "rate", Kept::sorted};
    Marks surface{*this, "surface", Kept::sorted};  ///< who is at the free surface
    /// The nearest wall, the way off its edges, whose wall it is, and on which triangle of that body.
    FieldOf<WallNormalRecord> wall_normal{*this, "wall_normal", Kept::sorted, With::walls};
    FieldOf<LeavingRecord> wall_leaving{*this, "wall_leaving", Kept::sorted, With::walls};
    FieldOf<std::uint16_t> wall_body{*this, "wall_body", Kept::sorted, With::moving_bodies};
    FieldOf<std::int32_t> wall_triangle{*this, "wall_triangle", Kept::sorted, With::elastic_bodies};
    FieldOf<CarriedShare, Law::tensor> carried{*this, "carried", Kept::sorted, With::control_volume};
    FieldOf<Aired> aired{*this, "aired", Kept::saved, With::ventilation};
    /// -rho div u of the last first sweep [kg/m3/s].
    FieldOf<float> density_rate{*this, "density_rate", Kept::sorted, With::coarser};

    std::size_t size() const { return x.size(); }

    void add(double px, double py, double pz, float pu, float pdrho, std::int64_t pid, Kind pkind) {
        const std::size_t i = grow();
        x[i] = px, y[i] = py, z[i] = pz;
        u[i] = pu, drho[i] = pdrho, id[i] = pid, kind[i] = pkind;
    }
};

}  // namespace tw
