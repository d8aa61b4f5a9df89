#include "meshes/query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "meshes/query/bvh.h"
#include "meshes/query/predicates.h"

namespace tw {
namespace {

/// Directions that decide on which side of an edge or corner a point lies: the sum of the two face normals at an edge,
/// the sum of face normals weighted by their angles at a corner (Baerentzen & Aanaes 2005, doi:10.1109/TVCG.2005.49).
struct PseudoNormals {
    std::vector<Vec3> face;                 ///< unit
    std::vector<std::array<Vec3, 3>> edge;  ///< of the edge from corner k to k + 1
    std::vector<Vec3> corner;               ///< by point of the surface
    std::vector<std::vector<int>> round;    ///< triangles that share a point
};

double angle_at(const Surface& s, int t, int k) {
    const Vec3 u = s.corner(t, (k + 1) % 3) - s.corner(t, k), v = s.corner(t, (k + 2) % 3) - s.corner(t, k);
    return std::atan2(u.cross(v).norm(), u.dot(v));
}

PseudoNormals pseudo_normals(const Surface& s) {
    PseudoNormals n;
    n.corner.assign(s.points.size(), Vec3::Zero());
    n.round.resize(s.points.size());
    std::unordered_map<std::uint64_t, Vec3> edges;
    const auto key = [](int i, int j) {
        return static_cast<std::uint64_t>(std::min(i, j)) << 32 | static_cast<std::uint64_t>(std::max(i, j));
    };
    const int count = static_cast<int>(s.triangles.size());
    edges.reserve(s.triangles.size() * 3 / 2);
    for (int t = 0; t < count; ++t) {
        const auto& corners = s.triangles[static_cast<std::size_t>(t)];
        const Vec3 unit = s.area_vector2(t).stableNormalized();
        n.face.push_back(unit);
        for (std::size_t k = 0; k < 3; ++k) {
            n.corner[static_cast<std::size_t>(corners[k])] += angle_at(s, t, static_cast<int>(k)) * unit;
            n.round[static_cast<std::size_t>(corners[k])].push_back(t);
            edges.try_emplace(key(corners[k], corners[(k + 1) % 3]), Vec3::Zero()).first->second += unit;
        }
    }
    for (const auto& corners : s.triangles) {
        auto& of_triangle = n.edge.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) of_triangle[k] = edges.at(key(corners[k], corners[(k + 1) % 3]));
    }
    return n;
}

}  // namespace

struct SurfaceQuery::Impl {
    Surface surface;
    Bvh bvh;
    PseudoNormals normals;
    double touching;  ///< below this distance a direction from the surface is rounding only [m]

    explicit Impl(const Surface& s) : surface(s), bvh(surface), normals(pseudo_normals(surface)) {
        const Box box = surface.bounds();
        touching =
            1e-14 * std::max(box.size().norm(), std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff()));
    }

    struct Hit {
        double distance2;
        int triangle = -1;
        NearestOnTriangle on{Vec3::Zero(), Feature::face};
    };
    /// `guess`: a triangle likely to be near, which only makes the search shorter; -1: none.
    Hit nearest(const Vec3& p, double reach, int guess) const {
        Hit hit{std::min(reach * reach, 1e300)};
        const auto consider = [&](int triangle, const Vec3& a, const Vec3& b, const Vec3& c) {
            const NearestOnTriangle on = nearest_on_triangle(p, a, b, c);
            const double distance2 = (p - on.point).squaredNorm();
            if (distance2 < hit.distance2) hit = {distance2, triangle, on};
        };
        if (guess >= 0) consider(guess, surface.corner(guess, 0), surface.corner(guess, 1), surface.corner(guess, 2));
        bvh.visit_nearest(p, hit.distance2, [&](const Bvh::Corners& t) {
            consider(t.triangle, t.a, t.b, t.c);
            return hit.distance2;
        });
        return hit;
    }

    Vec3 pseudo_normal(const Hit& hit) const {
        const auto t = static_cast<std::size_t>(hit.triangle);
        switch (hit.on.feature) {
            case Feature::face: return normals.face[t];
            case Feature::edge0: return normals.edge[t][0];
            case Feature::edge1: return normals.edge[t][1];
            case Feature::edge2: return normals.edge[t][2];
            case Feature::corner0: return normals.corner[static_cast<std::size_t>(surface.triangles[t][0])];
            case Feature::corner1: return normals.corner[static_cast<std::size_t>(surface.triangles[t][1])];
            case Feature::corner2: return normals.corner[static_cast<std::size_t>(surface.triangles[t][2])];
        }
        return normals.face[t];
    }

    double sign(const Vec3& p, const Hit& hit) const {
        return (p - hit.on.point).dot(pseudo_normal(hit)) < 0 ? -1.0 : 1.0;
    }

    bool inside(const Vec3& p) const {
        int winding = 0;
        bvh.visit(
            [&](const Box& box) {
                return p.x() >= box.min.x() && p.x() <= box.max.x() && p.y() >= box.min.y() && p.y() <= box.max.y() &&
                       p.z() <= box.max.z();
            },
            [&](const Bvh::Corners& t) {
                winding += crossing_above(t.a, t.b, t.c, p);
                return true;
            });
        return winding > 0;
    }
};

