#pragma once

#include "structure/degrees_of_freedom.h"
#include "structure/sparse_cholesky.h"

namespace tw::structure {

/// The generalised-alpha method (Chung & Hulbert 1993, doi:10.1115/1.2900803) for a linear structure: one
/// factorisation, any time step.
///
///   u' = u + dt v + dt^2 ((1/2 - beta) a + beta a'),  v' = v + dt ((1 - gamma) a + gamma a')
///   M ((1 - am) a' + am a) + K ((1 - af) u' + af u) = (1 - af) f' + af f
///
/// `damping_at_infinity` is the factor by which an infinitely fast mode keeps its amplitude each step. 1 is the average
/// acceleration method: it conserves the energy exactly. Second order whatever it is.
class GeneralisedAlpha {
public:
    /// Of the unknown degrees of freedom: q, their velocity and acceleration, and the load they were last given. A
    /// restart needs these alone.
    struct State {
        Eigen::VectorXd q, v, a, f;
    };

    /// `stiffness` and `mass` are those of all degrees of freedom. Throws InputError for a step or a factor out of (0,
    /// inf) and [0, 1], RunError if the matrix is not positive definite.
    GeneralisedAlpha(const SparseMatrix& stiffness, const SparseMatrix& mass, SparseMatrix basis, double dt,
                     double damping_at_infinity = 1);

    /// At rest in the reference state, or as given: displacements and velocities of all degrees of freedom; the
    /// acceleration is what the load there gives.
    void start(const Eigen::VectorXd& u, const Eigen::VectorXd& v, const Eigen::VectorXd& load);
    /// One step of dt to where `load`, of all degrees of freedom [N], acts.
    void step(const Eigen::VectorXd& load);

    Eigen::VectorXd displacement() const { return basis_ * state_.q; }
    Eigen::VectorXd velocity() const { return basis_ * state_.v; }
    Eigen::VectorXd acceleration() const { return basis_ * state_.a; }
    double kinetic_energy() const { return state_.v.dot(M_ * state_.v) / 2; }  ///< [J]
    double elastic_energy() const { return state_.q.dot(K_ * state_.q) / 2; }  ///< [J]
    double dt() const { return dt_; }

    const State& state() const { return state_; }
    void set_state(State state) { state_ = std::move(state); }

private:
    SparseMatrix basis_, K_, M_;
    double dt_, am_, af_, beta_, gamma_;
    SparseCholesky solver_;
    State state_;
};

}  // namespace tw::structure
