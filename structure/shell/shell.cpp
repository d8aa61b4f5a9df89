#include "structure/shell/shell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "structure/eigenvalues.h"

namespace tw::structure {

Shell::Shell(ShellMesh mesh, Laminate laminate, const Vec3& along)
    : mesh_(std::move(mesh)), laminate_(std::move(laminate)) {
    const int nodes = static_cast<int>(mesh_.nodes.size());
    mass_ = Eigen::VectorXd::Zero(6 * nodes);
    for (std::size_t e = 0; e < mesh_.quads.size(); ++e) {
        std::array<Vec3, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) {
            const int n = mesh_.quads[e][i];
            if (n < 0 || n >= nodes) throw InputError(fmt::format("shell element {}: node {} does not exist", e, n));
            corners[i] = mesh_.nodes[static_cast<std::size_t>(n)];
        }
        try {
            elements_.emplace_back(corners, along);
        } catch (const InputError& error) { throw InputError(fmt::format("shell element {}: {}", e, error.what())); }
        for (std::size_t i = 0; i < 4; ++i) {
            const double area = elements_.back().node_area()[static_cast<int>(i)];
            mass_.segment<3>(6 * mesh_.quads[e][i]).array() += area * laminate_.areal_mass();
            mass_.segment<3>(6 * mesh_.quads[e][i] + 3).array() += area * laminate_.rotary_inertia();
        }
    }
    for (int n = 0; n < nodes; ++n)
        if (!(mass_[6 * n] > 0)) throw InputError(fmt::format("node {} belongs to no shell element", n));
}

SparseMatrix Shell::stiffness() const {
    const auto section = laminate_.stiffness();
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(elements_.size() * 576);
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const Mitc4::Matrix24 K = elements_[e].stiffness(section);
        const auto& quad = mesh_.quads[e];
        for (int i = 0; i < 24; ++i)
            for (int j = 0; j < 24; ++j)
                entries.emplace_back(6 * quad[static_cast<std::size_t>(i / 6)] + i % 6,
                                     6 * quad[static_cast<std::size_t>(j / 6)] + j % 6, K(i, j));
    }
    SparseMatrix K(dofs(), dofs());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

Eigen::VectorXd Shell::pressure_load(const Eigen::VectorXd& pressure) const {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(dofs());
    for (std::size_t e = 0; e < elements_.size(); ++e)
        for (int i = 0; i < 4; ++i)
            f.segment<3>(6 * mesh_.quads[e][static_cast<std::size_t>(i)]) -=
                pressure[static_cast<int>(e)] * elements_[e].node_area()[i] * elements_[e].normal();
    return f;
}

Eigen::VectorXd Shell::weight(const Vec3& gravity) const {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(dofs());
    for (int n = 0; 6 * n < dofs(); ++n) f.segment<3>(6 * n) = mass_[6 * n] * gravity;
    return f;
}

Eigen::Matrix<double, 24, 1> Shell::of_element(const Eigen::VectorXd& all, int element) const {
    Eigen::Matrix<double, 24, 1> d;
    for (int i = 0; i < 4; ++i)
        d.segment<6>(6 * i) =
            all.segment<6>(6 * mesh_.quads[static_cast<std::size_t>(element)][static_cast<std::size_t>(i)]);
    return d;
}

double Shell::explicit_step() const {
    const auto section = laminate_.stiffness();
    double highest = 0;  // omega^2
    for (const Mitc4& element : elements_) {
        Eigen::Matrix<double, 24, 1> root;  // of the element's own lumped mass
        for (int i = 0; i < 4; ++i) {
            root.segment<3>(6 * i).setConstant(std::sqrt(element.node_area()[i] * laminate_.areal_mass()));
            root.segment<3>(6 * i + 3).setConstant(std::sqrt(element.node_area()[i] * laminate_.rotary_inertia()));
        }
        highest = std::max(highest, largest_eigenvalue(root.cwiseInverse().asDiagonal() * element.stiffness(section) *
                                                       root.cwiseInverse().asDiagonal()));
    }
    return 2 / std::sqrt(highest);
}

}  // namespace tw::structure
