#pragma once
#include <span>
#include <vector>

#include "sph_solver/simulation.h"

namespace tw {

/// Pressure with which the water of the blocks begins: that of the incompressible problem at rest, laplace p = 0, dp/dn
/// = rho f.n at walls and solids, p = 0 at the free surface (f: gravity, less the acceleration of a tank that moves).
/// It goes into the depths of the `fluids`, p / (rho g), of every size of particles.
///
/// Blocks that touch are one water (base/disjoint_boxes.h, scene/water/water_grid.h). Of each part of it that is
/// connected the pressure is hydrostatic below its level where all its free surface looks up and is at one level, and
/// where it has no free surface, with p = 0 at its top. Elsewhere (a side is let go, two levels communicate, the tank
/// is shaken) it is found by finite volumes, once. Streams, periodic sides and water without weight keep the depths
/// that they have. Bodies that move count as if they were held. Returns the iterations that this took; 0: all of it is
/// hydrostatic.
int find_start_pressure(const SimulationSetup& setup, std::span<const Box> blocks, std::span<Fluid> fluids);

}  // namespace tw
