#include "structure/time/central_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace tw::structure {

CentralDifference::CentralDifference(const SparseMatrix& mass, SparseMatrix basis, Force force)
    : basis_(std::move(basis)), M_(basis_.transpose() * mass * basis_), inertia_(M_), force_(std::move(force)) {
    if (!inertia_.positive_definite()) throw RunError("the structure has a degree of freedom without mass");
    state_.q = state_.v = Eigen::VectorXd::Zero(basis_.cols());
    state_.f = basis_.transpose() * force_(basis_ * state_.q, 0);
}

namespace {
/// The unknowns of which all degrees of freedom follow: exact where supports and rigid parts allow them.
Eigen::VectorXd unknowns(const SparseMatrix& basis, const Eigen::VectorXd& all) {
    const SparseMatrix normal = basis.transpose() * basis;
    return SparseCholesky(normal).solve(basis.transpose() * all);
}
}  // namespace

void CentralDifference::set_displacement(const Eigen::VectorXd& u_all) {
    state_.q = unknowns(basis_, u_all);
    state_.f = basis_.transpose() * force_(basis_ * state_.q, state_.t);
}

void CentralDifference::set_velocity(const Eigen::VectorXd& v_all) { state_.v = unknowns(basis_, v_all); }

void CentralDifference::add_impulse(const Eigen::VectorXd& impulse_all) {
    state_.v += inertia_.solve(basis_.transpose() * impulse_all);
}

int CentralDifference::advance(double interval, double longest) {
    const int steps = std::max(1, static_cast<int>(std::ceil(interval / longest * (1 - 1e-12))));
    const double dt = interval / steps;
    for (int k = 0; k < steps; ++k) {
        state_.v += dt / 2 * inertia_.solve(state_.f);
        state_.q += dt * state_.v;
        state_.t += dt;
        state_.f = basis_.transpose() * force_(basis_ * state_.q, state_.t);
        state_.v += dt / 2 * inertia_.solve(state_.f);
        if (!state_.v.allFinite())
            throw RunError(
                fmt::format("the structure left all bounds at t = {:.6g} s with sub-steps of {:.3g} s; often a "
                            "sub-step above the explicit limit, or an element turned inside out",
                            state_.t, dt));
    }
    return steps;
}

}  // namespace tw::structure
