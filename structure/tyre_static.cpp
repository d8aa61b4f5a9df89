#include "structure/tyre_static.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "structure/equilibrium.h"
#include "structure/solid/plane_contact.h"
#include "structure/solid/solid.h"

namespace tw::structure {
namespace {
using Eigen::VectorXd;

/// The number of a section's node, with how many sections there are.
int node_of(int section, int in_section, int sections) { return in_section * sections + section; }

/// All degrees of freedom of a sector of one cell by the radial and axial displacements of its section, the rim's left
/// out.
SparseMatrix alike_all_round(const SolidMesh& sector, double arc) {
    std::vector<Eigen::Triplet<double>> entries;
    const int nodes = static_cast<int>(sector.nodes.size()) / 2;
    const auto& rim = sector.sets.at("rim");
    int unknown = 0;
    for (int k = 0; k < nodes; ++k) {
        if (std::ranges::find(rim, node_of(0, k, 2)) != rim.end()) continue;
        for (int section = 0; section < 2; ++section) {
            const int n = node_of(section, k, 2);
            entries.emplace_back(3 * n, unknown, std::cos(-arc * section));
            entries.emplace_back(3 * n + 2, unknown, std::sin(-arc * section));
            entries.emplace_back(3 * n + 1, unknown + 1, 1);
        }
        unknown += 2;
    }
    SparseMatrix basis(6 * nodes, unknown);
    basis.setFromTriplets(entries.begin(), entries.end());
    return basis;
}

/// Radial and axial displacements of each node of the section.
std::vector<Eigen::Vector2d> blown_up_section(const Tyre& tyre, const std::vector<Hyperelastic>& rubbers,
                                              double pressure) {
    constexpr int parts = 8;  // of the pressure
    const Solid s(tyre_sector(tyre, 1, 0), rubbers);
    const SparseMatrix basis = alike_all_round(s.mesh(), 2 * std::numbers::pi / tyre.around);
    VectorXd u = VectorXd::Zero(s.dofs());
    for (int part = 1; part <= parts; ++part) {
        const double p = pressure * part / parts;
        u = equilibrium(
            u, basis,
            {[&](const VectorXd& at) -> VectorXd { return s.pressure_load(at, "inside", p) - s.internal_force(at); },
             [&](const VectorXd& at) -> SparseMatrix { return s.tangent(at) - s.pressure_tangent(at, "inside", p); }},
            1e-7);
    }
    std::vector<Eigen::Vector2d> section;
    for (int n = 0; 3 * n < s.dofs(); n += 2) section.emplace_back(u[3 * n], u[3 * n + 1]);
    return section;
}

/// The section's displacements at each of `sections` angles, from `from` on.
VectorXd turned(const std::vector<Eigen::Vector2d>& section, int sections, double from, double step) {
    VectorXd u(3 * sections * static_cast<int>(section.size()));
    for (int k = 0; k < static_cast<int>(section.size()); ++k)
        for (int i = 0; i < sections; ++i) {
            const Eigen::Vector2d& d = section[static_cast<std::size_t>(k)];
            const double theta = from - step * i;
            u.segment<3>(3 * node_of(i, k, sections)) = Vec3(d[0] * std::cos(theta), d[1], d[0] * std::sin(theta));
        }
    return u;
}

}  // namespace

VectorXd blown_up(const Tyre& tyre, const std::vector<Hyperelastic>& rubbers, double pressure) {
    return turned(blown_up_section(tyre, rubbers, pressure), tyre.around, 0, 2 * std::numbers::pi / tyre.around);
}

std::vector<Pressed> press(const Tyre& tyre, const std::vector<Hyperelastic>& rubbers, double pressure,
                           double contact_stiffness, const std::vector<double>& deflections) {
    const int cells = tyre.around / 2;
    const double bottom = -std::numbers::pi / 2;
    const Solid s(tyre_sector(tyre, cells, bottom), rubbers);
    VectorXd u = turned(blown_up_section(tyre, rubbers, pressure), cells + 1, bottom, std::numbers::pi / cells);
    DegreesOfFreedom dofs(s.mesh().nodes, 3);
    dofs.clamp(s.mesh().sets.at("rim"));
    for (const char* cut : {"begin", "end"}) dofs.hold(s.mesh().sets.at(cut), {0});
    const SparseMatrix basis = dofs.basis();
    double lowest = 0;
    for (int n = 0; 3 * n < s.dofs(); ++n)
        lowest = std::min(lowest, s.mesh().nodes[static_cast<std::size_t>(n)].z() + u[3 * n + 2]);
    PlaneContact plane(s, "outside", lowest, contact_stiffness);
    std::vector<Pressed> out;
    for (const double deflection : deflections) {
        plane.set_height(lowest + deflection);
        u = equilibrium(u, basis,
                        {[&](const VectorXd& at) -> VectorXd {
                             return s.pressure_load(at, "inside", pressure) + plane.force(at) - s.internal_force(at);
                         },
                         [&](const VectorXd& at) -> SparseMatrix {
                             return s.tangent(at) + plane.tangent(at) - s.pressure_tangent(at, "inside", pressure);
                         }},
                        1e-5);
        Pressed p{deflection, 2 * plane.total(u), 0};
        const VectorXd on = plane.force(u);
        for (int n = 0; 3 * n < s.dofs(); ++n)
            if (on[3 * n + 2] > 0)
                p.patch = std::max(p.patch, 2 * std::abs(s.mesh().nodes[static_cast<std::size_t>(n)].x() + u[3 * n]));
        out.push_back(p);
    }
    return out;
}

}  // namespace tw::structure
