#pragma once
#include <memory>

#include "structure/degrees_of_freedom.h"

namespace tw::structure {

/// The factors L D L^T of a symmetric sparse matrix, by Eigen, whose templates are compiled in one file: they take
/// longer than all else of this room.
class SparseCholesky {
public:
    SparseCholesky();
    explicit SparseCholesky(const SparseMatrix& A);
    SparseCholesky(SparseCholesky&&) noexcept;
    SparseCholesky& operator=(SparseCholesky&&) noexcept;
    ~SparseCholesky();

    void factorise(const SparseMatrix& A);
    bool factorised() const;
    bool positive_definite() const;
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& B) const;

private:
    struct Factors;
    std::unique_ptr<Factors> factors_;
};

}  // namespace tw::structure
