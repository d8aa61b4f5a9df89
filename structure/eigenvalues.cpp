#include "structure/eigenvalues.h"

#include <Eigen/Eigenvalues>

#include "base/errors.h"

namespace tw::structure {

double largest_eigenvalue(const Eigen::MatrixXd& symmetric) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

EigenPairs generalised_eigenpairs(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> pairs(K, M);
    if (pairs.info() != Eigen::Success) throw RunError("the subspace of the modes has collapsed");
    return {pairs.eigenvalues(), pairs.eigenvectors()};
}

}  // namespace tw::structure
