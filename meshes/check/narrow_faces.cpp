#include "meshes/check/narrow_faces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshes/check/edges.h"

namespace tw {
namespace {

constexpr double cos_dullest = 0.8660254037844387;  // 30 degrees between the normals, as in shedding_edges.cpp
constexpr double least_ratio = 4;                   // of length to width

/// The number of each triangle's part.
class SmoothParts {
public:
    explicit SmoothParts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    int of(int triangle) {
        while (parent(triangle) != triangle) triangle = parent(triangle) = parent(parent(triangle));
        return triangle;
    }
    void join(int a, int b) { parent(of(a)) = of(b); }

private:
    int& parent(int triangle) { return parent_[static_cast<std::size_t>(triangle)]; }
    std::vector<int> parent_;
};

}  // namespace

std::vector<NarrowFace> narrow_faces(const Surface& s, const Box& within, double width) {
    const std::size_t count = s.triangles.size();
    const Edges edges = find_edges(s);
    SmoothParts parts(count);
    std::vector<Vec3> normal(count);
    for (std::size_t t = 0; t < count; ++t) normal[t] = s.area_vector2(static_cast<int>(t)).normalized();
    const auto dull = [&](const Edge& e) {
        return e.count() == 2 && !edges.flipped(e) &&
               normal[static_cast<std::size_t>(edges.uses[e.begin].triangle)].dot(
                   normal[static_cast<std::size_t>(edges.uses[e.begin + 1].triangle)]) > cos_dullest;
    };
    for (const Edge& e : edges.edges)
        if (dull(e)) parts.join(edges.uses[e.begin].triangle, edges.uses[e.begin + 1].triangle);
    std::vector<double> area(count, 0), perimeter(count, 0);
    std::vector<Vec3> moment(count, Vec3::Zero());
    for (std::size_t t = 0; t < count; ++t) {
        const auto part = static_cast<std::size_t>(parts.of(static_cast<int>(t)));
        const auto k = static_cast<int>(t);
        const double own = 0.5 * s.area_vector2(k).norm();
        area[part] += own;
        moment[part] += own / 3 * (s.corner(k, 0) + s.corner(k, 1) + s.corner(k, 2));
    }
    for (const Edge& e : edges.edges) {
        if (dull(e)) continue;
        const double length = (s.points[static_cast<std::size_t>(edges.uses[e.begin].low)] -
                               s.points[static_cast<std::size_t>(edges.uses[e.begin].high)])
                                  .norm();
        for (std::size_t use = e.begin; use < e.end; ++use)
            perimeter[static_cast<std::size_t>(parts.of(edges.uses[use].triangle))] += length;
    }
    std::vector<NarrowFace> narrow;
    for (std::size_t part = 0; part < count; ++part) {
        const double A = area[part], P = perimeter[part];
        if (!(A > 0) || !(P * P > 16 * A)) continue;
        const double w = (P - std::sqrt(P * P - 16 * A)) / 4, length = A / w;
        const Vec3 middle = moment[part] / A;
        if (w < width && length >= least_ratio * w && within.contains(middle)) narrow.push_back({w, length, middle});
    }
    std::ranges::sort(narrow, {}, &NarrowFace::width);
    return narrow;
}

}  // namespace tw
