#pragma once
#include <cstddef>

#include "sph_solver/domain/kind.h"
#include "sph_solver/equations/rest_pressure.h"
#include "sph_solver/loops/pack_state.h"

namespace tw {

/// Adds the weight of rest_pressure.h. Gives 1 for a particle of the free surface in the band, else 0.
struct WeighUnderSurface {
    StateView p;
    const Kind* kind;
    const PackedShiftSupport* shift;
    PackedRate* rate;
    RestPressure at_rest;
    double rho0;             ///< [kg/m3]
    double surface_support;  ///< of LevelSetup [-]

    double operator()(std::size_t i) const {
        if (!follows_the_equations(kind[i])) return 0;
        const double z = p.z[i];
        rate[i].az += static_cast<float>(at_rest.acceleration(z, rho0));
        return at_rest.in_band(z) && static_cast<double>(shift[i].support) < surface_support ? 1 : 0;
    }
};

}  // namespace tw
