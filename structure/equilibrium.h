#pragma once
#include <functional>

#include "structure/degrees_of_freedom.h"

namespace tw::structure {

/// What is out of balance in the state u (all degrees of freedom): loads less internal forces [N], and the derivative
/// of the internal forces less the loads by u [N/m].
struct Balance {
    std::function<Eigen::VectorXd(const Eigen::VectorXd& u)> out_of_balance;
    std::function<SparseMatrix(const Eigen::VectorXd& u)> tangent;
    /// The state after a small change; u + by unless given, as where rotations are large (shell/corotational.h).
    std::function<Eigen::VectorXd(const Eigen::VectorXd& u, const Eigen::VectorXd& by)> moved = nullptr;
};

/// The state near `start` in which nothing is out of balance along the unknown degrees of freedom, by Newton's method,
/// to `tolerance` [N]. Large loads are put on in steps, by the caller. Throws RunError if 30 iterations do not get
/// there or a tangent is singular: the structure buckles, or a step of the load was too large.
Eigen::VectorXd equilibrium(const Eigen::VectorXd& start, const SparseMatrix& basis, const Balance& balance,
                            double tolerance);

}  // namespace tw::structure
