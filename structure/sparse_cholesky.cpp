#include "structure/sparse_cholesky.h"

#include <Eigen/SparseCholesky>

namespace tw::structure {

struct SparseCholesky::Factors : Eigen::SimplicialLDLT<SparseMatrix> {};

SparseCholesky::SparseCholesky() : factors_(std::make_unique<Factors>()) {}
SparseCholesky::SparseCholesky(const SparseMatrix& A) : SparseCholesky() { factorise(A); }
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;
SparseCholesky::~SparseCholesky() = default;

void SparseCholesky::factorise(const SparseMatrix& A) { factors_->compute(A); }
bool SparseCholesky::factorised() const { return factors_->info() == Eigen::Success; }
bool SparseCholesky::positive_definite() const { return factorised() && factors_->vectorD().minCoeff() > 0; }
Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& b) const { return factors_->solve(b); }
Eigen::MatrixXd SparseCholesky::solve_columns(const Eigen::MatrixXd& B) const { return factors_->solve(B); }

}  // namespace tw::structure
