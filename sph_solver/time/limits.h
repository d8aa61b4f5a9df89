#pragma once

namespace tw {

class Level;

/// Largest stable time step of one level [s]: the least of
///
///   cfl h / (c0 + |u|)        sound; stable in tanks to cfl = 1.5 with kick-drift-kick; u of water and walls
///   0.45 sqrt(h / a)          forces
///   0.25 h / (alpha c0)       artificial viscosity, 0.25 h^2 / (alpha h c0)
///
/// and of what each effect says of itself (Effect::largest_step).
double stable_step(const Level& level, double cfl);

}  // namespace tw
