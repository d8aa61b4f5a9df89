#pragma once
#include <span>

#include "sph_solver/simulation.h"

namespace tw {

/// Pressure with which water begins whose sides are let go, in place of the hydrostatic one: that of the incompressible
/// problem at rest, laplace p = 0, dp/dn = rho g.n at walls and solids, p = 0 at the free surface, solved once on the
/// lattice of the particles. It goes into the depths of `fluid`, p / (rho g).
///
/// Water whose free faces all look up stays as it is: there the hydrostatic pressure is the solution. So do streams,
/// tanks that move, several sizes of particles, periodic sides, and blocks whose lattices do not fit together.
/// Returns the iterations that the solver took; 0: the pressure is hydrostatic.
int find_release_pressure(const SimulationSetup& setup, std::span<const Box> blocks, Fluid& fluid);

}  // namespace tw
