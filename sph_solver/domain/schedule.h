#pragma once
#include <span>

#include "sph_solver/domain/scheme.h"

namespace tw {

/// For how long what is moved in a step [s].
///
/// A step of symplectic Euler and one of kick-drift-kick, whose
/// first pair loop lies in the middle of the drift and which is cut there, dt' being the step before:
///
///   rho -= dt' rho div u at (x, u);   u += dt a(x, rho);   rho += dt D;   x += dt u
///
///   x += dt'/2 u;   rho -= dt' rho div u at (x, u);   x += dt'/2 u;   u += (dt' + dt)/2 a(x, rho);
///   rho += (dt' + dt)/2 D;   x += dt/2 u
///
/// written from one cut to the next: places and velocities between two steps are those of one moment (densities: half a
/// step before). The first step has dt' = 0, and a restart needs nothing but dt'. Kick-drift-kick is of second order
/// but for the viscous forces, which see a velocity half a step old.
class Schedule {
public:
    explicit Schedule(Scheme scheme) : scheme_(scheme) {}

    /// When the rates are evaluated, after the step's begin; for how long the density changes by the continuity
    /// equation on the way, and the places drift between the two pair loops.
    struct Evaluation {
        double after, compress, drift;  ///< [s]
    };
    Evaluation evaluation(double previous_dt) const;

    /// For how long velocities and densities change by the rates, places have drifted in this step already, and drift
    /// at its end.
    struct Move {
        double kick, drifted, drift;  ///< [s]
    };
    Move move(double previous_dt, double dt) const;

    /// The stages of an explicit Runge-Kutta step; none: a step of one evaluation.
    std::span<const Stage> stages() const;
    /// The density diffusion of the first stage serves all.
    bool freezes_diffusion() const { return scheme_ == Scheme::rk4_frozen_diffusion; }
    /// So far the pair loops look ahead of the places between two steps, in steps: the lists must hold there too.
    double looks_ahead() const;

private:
    Scheme scheme_;
};

}  // namespace tw
