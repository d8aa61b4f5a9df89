#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "meshes/surface.h"

namespace tw {
namespace {

struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
};
struct CellHash {
    std::size_t operator()(const Cell& c) const {
        // Large odd multipliers spread neighbouring cells (Teschner et al. 2003).
        return static_cast<std::size_t>(c.x) * 0x9E3779B97F4A7C15ull ^
               static_cast<std::size_t>(c.y) * 0xC2B2AE3D27D4EB4Full ^
               static_cast<std::size_t>(c.z) * 0x165667B19E3779F9ull;
    }
};
struct Same {
    bool operator()(const Vec3& a, const Vec3& b) const { return a == b; }
};
struct PointHash {
    std::size_t operator()(const Vec3& p) const {
        const std::hash<double> h;  // equal for 0 and -0
        return h(p.x()) * 0x9E3779B97F4A7C15ull ^ h(p.y()) * 0xC2B2AE3D27D4EB4Full ^ h(p.z()) * 0x165667B19E3779F9ull;
    }
};

/// For every point the point that stands for it: the first one equal to it.
std::vector<int> equal_points(const std::vector<Vec3>& points) {
    std::unordered_map<Vec3, int, PointHash, Same> first;
    first.reserve(points.size());
    std::vector<int> same(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        same[i] = first.try_emplace(points[i], static_cast<int>(i)).first->second;
    return same;
}

/// For every point the first one within the tolerance that stands for itself.
std::vector<int> close_points(const std::vector<Vec3>& points, double tolerance) {
    std::unordered_multimap<Cell, int, CellHash> cells;
    cells.reserve(points.size());
    std::vector<int> same(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 q = (points[i] / tolerance).array().floor();
        const Cell home{std::llround(q.x()), std::llround(q.y()), std::llround(q.z())};
        int found = -1;
        for (std::int64_t n = 0; n < 27 && found < 0; ++n) {
            const auto [begin, end] =
                cells.equal_range({home.x + n % 3 - 1, home.y + n / 3 % 3 - 1, home.z + n / 9 - 1});
            for (auto c = begin; c != end; ++c)
                if ((points[static_cast<std::size_t>(c->second)] - points[i]).squaredNorm() <= tolerance * tolerance)
                    found = c->second;
        }
        if (found < 0) cells.emplace(home, static_cast<int>(i));
        same[i] = found < 0 ? static_cast<int>(i) : found;
    }
    return same;
}

}  // namespace

Surface welded(const Surface& surface, double tolerance) {
    const std::vector<int> same =
        tolerance > 0 ? close_points(surface.points, tolerance) : equal_points(surface.points);
    std::vector<int> renumbered(surface.points.size(), -1);
    Surface result;
    result.triangles.reserve(surface.triangles.size());
    for (const auto& triangle : surface.triangles) {
        std::array<int, 3> t{};
        for (std::size_t k = 0; k < 3; ++k) t[k] = same[static_cast<std::size_t>(triangle[k])];
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        for (int& corner : t) {
            int& number = renumbered[static_cast<std::size_t>(corner)];
            if (number < 0) {
                number = static_cast<int>(result.points.size());
                result.points.push_back(surface.points[static_cast<std::size_t>(corner)]);
            }
            corner = number;
        }
        result.triangles.push_back(t);
    }
    return result;
}

}  // namespace tw
