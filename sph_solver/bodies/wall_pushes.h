#pragma once
#include "sph_solver/bodies/body.h"
#include "sph_solver/fields/particles.h"

namespace tw {

/// Lets bodies press on particles by a force of their own (Body::pressing), along the normal n of the surface:
///
///   a_i += F n / m
///
/// Only bodies nearer than a spacing. Adds to the particles' rates, and gives what the bodies get, and which particle
/// gives it.
struct WallPushes {
    std::vector<WallPush> pushes;
    std::vector<std::size_t> by;
};
WallPushes add_wall_pushes(const Bodies& bodies, Particles& particles, double dp, double mass);

}  // namespace tw
