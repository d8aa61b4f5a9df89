#pragma once
#include "foam_cases/case_plan.h"

namespace tw {

/// Without a momentum predictor interFoam's pressure correctors alone carry momentum from cell to cell, each as one
/// iteration of Jacobi's. With the viscous number D = nu dt / dx^2 in d dimensions, n of them leave out the share
///
///   (2 d D / (1 + 2 d D))^n
///
/// of a step's viscous exchange: a rod of 20 mm in oil (D = 14, n = 2) sank ever faster, turned and rose at 0.8 m/s. Where
/// that is more than a hundredth, the momentum equation is solved as well, with two pressure correctors at least in each of
/// the outer correctors, of which a body that moves gets three. A step is then no longer than D = 15, up to which a
/// sinking rod was measured. Call it when the time steps are known.
void plan_viscous_steps(CasePlan& plan);

/// How body and water come to terms in a step: relaxation, Newmark's gamma, outer correctors.
void plan_coupling(CasePlan& plan);

/// Mass of the water that viscosity holds to a body's surface S in a step [kg]: rho S sqrt(nu dt), the layer that a wall
/// drags along after the time dt (Stokes' first problem; Batchelor 1967, section 4.3). Nothing where the predictor is off.
double viscous_added_mass(const CasePlan& plan, const MovingBody& body);

}  // namespace tw
