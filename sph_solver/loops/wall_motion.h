#pragma once
#include <cstddef>
#include <cstdint>

#include "sph_solver/equations/vector.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// How the surface of a rigid body moves: u(x) = velocity + rotation x (x - centre).
struct WallMotion {
    V3<double> centre{}, velocity{}, rotation{};  ///< [m], [m/s], [rad/s]

    V3<double> at(const V3<double>& x) const { return velocity + cross(rotation, x - centre); }
};

/// Shares of a triangle's corners a, b, c in the place of it that is nearest to `x` but for its edges.
inline V3<double> corner_shares(const V3<double>& a, const V3<double>& b, const V3<double>& c, const V3<double>& x) {
    const V3<double> p = b - a, q = c - a, r = x - a;
    const double pp = dot(p, p), qq = dot(q, q), pq = dot(p, q), det = pp * qq - pq * pq;
    if (!(det > 0)) return {1. / 3, 1. / 3, 1. / 3};
    const auto clamped = [](double share, double most) { return share < 0 ? 0 : most < share ? most : share; };
    const double of_b = clamped((qq * dot(p, r) - pq * dot(q, r)) / det, 1),
                 of_c = clamped((pp * dot(q, r) - pq * dot(p, r)) / det, 1 - of_b);
    return {1 - of_b - of_c, of_b, of_c};
}

/// The corners of a triangle, as indices of points.
struct Corners {
    std::int32_t a, b, c;
};

/// How the surface of a body that deforms moves: on each triangle between its corners.
struct SurfaceMotion {
    const Corners* corners;      ///< of each triangle; null: the body is rigid
    const V3<double>* noted;     ///< its points as they stood when the surface was noted last [m]
    const V3<double>* velocity;  ///< of its points now [m/s]

    V3<double> shares(std::int32_t triangle, const V3<double>& x) const {
        const Corners& k = corners[triangle];
        return corner_shares(noted[k.a], noted[k.b], noted[k.c], x);
    }
    /// By the place x on or near a triangle; zero where there is none (-1).
    V3<double> at(std::int32_t triangle, const V3<double>& x) const {
        V3<double> v{0, 0, 0};
        if (triangle < 0) return v;
        const Corners& k = corners[triangle];
        const V3<double> share = shares(triangle, x);
        v += share.x * velocity[k.a];
        v += share.y * velocity[k.b];
        v += share.z * velocity[k.c];
        return v;
    }
};

inline V3<double> normal_of(const PackedWallNormal& n) { return {n.x, n.y, n.z}; }

/// The walls that particles have near.
struct NearWalls {
    const PackedWallNormal* normal;
    const WallMotion* motions;  ///< of the bodies; null: all are at rest
    const std::uint16_t* body;  ///< whose wall it is
    // null where no body is deformable
    const std::int32_t* triangle;  ///< of that body's surface
    const SurfaceMotion* surfaces;  ///< of the bodies

    /// Speed away from the wall that particle i, at x, has near, of one that moves with u, relative to that wall [m/s].
    double leaving(std::size_t i, const V3<double>& x, const V3<double>& u) const {
        const V3<double> n = normal_of(normal[i]);
        const double of_water = dot(u, n);
        return motions ? of_water - dot(velocity_of_wall(i, x), n) : of_water;
    }

private:
    V3<double> velocity_of_wall(std::size_t i, const V3<double>& x) const {
        const std::uint16_t of = body[i];
        return surfaces && surfaces[of].corners ? surfaces[of].at(triangle[i], x) : motions[of].at(x);
    }
};

}  // namespace tw
