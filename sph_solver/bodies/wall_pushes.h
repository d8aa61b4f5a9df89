#pragma once
#include <span>

#include "sph_solver/bodies/body.h"
#include "sph_solver/equations/vector.h"
#include "sph_solver/fields/particles.h"

namespace tw {

/// Lets bodies press on particles by a force of their own (Body::pressing), along the normal n of the surface:
///
///   a_i += F n / m
///
/// What the bodies get, which particle gives it, and what that gets [m/s2].
struct WallPushes {
    std::vector<WallPush> pushes;
    std::vector<std::int32_t> by;
    std::vector<V3<float>> accelerations;
};
/// Of the particles in `near`: MayBePressed (loops/pressed.h), in order.
WallPushes wall_pushes(const Bodies& bodies, const Particles& particles, std::span<const std::int32_t> near, double dp,
                       double mass);

}  // namespace tw
