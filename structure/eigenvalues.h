#pragma once
#include <Eigen/Core>

namespace tw::structure {

/// Of full matrices, in one file: Eigen's templates for them take compilers long.

/// The largest eigenvalue of a symmetric matrix, in the matrix's unit.
double largest_eigenvalue(const Eigen::MatrixXd& symmetric);

/// K x = value M x, for symmetric K and positive definite M: ascending values, vectors as columns with x^T M x = 1.
struct EigenPairs {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};
/// Throws RunError if M is not positive definite.
EigenPairs generalised_eigenpairs(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M);

}  // namespace tw::structure
