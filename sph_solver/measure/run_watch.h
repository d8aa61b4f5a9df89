#pragma once
#include "sph_solver/simulation.h"

namespace tw {

/// Ends a run of which nothing can come: no water is left, or its steps have collapsed. A step is collapsed where it is
/// below a thousandth of what sound and the effects allow, so where particles are accelerated to a speed of sound in
/// less than a ten-thousandth of the time in which sound crosses their support: no flow does that.
class RunWatch {
public:
    /// Throws RunError with the time and the cause.
    void after_step(const Simulation& simulation);
    /// The same of one step: `step` was taken, `allowed` is what sound and the effects allow [s].
    void note_step(double time, double step, double allowed);

private:
    static constexpr double collapsed = 1e-3;
    static constexpr int longest_row = 200;  ///< of steps: one alone is a collision of two particles
    int row_ = 0;
};

}  // namespace tw
