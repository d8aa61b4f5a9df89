#pragma once
#include "sph_solver/simulation.h"

namespace tw {

/// How closely the particles inside the water stand, against what their densities say. Particle i takes the space V_i =
/// m / rho_i by its density, and about V_i / S_i by where its neighbours are, S_i = sum_j V_j W_ij (walls counted). The
/// two agree where nothing moves particles but the flow; shifting and walls that do not fit the particles' lattice part
/// them, and the water then takes less room than its mass and density say:
///
///   crowding = 1 - sum_i (V_i / S_i) / sum_i V_i      over the water's particles with S_i > 0.95   [-]
///
/// Negative where it takes more. NaN before the first evaluation, and where no particle is that deep inside.
double crowding(const Simulation& simulation);

}  // namespace tw
