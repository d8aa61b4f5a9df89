#pragma once
#include "sph_solver/bodies/walls.h"
#include "sph_solver/particles/particles.h"
#include "sph_solver/particles/records.h"

namespace tw {

/// Penalty contact of particles with elastic bodies that ask for it, as codes of crash analysis couple SPH and finite
/// elements (Jian & Wu's study, eq. 7: F_i = SLFACM STF g_i). A particle that is nearer to the surface than
/// `Coupling::reach` by g is pushed along the surface's normal n with the force F(g), and the surface back:
///
///   a_i += F(g) n / m,   g = reach - distance
///
/// Adds to the particles' rates, and gives what the bodies get.
std::vector<WallPush> add_penalty_contact(const std::vector<Body>& bodies, const Particles& particles, Records& records,
                                          double dp, double mass);

}  // namespace tw
