#include "structure/time/nonlinear_alpha.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/QR>
#include <vector>

#include "base/errors.h"

namespace tw::structure {
namespace {

/// Anderson 1965 (doi:10.1145/321296.321305): the next guess from the last few and from the steps that the fixed
/// iteration would take from them, so that their combined step is the shortest, weighted by the roots of the masses.
class Acceleration {
public:
    explicit Acceleration(Eigen::VectorXd weight) : weight_(std::move(weight)) {}

    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
        if (x_.size() > 0) {
            constexpr std::size_t most = 8;
            dx_.push_back(x - x_);
            dg_.push_back(step - step_);
            if (dx_.size() > most) {
                dx_.erase(dx_.begin());
                dg_.erase(dg_.begin());
            }
        }
        x_ = x;
        step_ = step;
        Eigen::VectorXd to = x + step;
        if (dx_.empty()) return to;
        Eigen::MatrixXd weighted(x.size(), static_cast<Eigen::Index>(dg_.size()));
        for (std::size_t k = 0; k < dg_.size(); ++k)
            weighted.col(static_cast<Eigen::Index>(k)) = weight_.cwiseProduct(dg_[k]);
        const Eigen::VectorXd mix = weighted.colPivHouseholderQr().solve(weight_.cwiseProduct(step));
        for (std::size_t k = 0; k < dg_.size(); ++k) to -= mix[static_cast<Eigen::Index>(k)] * (dx_[k] + dg_[k]);
        return to;
    }

private:
    Eigen::VectorXd weight_, x_, step_;
    std::vector<Eigen::VectorXd> dx_, dg_;  ///< changes from guess to guess, and of the steps from there
};

/// Errors of 1e-15 in places, by the extent of the mesh [m], and in turns.
Eigen::VectorXd rounding_of_places(const Shell& shell) {
    Vec3 low = shell.mesh().nodes.front(), high = low, far = low.cwiseAbs();
    for (const Vec3& x : shell.mesh().nodes)
        low = low.cwiseMin(x), high = high.cwiseMax(x), far = far.cwiseMax(x.cwiseAbs());
    const double size = std::max((high - low).norm(), far.norm());
    Eigen::VectorXd errors = Eigen::VectorXd::Constant(shell.dofs(), 1e-15);
    for (int n = 0; n < errors.size(); n += 6) errors.segment<3>(n) *= size;
    return errors;
}
}  // namespace

NonlinearAlpha::NonlinearAlpha(const Shell& shell, const DegreesOfFreedom& dofs, double dt)
    : shell_(&shell),
      dofs_(dofs),
      elastic_(shell),
      basis_(dofs.basis()),
      M_(basis_.transpose() * dofs.mass(shell.mass()) * basis_),
      dt_(dt) {
    if (!(std::isfinite(dt) && dt > 0)) throw InputError(fmt::format("time step {} s; expected a positive one", dt));
    const SparseMatrix of_nodes = shell.stiffness();
    const SparseMatrix K = basis_.transpose() * dofs.widened(of_nodes) * basis_;
    rounding_ =
        (basis_.transpose() * dofs.widened(Eigen::VectorXd(of_nodes.cwiseAbs() * rounding_of_places(shell)))).norm();
    solver_.factorise(2 / (dt * dt) * M_ + 0.5 * K);
    if (!solver_.positive_definite())
        throw RunError("the structure has a degree of freedom with neither mass nor stiffness");
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(basis_.cols());
    state_ = {Eigen::VectorXd::Zero(dofs.all()), none, none, none, none};
}

Eigen::VectorXd NonlinearAlpha::internal(const Eigen::VectorXd& u) const {
    return basis_.transpose() * dofs_.widened(elastic_.internal_force(nodes(u)));
}

Eigen::VectorXd NonlinearAlpha::moved(const Eigen::VectorXd& u, const Eigen::VectorXd& by) const {
    const Eigen::VectorXd change = basis_ * by;
    Eigen::VectorXd to = u + change;
    to.head(shell_->dofs()) = elastic_.moved(nodes(u), nodes(change));
    return to;
}

void NonlinearAlpha::start(const Eigen::VectorXd& v, const Eigen::VectorXd& load) {
    const SparseMatrix normal = basis_.transpose() * basis_;
    const SparseCholesky unknowns(normal), inertia(M_);
    if (!inertia.factorised()) throw RunError("the structure has a degree of freedom without mass");
    state_.u.setZero();
    state_.v = unknowns.solve(basis_.transpose() * v);
    state_.f = basis_.transpose() * load;
    state_.F = internal(state_.u);
    state_.a = inertia.solve(state_.f - state_.F);
}

int NonlinearAlpha::step(const Eigen::VectorXd& load) {
    State& s = state_;
    const Eigen::VectorXd f = basis_.transpose() * load;
    Eigen::VectorXd change = dt_ * s.v + dt_ * dt_ / 2 * s.a;
    Acceleration towards(M_.diagonal().cwiseSqrt());
    double left = 0;
    for (int iteration = 1; iteration <= 60; ++iteration) {
        const Eigen::VectorXd u = moved(s.u, change), F = internal(u);
        const Eigen::VectorXd a = 4 / (dt_ * dt_) * (change - dt_ * s.v) - s.a;
        const Eigen::VectorXd inertial = M_ * (s.a + a) / 2;
        const Eigen::VectorXd r = (s.f + f) / 2 - (s.F + F) / 2 - inertial;
        left = r.norm();
        const double scale = F.norm() + s.F.norm() + inertial.norm() + f.norm();
        if (left <= std::max(1e-8 * scale, rounding_)) {
            s.v += dt_ / 2 * (s.a + a);
            s.a = a;
            s.u = u;
            s.f = f;
            s.F = F;
            return iteration;
        }
        if (!std::isfinite(left)) break;
        change = towards.next(change, solver_.solve(r));
    }
    throw RunError(
        fmt::format("a step of {:.3g} s of the structure does not balance ({:.3g} N left); a shorter step is "
                    "needed",
                    dt_, left));
}

}  // namespace tw::structure
