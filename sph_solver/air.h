#pragma once
#include "sph_solver/simulation.h"

namespace tw {

/// Air above and around the water: a level of its own (pairs/level_pair.h says how the two meet), a gas of its own
/// density and sound speed on particles of the water's spacing,
///
///   p = rho_a c_a^2 / gamma ((rho / rho_a)^gamma - 1),   rho_a c_a^2 = gamma p_atm with the real 343 m/s.
///
/// Other effects act on the water alone, but for the motion of a tank. The gas is shut in by a lid: what breaking
/// water's particles lose in order they gain in volume, and the gas bears it (2 % of the gas are 3 kPa). So sampled
/// pressures are relative to the lid's, as if the top were open. The gas sets the time step: its sound is four times
/// faster than a typical numerical sound of water.
struct AirOptions {
    double density = Water{}.air_density;      ///< rho_a [kg/m3]
    double sound_speed = SphOptions{}.air_c0;  ///< c_a [m/s]
    double heat_capacities = 1.4;              ///< gamma [-]
};

/// Puts the gas beside the water; before the first step. What flies up bounces off the lid. Throws InputError for a
/// scheme in stages, or where there is no room for gas.
void add_air(Simulation& simulation, const AirOptions& air, const Fluid& fluid);

/// Kinetic, potential and elastic energy [J], with x = rho/rho_a per mass
///   int p / rho^2 drho = c_a^2/gamma (x^(gamma-1)/(gamma-1) + 1/x - gamma/(gamma-1)).
double gas_energy(const Level& gas, const Vec3& gravity);

}  // namespace tw
