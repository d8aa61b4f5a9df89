#pragma once
#include "structure/freedoms.h"

namespace tw::structure {

struct Modes {
    Eigen::VectorXd omega;   ///< angular frequencies, rising [rad/s]
    Eigen::MatrixXd shapes;  ///< one column each; M-orthonormal
};

/// The lowest modes of K x = omega^2 M x by subspace iteration (Bathe 1996, Finite Element Procedures, 11.6), K and M
/// symmetric, M positive definite, K with or without rigid motions. Throws RunError if it does not settle to 1e-10.
Modes lowest_modes(const SparseMatrix& K, const SparseMatrix& M, int count);

}  // namespace tw::structure
