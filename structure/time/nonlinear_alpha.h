#pragma once

#include "structure/degrees_of_freedom.h"
#include "structure/shell/corotational.h"
#include "structure/sparse_cholesky.h"

namespace tw::structure {

/// The average acceleration method for a shell at large rotations (generalised-alpha with the balance at the middle of
/// a step; time/generalised_alpha.h has the formulas). Each step is iterated to balance with the one matrix of the
/// reference state,
///
///   A = 2/dt^2 M + K/2,   A d = (f + f')/2 - (F(u) + F(u'))/2 - M (a + a')/2,   u' <- u' moved by d
///
/// the steps d combined by Anderson's acceleration. Nodes' rotary inertias are the same about all axes, so turns need
/// no gyroscopic term; frames that carry nodes turn little.
class NonlinearAlpha {
public:
    /// Displacements and rotation vectors of all degrees of freedom; velocity, acceleration, load and internal force of
    /// the unknown ones. A restart needs these alone.
    struct State {
        Eigen::VectorXd u, v, a, f, F;
    };

    /// `mass` is that of all degrees of freedom. `shell` must outlive this. Throws InputError for a step that is not
    /// positive, RunError if the matrix is not positive definite.
    NonlinearAlpha(const Shell& shell, const DegreesOfFreedom& dofs, double dt);

    /// At rest in the reference state, with velocities of all degrees of freedom and a load.
    void start(const Eigen::VectorXd& v, const Eigen::VectorXd& load);
    /// One step of dt to where `load`, of all degrees of freedom [N], acts; returns the number of iterations. Throws
    /// RunError if 60 do not balance it to 1e-8 of the forces, or to what rounding makes of them: the step is too long.
    int step(const Eigen::VectorXd& load);

    const Eigen::VectorXd& displacement() const { return state_.u; }
    double kinetic_energy() const { return state_.v.dot(M_ * state_.v) / 2; }   ///< [J]
    double elastic_energy() const { return elastic_.energy(nodes(state_.u)); }  ///< [J]

    const State& state() const { return state_; }
    void set_state(State state) { state_ = std::move(state); }

private:
    Eigen::VectorXd nodes(const Eigen::VectorXd& all) const { return all.head(shell_->dofs()); }
    Eigen::VectorXd internal(const Eigen::VectorXd& u) const;
    /// Where the unknowns' change takes all degrees of freedom.
    Eigen::VectorXd moved(const Eigen::VectorXd& u, const Eigen::VectorXd& by) const;

    const Shell* shell_;
    DegreesOfFreedom dofs_;
    Corotational elastic_;
    SparseMatrix basis_, M_;
    double dt_;
    /// Forces that places known to 1e-15 of the structure's extent make: what no iteration balances. It decides where
    /// next to nothing loads a structure at rest [N].
    double rounding_ = 0;
    SparseCholesky solver_;
    State state_;
};

}  // namespace tw::structure
