#include "meshes/surface.h"

#include <bit>
#include <cstdint>
#include <Eigen/Geometry>
#include <limits>
#include <unordered_map>

#include "base/errors.h"
#include "base/sha256.h"

namespace tw {

Box Surface::bounds() const {
    if (points.empty()) return {};
    Box box{points.front(), points.front()};
    for (const Vec3& p : points) {
        box.min = box.min.cwiseMin(p);
        box.max = box.max.cwiseMax(p);
    }
    return box;
}

Surface posed(const Surface& surface, const Pose& pose) {
    // x points aft and z up, so starboard is +y: starboard down is a turn of -heel about x; bow (-x) up is +trim about
    // y.
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(pose.trim, Vec3::UnitY()) * Eigen::AngleAxisd(-pose.heel, Vec3::UnitX())).toRotationMatrix();
    Surface result = surface;
    double lowest = std::numeric_limits<double>::infinity();
    for (Vec3& p : result.points) {
        p = turn * p;
        lowest = std::min(lowest, p.z());
    }
    if (result.points.empty()) return result;
    const Vec3 shift(pose.position.x(), pose.position.y(), -pose.draft - lowest);
    for (Vec3& p : result.points) p += shift;
    return result;
}

double metres_per(std::string_view unit) {
    if (unit == "m") return 1;
    if (unit == "mm") return 1e-3;
    if (unit == "cm") return 1e-2;
    if (unit == "ft") return 0.3048;
    if (unit == "in") return 0.0254;
    throw InputError("\"" + std::string(unit) + "\" is not a unit of length; known: m, mm, cm, ft, in");
}

std::string surface_hash(const Surface& surface) {
    std::string bytes;
    bytes.reserve(surface.triangles.size() * 72);
    for (const auto& triangle : surface.triangles)
        for (const int corner : triangle)
            for (const double coordinate : surface.points[static_cast<std::size_t>(corner)]) {
                const auto bits = std::bit_cast<std::uint64_t>(coordinate + 0.0);  // -0 becomes 0
                for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(bits >> shift & 0xff);
            }
    return sha256_hex(bytes);
}

Surface refined(const Surface& surface, double max_edge, std::size_t max_triangles) {
    if (!(max_edge > 0)) throw InputError("refining a surface needs a positive edge length");
    Surface fine = surface;
    for (bool split = true; split;) {
        split = false;
        std::unordered_map<std::uint64_t, int> middles;
        const auto middle = [&](int i, int j) {  // -1: short enough
            const Vec3 a = fine.points[static_cast<std::size_t>(i)], b = fine.points[static_cast<std::size_t>(j)];
            if (!((a - b).squaredNorm() > max_edge * max_edge)) return -1;
            const auto key =
                static_cast<std::uint64_t>(std::min(i, j)) << 32 | static_cast<std::uint64_t>(std::max(i, j));
            const auto [entry, fresh] = middles.try_emplace(key, static_cast<int>(fine.points.size()));
            if (fresh) fine.points.push_back(0.5 * (a + b));
            return entry->second;
        };
        std::vector<std::array<int, 3>> next;
        next.reserve(fine.triangles.size() * 2);
        for (const auto& t : fine.triangles) {
            const std::array<int, 3> m{middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
            const int halved = (m[0] >= 0) + (m[1] >= 0) + (m[2] >= 0);
            split = split || halved > 0;
            if (halved == 0) {
                next.push_back(t);
            } else if (halved == 3) {
                next.push_back({t[0], m[0], m[2]});
                next.push_back({t[1], m[1], m[0]});
                next.push_back({t[2], m[2], m[1]});
                next.push_back(m);
            } else {
                std::size_t k = 0;  // turn the triangle so that edge k is halved and, of two, edge k + 1 is the other
                while (m[k] < 0 || (halved == 2 && m[(k + 1) % 3] < 0)) ++k;
                const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], ab = m[k], bc = m[(k + 1) % 3];
                if (halved == 1) {
                    next.push_back({a, ab, c});
                    next.push_back({ab, b, c});
                } else {
                    next.push_back({ab, b, bc});
                    next.push_back({a, ab, bc});
                    next.push_back({a, bc, c});
                }
            }
        }
        if (next.size() > max_triangles)
            throw InputError("refining the surface to edges of " + std::to_string(max_edge) + " m takes more than " +
                             std::to_string(max_triangles) + " triangles; choose a longer edge");
        fine.triangles = std::move(next);
    }
    return fine;
}

}  // namespace tw
