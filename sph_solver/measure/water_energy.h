#pragma once
#include "sph_solver/simulation.h"

namespace tw {

/// Of the water that follows the equations, of all sizes (of half of it in a half model).
struct WaterEnergy {
    double mass = 0;       ///< [kg]
    double kinetic = 0;    ///< sum_i m u_i^2 / 2 [J]
    double potential = 0;  ///< - sum_i m g_z z_i [J]
    double elastic = 0;    ///< sum_i m c0^2 ((rho_i - rho0) / rho0)^2 / 2 [J]
};
WaterEnergy water_energy(const Simulation& simulation);

}  // namespace tw
