#include "structure/time/generalised_alpha.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"

namespace tw::structure {

GeneralisedAlpha::GeneralisedAlpha(const SparseMatrix& stiffness, const SparseMatrix& mass, SparseMatrix basis,
                                   double dt, double damping_at_infinity)
    : basis_(std::move(basis)),
      K_(basis_.transpose() * stiffness * basis_),
      M_(basis_.transpose() * mass * basis_),
      dt_(dt) {
    const double r = damping_at_infinity;
    if (!(std::isfinite(dt) && dt > 0) || !(r >= 0 && r <= 1))
        throw InputError(
            fmt::format("time step {} s with {} of an infinitely fast mode kept; expected a positive step "
                        "and a factor of 0 to 1",
                        dt, r));
    am_ = (2 * r - 1) / (r + 1);
    af_ = r / (r + 1);
    gamma_ = 0.5 - am_ + af_;
    beta_ = (1 - am_ + af_) * (1 - am_ + af_) / 4;
    solver_.factorise((1 - am_) * M_ + (1 - af_) * beta_ * dt * dt * K_);
    if (!solver_.positive_definite())
        throw RunError("the structure has a degree of freedom with neither mass nor stiffness");
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(basis_.cols());
    state_ = {none, none, none, none};
}

void GeneralisedAlpha::start(const Eigen::VectorXd& u, const Eigen::VectorXd& v, const Eigen::VectorXd& load) {
    // The unknowns of given displacements: exact where supports and rigid parts allow them.
    const SparseMatrix normal = basis_.transpose() * basis_;
    const SparseCholesky unknowns(normal), inertia(M_);
    if (!inertia.factorised()) throw RunError("the structure has a degree of freedom without mass");
    state_.q = unknowns.solve(basis_.transpose() * u);
    state_.v = unknowns.solve(basis_.transpose() * v);
    state_.f = basis_.transpose() * load;
    state_.a = inertia.solve(state_.f - K_ * state_.q);
}

void GeneralisedAlpha::step(const Eigen::VectorXd& load) {
    State& s = state_;
    const Eigen::VectorXd f = basis_.transpose() * load;
    const Eigen::VectorXd q = s.q + dt_ * s.v + dt_ * dt_ * (0.5 - beta_) * s.a;  // without the new acceleration
    const Eigen::VectorXd a =
        solver_.solve((1 - af_) * f + af_ * s.f - am_ * (M_ * s.a) - K_ * ((1 - af_) * q + af_ * s.q));
    s.q = q + dt_ * dt_ * beta_ * a;
    s.v += dt_ * ((1 - gamma_) * s.a + gamma_ * a);
    s.a = a;
    s.f = f;
}

}  // namespace tw::structure
