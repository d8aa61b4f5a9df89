#include "structure/solid/wet_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <map>

#include "base/errors.h"

namespace tw::structure {
namespace {
constexpr double corner_xi[] = {-1, 1, 1, -1}, corner_eta[] = {-1, -1, 1, 1};

std::array<double, 4> shares_at(const Eigen::Vector2d& at) {
    std::array<double, 4> N{};
    for (std::size_t i = 0; i < 4; ++i) N[i] = (1 + corner_xi[i] * at[0]) * (1 + corner_eta[i] * at[1]) / 4;
    return N;
}

/// The place within a bilinear quadrilateral nearest to `p`, by Gauss and Newton's steps kept within it.
Eigen::Vector2d nearest_within(const std::array<Vec3, 4>& x, const Vec3& p) {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    for (int iteration = 0; iteration < 20; ++iteration) {
        const std::array<double, 4> N = shares_at(at);
        Vec3 off = p;
        Eigen::Matrix<double, 3, 2> by = Eigen::Matrix<double, 3, 2>::Zero();
        for (std::size_t i = 0; i < 4; ++i) {
            off -= N[i] * x[i];
            by.col(0) += corner_xi[i] * (1 + corner_eta[i] * at[1]) / 4 * x[i];
            by.col(1) += corner_eta[i] * (1 + corner_xi[i] * at[0]) / 4 * x[i];
        }
        const Eigen::Matrix2d normal = by.transpose() * by;
        Eigen::Vector2d to = at + normal.inverse() * (by.transpose() * off);
        for (int k = 0; k < 2; ++k)  // along an edge the step is that of the edge alone
            if (std::abs(to[k]) > 1) {
                to[k] = std::clamp(to[k], -1.0, 1.0);
                const int other = 1 - k;
                to[other] = at[other] + by.col(other).dot(off - (to[k] - at[k]) * by.col(k)) / normal(other, other);
            }
        to = to.cwiseMax(-1).cwiseMin(1);
        const double moved = (to - at).norm();
        at = to;
        if (moved < 1e-12) break;
    }
    return at;
}
}  // namespace

WetSurface::WetSurface(const Solid& solid, const std::string& name, const Eigen::VectorXd& start)
    : start_(solid.mesh().nodes), towards_(start_.size(), -1), areas_(start_.size(), 0.0) {
    const auto found = solid.mesh().surfaces.find(name);
    if (found == solid.mesh().surfaces.end())
        throw InputError(fmt::format("the mesh has no surface named \"{}\"", name));
    faces_ = found->second;
    for (std::size_t n = 0; n < start_.size(); ++n) start_[n] += start.segment<3>(static_cast<Eigen::Index>(3 * n));
    for (std::size_t f = 0; f < faces_.size(); ++f)
        for (std::size_t i = 0; i < 4; ++i) {
            const auto n = static_cast<std::size_t>(faces_[f][i]);
            if (towards_[n] < 0) towards_[n] = faces_[f][(i + 1) % 4];
            const Vec3 to = corner(start_, f, (i + 1) % 4) - start_[n],
                       from = corner(start_, f, (i + 3) % 4) - start_[n];
            areas_[n] += to.cross(from).norm() / 4;
        }
    close();
    frames_ = frames(start_);
}

/// Two triangles a face, then each opening's edges, run through backwards, with the middle of the opening.
void WetSurface::close() {
    std::map<int, std::size_t> point;  // of the surface by node
    const auto point_of = [&](int node) {
        const auto [at, is_new] = point.emplace(node, closed_.points.size());
        if (is_new) closed_.points.push_back(start_[static_cast<std::size_t>(node)]);
        return static_cast<int>(at->second);
    };
    std::map<int, int> open;  // each node's next along an edge without a neighbour
    std::map<std::pair<int, int>, int> edges;
    for (const auto& q : faces_) {
        closed_.triangles.push_back({point_of(q[0]), point_of(q[1]), point_of(q[2])});
        closed_.triangles.push_back({point_of(q[0]), point_of(q[2]), point_of(q[3])});
        for (std::size_t i = 0; i < 4; ++i) ++edges[{q[i], q[(i + 1) % 4]}];
    }
    query_ = std::make_unique<SurfaceQuery>(closed_);
    for (const auto& [edge, count] : edges)
        if (!edges.contains({edge.second, edge.first})) open[edge.second] = edge.first;
    while (!open.empty()) {
        std::vector<int> ring;
        for (auto at = open.begin(); at != open.end(); at = open.find(ring.back())) {
            if (ring.empty()) ring.push_back(at->first);
            const int next = at->second;
            open.erase(at);
            if (next == ring.front()) break;
            ring.push_back(next);
        }
        Vec3 middle = Vec3::Zero();
        for (const int n : ring) middle += start_[static_cast<std::size_t>(n)] / static_cast<double>(ring.size());
        const auto centre = static_cast<int>(closed_.points.size());
        closed_.points.push_back(middle);
        for (std::size_t k = 0; k < ring.size(); ++k)
            closed_.triangles.push_back({point_of(ring[k]), point_of(ring[(k + 1) % ring.size()]), centre});
    }
}

WetSurface::Foot WetSurface::foot(const Vec3& at_start) const {
    const auto face = static_cast<std::size_t>(query_->nearest(at_start).triangle / 2);
    std::array<Vec3, 4> x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = corner(start_, face, i);
    Foot foot;
    foot.nodes = faces_[face];
    foot.shares = shares_at(nearest_within(x, at_start));
    foot.arm = at_start;
    for (std::size_t i = 0; i < 4; ++i) foot.arm -= foot.shares[i] * x[i];
    return foot;
}

std::vector<Eigen::Matrix3d> WetSurface::frames(const std::vector<Vec3>& x) const {
    std::vector<Vec3> normal(x.size(), Vec3::Zero());
    for (std::size_t f = 0; f < faces_.size(); ++f)
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 at = corner(x, f, i);
            normal[static_cast<std::size_t>(faces_[f][i])] +=
                (corner(x, f, (i + 1) % 4) - at).cross(corner(x, f, (i + 3) % 4) - at);
        }
    std::vector<Eigen::Matrix3d> frames(x.size(), Eigen::Matrix3d::Identity());
    for (std::size_t n = 0; n < x.size(); ++n) {
        if (towards_[n] < 0) continue;
        const Vec3 out = normal[n].normalized(), edge = x[static_cast<std::size_t>(towards_[n])] - x[n];
        frames[n].col(0) = out;
        frames[n].col(1) = (edge - edge.dot(out) * out).normalized();
        frames[n].col(2) = frames[n].col(0).cross(frames[n].col(1));
    }
    return frames;
}

std::vector<Eigen::Matrix3d> WetSurface::turns(const std::vector<Vec3>& x) const {
    std::vector<Eigen::Matrix3d> turns = frames(x);
    for (std::size_t n = 0; n < turns.size(); ++n) turns[n] = turns[n] * frames_[n].transpose();
    return turns;
}

}  // namespace tw::structure
