#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/SparseCore>

namespace tw {

/// Approximate inverse of the matrix of a Laplace problem on the cells of a lattice, for conjugate gradients
/// (Eigen's Preconditioner): one V-cycle over ever coarser lattices.
///
///   2 x 2 x 2 cells are one of the next lattice, whose matrix is P^T A P, P: each cell has its parent's value
///   x = D^-1 r,   x += 3/2 P cycle(P^T (r - A x)),   x += D^-1 (r - A x)
///
/// D: the diagonal over 0.8. The factor 3/2 is there because constants by pieces make the coarser matrix too stiff
/// (Braess, Computing 55 (1995) 379-393). It is symmetric and positive definite for any factor. Iterations hardly grow
/// with the number of cells, and any number of threads gives the same bits.
class LatticeMultigrid {
public:
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    using Place = std::array<std::int32_t, 3>;  ///< of a cell in the lattice, from 0

    /// `finest` must outlive this.
    void take(const Matrix& finest, std::vector<Place> places);
    Eigen::VectorXd solve(const Eigen::VectorXd& r) const { return cycle(0, r); }

    // --- what Eigen asks of a preconditioner: all is made by `take`
    template <class AnyMatrix>
    LatticeMultigrid& compute(const AnyMatrix&) {
        return *this;
    }
    Eigen::ComputationInfo info() const { return Eigen::Success; }

private:
    struct Lattice {
        Matrix matrix;                     ///< empty of the finest
        Eigen::VectorXd inverse;           ///< D^-1
        std::vector<std::int32_t> parent;  ///< of each cell; of the coarsest none
    };
    const Matrix& matrix(std::size_t k) const { return k == 0 ? *finest_ : lattices_[k].matrix; }
    Eigen::VectorXd cycle(std::size_t k, const Eigen::VectorXd& r) const;

    const Matrix* finest_ = nullptr;
    std::vector<Lattice> lattices_;
};

}  // namespace tw
