#pragma once
#include <cstddef>

#include "sph_solver/domain/kind.h"
#include "sph_solver/equations/vector.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/pack_state.h"
#include "sph_solver/loops/surface.h"

namespace tw {

/// What follows the first pair loop of a step, of each particle by itself: its density changes by the continuity
/// equation for the time `compress`, its pressure is that of the new density, and it drifts for the time `drift` [s].
/// Walls are looked after at the end of the step.
struct AfterFirstPairLoop {
    StateView p;
    ToFixedPoint to_fixed_point;
    const Kind* kind;
    const PackedRate* rate;
    const PackedShiftSupport* shift;
    const Aired* aired;  ///< null: no ventilation
    PackedPlace* place;
    PackedVelocityDensity* motion;
    PackedGradientPressure* stress;
    PackedWallNormal* wall;  ///< null: there are no walls
    double compress, drift;
    double surface_support;  ///< of LevelSetup
    // of several sizes of particles, else null
    const Trend* trend = nullptr;
    const float* compression = nullptr;
    float* density_rate = nullptr;

    bool lacks_support(std::size_t i) const { return LacksSupport{kind, trend, shift, surface_support}(i); }
    /// `pressure(drho)` [Pa]; `leaving(i, u)`: speed away from the wall near by of one that moves with u [m/s].
    template <class Pressure, class Leaving>
    void operator()(std::size_t i, const Pressure& pressure, const Leaving& leaving) const {
        float& drho = p.drho[i];
        if (kind[i] == Kind::buffer) drho += static_cast<float>(compress * static_cast<double>(trend[i].drho));
        if (follows_the_equations(kind[i])) {
            const bool under_surface = kind[i] == Kind::overlap && lacks_support(i);
            drho += static_cast<float>(compress * static_cast<double>(under_surface ? compression[i] : rate[i].drho));
            if (density_rate) density_rate[i] = rate[i].drho;
            // the free surface bears no tension (its density is not let below rho0)
            if (drho < 0 && (lacks_support(i) || (aired && aired[i] == Aired::yes))) drho = 0;
        }
        motion[i].drho = drho;
        stress[i].p = pressure(drho);
        if (drift > 0) drift_freely(i, leaving);
    }

private:
    template <class Leaving>
    void drift_freely(std::size_t i, const Leaving& leaving) const {
        const V3<double> u{p.u[i], p.v[i], p.w[i]};
        p.x[i] += drift * u.x;
        p.y[i] += drift * u.y;
        p.z[i] += drift * u.z;
        place[i] = to_fixed_point(p.x[i], p.y[i], p.z[i], p.drho[i]);
        if (wall) wall[i].distance += static_cast<float>(drift * leaving(i, u));
    }
};

}  // namespace tw
