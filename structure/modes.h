#pragma once
#include "structure/degrees_of_freedom.h"

namespace tw::structure {
class Shell;

struct Modes {
    Eigen::VectorXd omega;   ///< angular frequencies, rising [rad/s]
    Eigen::MatrixXd shapes;  ///< one column each; M-orthonormal
};

/// The lowest modes of K x = omega^2 M x by subspace iteration (Bathe 1996, Finite Element Procedures, 11.6), K and M
/// symmetric, M positive definite, K with or without rigid motions. Throws RunError if it does not settle to 1e-10.
Modes lowest_modes(const SparseMatrix& K, const SparseMatrix& M, int count);

/// Period of the lowest mode of a shell that strains it, with what holds and carries it, in vacuum [s].
double first_period(const Shell& shell, const DegreesOfFreedom& dofs);

}  // namespace tw::structure
