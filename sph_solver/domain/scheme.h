#pragma once
#include <span>
#include <string>

#include "scene/sph_options.h"

namespace tw {

/// How a step is made: schedule.h; table in docs/results/numerics.md.
enum class Scheme {
    symplectic_euler,      ///< one evaluation
    kick_drift_kick,       ///< one evaluation, its first pair loop in the middle of the drift
    predictor_corrector,   ///< two: the explicit midpoint rule
    rk4_frozen_diffusion,  ///< four: Runge-Kutta, with the density diffusion of its first stage throughout
};

/// By the name a scene gives it (`[sph] scheme`). Throws InputError for another name.
Scheme scheme_of(const std::string& name);

struct TimeOptions {
    Scheme scheme = scheme_of(SphOptions{}.scheme);
    double cfl = SphOptions{}.cfl;  ///< dt = cfl h / (c0 + |u|) [-]
};

/// One stage of an explicit Runge-Kutta step: at t + c dt, reached with the rates of the stage before; its weight.
struct Stage {
    double c, weight;  ///< of the step; of the mean [-]
};

}  // namespace tw
