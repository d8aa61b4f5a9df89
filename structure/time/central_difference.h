#pragma once
#include <functional>

#include "structure/degrees_of_freedom.h"
#include "structure/sparse_cholesky.h"

namespace tw::structure {

/// The central difference method as kick-drift-kick, for structures whose forces are found anew each step:
///
///   v += dt/2 M^-1 f(q),  q += dt v,  v += dt/2 M^-1 f(q)
///
/// Stable below 2 / omega of the structure's highest frequency (Solid::explicit_step, Shell::explicit_step).
class CentralDifference {
public:
    /// Net force on all degrees of freedom (loads less internal forces) [N], by displacements [m] and time [s].
    using Force = std::function<Eigen::VectorXd(const Eigen::VectorXd& u, double t)>;
    /// Of the unknown degrees of freedom: place, velocity, the force there, and time. A restart needs these alone.
    struct State {
        Eigen::VectorXd q, v, f;
        double t = 0;  ///< [s]
    };

    /// Throws RunError for a freedom without mass.
    CentralDifference(const SparseMatrix& mass, SparseMatrix basis, Force force);

    void set_displacement(const Eigen::VectorXd& u_all);  ///< of all degrees of freedom [m]
    void set_velocity(const Eigen::VectorXd& v_all);      ///< of all degrees of freedom [m/s]
    /// An impulse on all degrees of freedom [N s], at once.
    void add_impulse(const Eigen::VectorXd& impulse_all);
    /// Over `interval` [s] in equal sub-steps no longer than `longest` [s]; returns their number. Throws RunError with
    /// the time when the state is no longer finite.
    int advance(double interval, double longest);

    Eigen::VectorXd displacement() const { return basis_ * state_.q; }
    Eigen::VectorXd velocity() const { return basis_ * state_.v; }
    double kinetic_energy() const { return state_.v.dot(M_ * state_.v) / 2; }  ///< [J]

    const State& state() const { return state_; }
    void set_state(State state) { state_ = std::move(state); }

private:
    SparseMatrix basis_, M_;
    SparseCholesky inertia_;
    Force force_;
    State state_;
};

}  // namespace tw::structure
