#include "structure/modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "structure/eigenvalues.h"
#include "structure/shell/shell.h"
#include "structure/sparse_cholesky.h"

namespace tw::structure {

Modes lowest_modes(const SparseMatrix& K, const SparseMatrix& M, int count) {
    const int n = static_cast<int>(K.rows()), wanted = std::min(count, n), size = std::min(n, 2 * count + 8);
    // A small shift keeps rigid motions from making K singular; it is taken off again below.
    const double shift = 1e-9 * K.diagonal().sum() / M.diagonal().sum();
    const SparseCholesky solver(K + shift * M);
    if (!solver.factorised()) throw RunError("the stiffness of the structure cannot be factorised");

    Eigen::MatrixXd X(n, size);  // a fixed start, without symmetry: no mode is orthogonal to it
    unsigned state = 12345;
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < n; ++i) {
            state = 1664525u * state + 1013904223u;
            X(i, j) = state / 4294967296.0 - 0.5;
        }
    Eigen::VectorXd last = Eigen::VectorXd::Zero(size);
    for (int sweep = 0; sweep < 200; ++sweep) {
        const Eigen::MatrixXd Y = M * X;
        X = solver.solve_columns(Y);
        const Eigen::MatrixXd small_K = X.transpose() * Y, small_M = X.transpose() * (M * X);
        const EigenPairs ritz = generalised_eigenpairs(small_K, small_M);
        X = X * ritz.vectors;
        const Eigen::VectorXd& now = ritz.values;
        const double change = ((now - last).head(wanted).array() / now.head(wanted).array()).abs().maxCoeff();
        last = now;
        if (change < 1e-10) return {(now.head(wanted).array() - shift).max(0).sqrt().matrix(), X.leftCols(wanted)};
    }
    throw RunError("the modes of the structure did not converge in 200 iterations");
}

double first_period(const Shell& shell, const DegreesOfFreedom& dofs) {
    const SparseMatrix basis = dofs.basis();
    const SparseMatrix K = basis.transpose() * dofs.widened(shell.stiffness()) * basis,
                       M = basis.transpose() * dofs.mass(shell.mass()) * basis;
    constexpr int rigid = 6;  // motions at most, and one mode more
    const Modes modes = lowest_modes(K, M, std::min(rigid + 1, static_cast<int>(K.rows())));
    const double highest = modes.omega.maxCoeff();
    for (const double omega : modes.omega)
        if (omega > 1e-4 * highest) return 2 * std::numbers::pi / omega;
    throw RunError("the shell has no mode that strains it");
}

}  // namespace tw::structure
