#include "structure/equilibrium.h"

#include <fmt/format.h>

#include <cmath>
#include <Eigen/SparseLU>

#include "base/errors.h"

namespace tw::structure {

Eigen::VectorXd equilibrium(const Eigen::VectorXd& start, const SparseMatrix& basis, const Balance& balance,
                            double tolerance) {
    Eigen::VectorXd u = start;
    double left = 0;
    for (int iteration = 0; iteration < 30; ++iteration) {
        const Eigen::VectorXd r = basis.transpose() * balance.out_of_balance(u);
        left = r.norm();
        if (left <= tolerance) return u;
        if (!r.allFinite()) break;
        SparseMatrix K = basis.transpose() * balance.tangent(u) * basis;  // not symmetric under a follower load
        K.makeCompressed();
        Eigen::SparseLU<SparseMatrix> solver(K);
        if (solver.info() != Eigen::Success) throw RunError("the tangent of the structure is singular");
        const Eigen::VectorXd by = basis * solver.solve(r);
        u = balance.moved ? balance.moved(u, by) : Eigen::VectorXd(u + by);
    }
    if (!std::isfinite(left)) throw RunError("no equilibrium of the structure: its forces grow beyond all bounds");
    throw RunError(
        fmt::format("no equilibrium of the structure in 30 iterations: {:.3g} N are out of balance, {:.3g} N "
                    "allowed; smaller steps of the load may help",
                    left, tolerance));
}

}  // namespace tw::structure