SurfaceQuery::SurfaceQuery(const Surface& surface) : impl_(std::make_unique<Impl>(surface)) {}
SurfaceQuery::~SurfaceQuery() = default;
SurfaceQuery::SurfaceQuery(SurfaceQuery&&) noexcept = default;

SurfaceQuery::Nearest SurfaceQuery::nearest(const Vec3& p, double reach) const {
    const Impl::Hit hit = impl_->nearest(p, reach, -1);
    if (hit.triangle < 0) return {p, -1, impl_->inside(p) ? -reach : reach, Vec3::Zero()};
    Nearest result{hit.on.point, hit.triangle, impl_->sign(p, hit) * std::sqrt(hit.distance2), Vec3::Zero()};
    result.normal = std::abs(result.distance) > impl_->touching ? Vec3((p - hit.on.point) / result.distance)
                                                                : Vec3(impl_->pseudo_normal(hit).stableNormalized());
    result.feature = static_cast<int>(hit.on.feature);
    return result;
}

std::vector<Vec3> SurfaceQuery::faces_at(const Nearest& nearest) const {
    if (nearest.triangle < 0) return {};
    const PseudoNormals& n = impl_->normals;
    const auto t = static_cast<std::size_t>(nearest.triangle);
    if (nearest.on_face()) return {n.face[t]};
    if (nearest.feature <= 3) return {n.face[t], n.edge[t][static_cast<std::size_t>(nearest.feature - 1)] - n.face[t]};
    std::vector<Vec3> faces;
    const int corner = impl_->surface.triangles[t][static_cast<std::size_t>(nearest.feature - 4)];
    for (const int other : n.round[static_cast<std::size_t>(corner)])
        faces.push_back(n.face[static_cast<std::size_t>(other)]);
    return faces;
}

bool SurfaceQuery::inside(const Vec3& p) const { return impl_->inside(p); }

void SurfaceQuery::signed_distances(std::span<const Vec3> points, std::span<double> out, double reach) const {
    const auto n = static_cast<std::ptrdiff_t>(std::min(points.size(), out.size()));
    int guess = -1;  // neighbours in the list are mostly neighbours in space
#pragma omp parallel for schedule(dynamic, 4096) firstprivate(guess)
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const Vec3& p = points[static_cast<std::size_t>(i)];
        const Impl::Hit hit = impl_->nearest(p, reach, guess);
        if (hit.triangle >= 0) guess = hit.triangle;
        out[static_cast<std::size_t>(i)] = hit.triangle >= 0  ? impl_->sign(p, hit) * std::sqrt(hit.distance2)
                                           : impl_->inside(p) ? -reach
                                                              : reach;
    }
}

bool SurfaceQuery::crosses(const Vec3& a, const Vec3& b) const {
    const Vec3 d = b - a;
    const Vec3 inverse = d.cwiseInverse();
    bool met = false;
    impl_->bvh.visit([&](const Box& box) { return Bvh::meets(box, a, inverse, 1.0); },
                     [&](const Bvh::Corners& t) { return !(met = segment_meets_triangle(a, b, t.a, t.b, t.c)); });
    return met;
}

double SurfaceQuery::thickness(int triangle) const { return opposite_side(triangle).distance; }

SurfaceQuery::Opposite SurfaceQuery::opposite_side(int triangle) const {
    const Surface& s = impl_->surface;
    return opposite_side(triangle, (s.corner(triangle, 0) + s.corner(triangle, 1) + s.corner(triangle, 2)) / 3);
}

SurfaceQuery::Opposite SurfaceQuery::opposite_side(int triangle, const Vec3& origin) const {
    const Vec3 direction = -impl_->normals.face[static_cast<std::size_t>(triangle)];
    const Vec3 inverse = direction.cwiseInverse();
    Opposite nearest{std::numeric_limits<double>::infinity(), -1};
    impl_->bvh.visit([&](const Box& box) { return Bvh::meets(box, origin, inverse, nearest.distance); },
                     [&](const Bvh::Corners& t) {
                         if (t.triangle == triangle) return true;
                         const double distance = ray_distance(origin, direction, t.a, t.b, t.c);
                         if (distance >= 0 && distance < nearest.distance) nearest = {distance, t.triangle};
                         return true;
                     });
    return nearest;
}

}  // namespace tw
