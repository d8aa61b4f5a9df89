#include "structure/degrees_of_freedom.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"

namespace tw::structure {
using Triplets = std::vector<Eigen::Triplet<double>>;

DegreesOfFreedom::DegreesOfFreedom(const std::vector<Vec3>& nodes, int per_node)
    : nodes_(nodes),
      per_node_(per_node),
      held_(nodes.size() * static_cast<std::size_t>(per_node)),
      carrier_(nodes.size(), -1) {}

void DegreesOfFreedom::hold(std::span<const int> nodes, std::initializer_list<int> which) {
    for (const int n : nodes)
        for (const int d : which) {
            if (n < 0 || n >= static_cast<int>(nodes_.size()) || d < 0 || d >= per_node_)
                throw InputError(fmt::format(
                    "a support of degree of freedom {} of node {}; there are {} nodes of {} degrees of freedom", d, n,
                    nodes_.size(), per_node_));
            held_[static_cast<std::size_t>(per_node_ * n + d)] = true;
        }
}

void DegreesOfFreedom::clamp(std::span<const int> nodes) {
    hinge(nodes);
    if (per_node_ == 6) hold(nodes, {3, 4, 5});
}

void DegreesOfFreedom::hinge(std::span<const int> nodes) { hold(nodes, {0, 1, 2}); }

int DegreesOfFreedom::carry(RigidPart part) {
    const int number = static_cast<int>(parts_.size());
    if (!(std::isfinite(part.mass) && part.mass >= 0))
        throw InputError(fmt::format("rigid part {}: mass {} kg; expected 0 or more", number + 1, part.mass));
    if (part.nodes.empty()) throw InputError(fmt::format("rigid part {} carries no node", number + 1));
    for (const int n : part.nodes) {
        if (n < 0 || n >= static_cast<int>(nodes_.size()))
            throw InputError(
                fmt::format("rigid part {} carries node {}; there are {} nodes", number + 1, n, nodes_.size()));
        int& carrier = carrier_[static_cast<std::size_t>(n)];
        if (carrier != -1)
            throw InputError(
                fmt::format("node {} is carried by two rigid parts, {} and {}", n, carrier + 1, number + 1));
        carrier = number;
    }
    parts_.push_back(std::move(part));
    return number;
}

SparseMatrix DegreesOfFreedom::basis() const {
    Triplets entries;
    int unknowns = 0;
    std::vector<std::array<int, 6>> of_part(parts_.size());  // the unknown of each degree of freedom; -1 held
    for (std::size_t p = 0; p < parts_.size(); ++p)
        for (int d = 0; d < per_node_; ++d) {
            const bool held = parts_[p].held[static_cast<std::size_t>(d)];
            of_part[p][static_cast<std::size_t>(d)] = held ? -1 : unknowns;
            if (!held) entries.emplace_back(first_of_part(static_cast<int>(p)) + d, unknowns++, 1);
        }
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const int carrier = carrier_[n];
        const RigidPart* part = carrier < 0 ? nullptr : &parts_[static_cast<std::size_t>(carrier)];
        for (int d = 0; d < per_node_; ++d) {
            const int row = per_node_ * static_cast<int>(n) + d;
            if (held_[static_cast<std::size_t>(row)]) continue;
            if (!part || (part->hinged && d >= 3)) {
                entries.emplace_back(row, unknowns++, 1);
                continue;
            }
            const auto add = [&](int of, double factor) {
                const int column = of_part[static_cast<std::size_t>(carrier)][static_cast<std::size_t>(of)];
                if (column >= 0 && factor != 0) entries.emplace_back(row, column, factor);
            };
            add(d, 1);
            if (d >= 3 || per_node_ == 3) continue;
            const Vec3 r = nodes_[n] - part->centre;  // u = u_c + theta x r
            for (int k = 0; k < 3; ++k) add(3 + k, Vec3::Unit(k).cross(r)[d]);
        }
    }
    if (unknowns == 0) throw InputError("every degree of freedom of the structure is held; nothing is left to move");
    SparseMatrix T(all(), unknowns);
    T.setFromTriplets(entries.begin(), entries.end());
    return T;
}

Eigen::VectorXd DegreesOfFreedom::translation(const Vec3& v) const {
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(all());
    for (int first = 0; first < all(); first += per_node_) moved.segment<3>(first) = v;
    return moved;
}

Eigen::VectorXd DegreesOfFreedom::widened(const Eigen::VectorXd& of_nodes) const {
    Eigen::VectorXd wide = Eigen::VectorXd::Zero(all());
    wide.head(of_nodes.size()) = of_nodes;
    return wide;
}

SparseMatrix DegreesOfFreedom::widened(const SparseMatrix& of_nodes) const {
    SparseMatrix wide = of_nodes;
    wide.conservativeResize(all(), all());
    return wide;
}

SparseMatrix DegreesOfFreedom::mass(const Eigen::VectorXd& of_nodes) const {
    Triplets entries;
    for (int i = 0; i < static_cast<int>(of_nodes.size()); ++i) entries.emplace_back(i, i, of_nodes[i]);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        const int first = first_of_part(static_cast<int>(p));
        for (int d = 0; d < 3; ++d) entries.emplace_back(first + d, first + d, parts_[p].mass);
        if (per_node_ == 3) continue;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) entries.emplace_back(first + 3 + i, first + 3 + j, parts_[p].inertia(i, j));
    }
    SparseMatrix M(all(), all());
    M.setFromTriplets(entries.begin(), entries.end());
    return M;
}

}  // namespace tw::structure
