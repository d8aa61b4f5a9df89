#pragma once
#include <string>
#include <vector>

#include "base/vec3.h"
#include "scene/scene.h"
#include "sph_solver/domain/extremes.h"
#include "sph_solver/equations/state_equation.h"

namespace tw {

/// One material on particles of one size, without the effects. SI units.
struct LevelSetup {
    std::string material = "water";             ///< in messages and files
    double dp = 0;                              ///< particle spacing [m]
    double h_over_dp = SphOptions{}.h_over_dp;  ///< [-]
    double rho0 = Water{}.density;              ///< [kg/m3]
    StateEquation state_equation;
    double delta = SphOptions{}.delta;        ///< density diffusion [-]
    double alpha = SphOptions{}.alpha;        ///< artificial viscosity [-]
    double shifting = SphOptions{}.shifting;  ///< A of equations/shifting.h [-]
    /// Shepard sum sum_j V_j W_ij (walls and images counted; 1 in the interior, about 0.75 at a flat free surface)
    /// below which a particle counts as free surface and bears no tension.
    double surface_support = 0.9;  ///< [-]
    /// How full the kernel's half towards a wall has to be for the wall to compress the water, see WallCompleteness.
    double touch_support = SphOptions{}.touch_support;  ///< [-]
    /// How fast density follows the particles' packing beside solids, k of Packing; 0 or no shifting: not at all.
    double packing = 0;  ///< [-]
    /// Shifting acts from this Shepard sum on; near the free surface only along it.
    double shifting_support = 0.95;  ///< [-]
    /// Inside the water (Shepard sum above `shifting_support`, no wall within reach) p_j - p_i in place of p_j + p_i
    /// where p_i < 0: no clumping under tension, but pairs no longer cancel there.
    bool tension_control = false;
    /// Fills what the other levels leave of the domain, under a lid: sampled pressures are relative to the lid's.
    bool shut_in = false;
    /// A run whose density leaves rho0 by more than these shares of it is stopped.
    double largest_compression = largest_density_deviation, largest_rarefaction = largest_density_deviation;
};

/// Initial particles: places and depth below the surface of their block [m]. Of several ranks the first one has them,
/// and the others know the volume alone.
struct Fluid {
    std::vector<Vec3> places;
    std::vector<double> depth;
    std::vector<Vec3> velocity = {};  ///< at the start [m/s]; empty: that of the surroundings
    double volume = 0;                ///< of one particle, mass over rho0 [m3; in two dimensions m2]; 0: dp^dimensions
};

}  // namespace tw
