#pragma once
#include <Eigen/SparseCholesky>
#include <string>

#include "structure/generate.h"
#include "structure/modes.h"
#include "structure/shell/shell.h"

namespace tw::structure {

/// A square plate of 1 m in z = 0.
inline Shell square_plate(int cells, Laminate laminate) {
    return Shell(plate_mesh(1, 1, cells, cells), std::move(laminate));
}

/// Supports of the edges x_min, y_min, x_max, y_max: C clamped, S simply supported (no deflection, and no rotation
/// along the edge), F free. Displacements in the plane are held: small bending of a flat, balanced plate has none.
inline DegreesOfFreedom supported(const Shell& plate, const std::string& edges) {
    DegreesOfFreedom f(plate.mesh().nodes, 6);
    std::vector<int> all(plate.mesh().nodes.size());
    for (std::size_t n = 0; n < all.size(); ++n) all[n] = static_cast<int>(n);
    f.hold(all, {0, 1, 5});
    const std::string names[] = {"x_min", "y_min", "x_max", "y_max"};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& nodes = plate.mesh().sets.at(names[k]);
        if (edges[k] == 'C') f.clamp(nodes);
        if (edges[k] == 'S') f.hold(nodes, {2, k % 2 == 0 ? 3 : 4});
    }
    return f;
}

/// K reduced to the unknowns, M likewise.
inline SparseMatrix reduced(const SparseMatrix& of, const SparseMatrix& basis) {
    return SparseMatrix(basis.transpose() * of * basis);
}

inline Eigen::VectorXd solved(const Shell& plate, const DegreesOfFreedom& dofs, const Eigen::VectorXd& load) {
    const SparseMatrix basis = dofs.basis();
    const Eigen::SimplicialLDLT<SparseMatrix> solver(reduced(plate.stiffness(), basis));
    return basis * solver.solve(basis.transpose() * load);
}

inline int nearest_node(const std::vector<Vec3>& nodes, const Vec3& to) {
    int best = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n)
        if ((nodes[n] - to).norm() < (nodes[static_cast<std::size_t>(best)] - to).norm()) best = static_cast<int>(n);
    return best;
}

}  // namespace tw::structure
