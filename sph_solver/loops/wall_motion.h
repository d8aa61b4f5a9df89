#pragma once
#include <cstddef>
#include <cstdint>

#include "sph_solver/equations/vector.h"
#include "sph_solver/sweeps/records.h"

namespace tw {

/// How the surface of a rigid body moves: u(x) = velocity + rotation x (x - centre).
struct WallMotion {
    V3<double> centre{}, velocity{}, rotation{};  ///< [m], [m/s], [rad/s]

    V3<double> at(const V3<double>& x) const { return velocity + cross(rotation, x - centre); }
};

inline V3<double> normal_of(const WallNormalRecord& n) { return {n.x, n.y, n.z}; }

/// The rigid walls that particles have near.
struct NearWalls {
    const WallNormalRecord* normal;
    const WallMotion* motions;  ///< of the bodies; null: all are at rest
    const std::uint16_t* body;  ///< whose wall it is

    /// Speed away from the wall that particle i, at x, has near, of one that moves with u, relative to that wall [m/s].
    double leaving(std::size_t i, const V3<double>& x, const V3<double>& u) const {
        const V3<double> n = normal_of(normal[i]);
        const double of_water = dot(u, n);
        return motions ? of_water - dot(motions[body[i]].at(x), n) : of_water;
    }
};

}  // namespace tw
