#include "structure/shell/skin.h"

#include <fmt/format.h>

#include <map>

#include "base/errors.h"

namespace tw::structure {

Skin::Skin(const Shell& shell, double thickness) : dofs_(shell.dofs()) {
    if (!(thickness >= shell.laminate().thickness() * (1 - 1e-12)))
        throw InputError(fmt::format("a surface of {:.4g} m about a shell of {:.4g} m; expected no less", thickness,
                                     shell.laminate().thickness()));
    const auto& mesh = shell.mesh();
    const int nodes = static_cast<int>(mesh.nodes.size());
    std::vector<Vec3> normal(mesh.nodes.size(), Vec3::Zero());
    std::map<std::pair<int, int>, int> edges;  // how often each is run through in this direction
    for (std::size_t e = 0; e < mesh.quads.size(); ++e)
        for (std::size_t i = 0; i < 4; ++i) {
            const int a = mesh.quads[e][i], b = mesh.quads[e][(i + 1) % 4];
            normal[static_cast<std::size_t>(a)] += shell.elements()[e].normal() * shell.elements()[e].area();
            if (++edges[{a, b}] > 1)
                throw InputError(
                    fmt::format("the edge of nodes {} and {} belongs to more than two shell elements, or two "
                                "neighbours' normals are opposite",
                                a, b));
        }
    for (const double side : {1.0, -1.0})  // the points of the top, then those of the bottom
        for (int n = 0; n < nodes; ++n) {
            node_.push_back(n);
            arm_.push_back(side * thickness / 2 * normal[static_cast<std::size_t>(n)].normalized());
            surface_.points.push_back(mesh.nodes[static_cast<std::size_t>(n)] + arm_.back());
        }
    for (const auto& q : mesh.quads) {
        surface_.triangles.push_back({q[0], q[1], q[2]});
        surface_.triangles.push_back({q[0], q[2], q[3]});
        surface_.triangles.push_back({nodes + q[0], nodes + q[2], nodes + q[1]});
        surface_.triangles.push_back({nodes + q[0], nodes + q[3], nodes + q[2]});
    }
    for (const auto& [edge, count] : edges) {
        const auto [a, b] = edge;
        if (edges.contains({b, a})) continue;
        surface_.triangles.push_back({b, a, nodes + a});  // the rim
        surface_.triangles.push_back({b, nodes + a, nodes + b});
    }
}

Surface Skin::now(const Eigen::VectorXd& u) const {
    Surface s = surface_;
    for (std::size_t k = 0; k < node_.size(); ++k)
        s.points[k] += u.segment<3>(6 * node_[k]) + Vec3(u.segment<3>(6 * node_[k] + 3)).cross(arm_[k]);
    return s;
}

std::vector<Vec3> Skin::velocity(const Eigen::VectorXd& v) const {
    std::vector<Vec3> of(node_.size());
    for (std::size_t k = 0; k < node_.size(); ++k)
        of[k] = v.segment<3>(6 * node_[k]) + Vec3(v.segment<3>(6 * node_[k] + 3)).cross(arm_[k]);
    return of;
}

Eigen::VectorXd Skin::load(const std::vector<Vec3>& forces) const {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(dofs_);
    for (std::size_t k = 0; k < node_.size(); ++k) {
        f.segment<3>(6 * node_[k]) += forces[k];
        f.segment<3>(6 * node_[k] + 3) += arm_[k].cross(forces[k]);
    }
    return f;
}

std::vector<Vec3> Skin::forces(const Surface& now, const std::vector<double>& pressure) {
    std::vector<Vec3> on(now.points.size(), Vec3::Zero());
    for (std::size_t t = 0; t < now.triangles.size(); ++t)
        for (const int n : now.triangles[t])
            on[static_cast<std::size_t>(n)] -= pressure[t] / 6 * now.area_vector2(static_cast<int>(t));
    return on;
}

}  // namespace tw::structure
