#pragma once
#include "record/run_record.h"
#include "sph_solver/simulation.h"

namespace tw {

/// Ends a run of which nothing can come, with the cause in words.
///
/// - No water is left, or there is half as much again as at the start.
/// - Its steps have collapsed: one is below a thousandth of what sound and the effects allow, so particles are
///   accelerated to a speed of sound in less than a ten-thousandth of the time in which sound crosses their support. No
///   flow does that.
/// - It has taken twenty times the steps that were predicted, or that its first step would have needed: between a tenth
///   and a thousandth of the usual step a run gets on, and never to its end.
/// - Its water has an energy that nothing can have given it. With v, the speed that the scene explains (its stream, the
///   fall from the water's surface, walls and bodies), and the mass M of the water:
///
///     in a tank       energy made > M v^2 / 4,           of a fall from the surface half of the potential energy
///     everywhere      kinetic energy > M (2 v)^2 / 2,    all of the water at twice the speed
///
/// Time on the clock is not watched: a slow machine is no fault of a run.
class RunWatch {
public:
    struct Expected {
        double speed = 0;     ///< v [m/s]; 0: not known, energy is not watched
        double duration = 0;  ///< [s]
        double steps = 0;     ///< predicted for all of it; 0: not said [-]
    };
    explicit RunWatch(const Expected& expected) : expected_(expected) {}

    /// Both throw RunError with the time and the cause.
    void after_step(const Simulation& simulation);
    /// `record`: with the frame's row of `samples`.
    void after_frame(const RunRecord& record) const;
    /// The same of one step: `step` was taken, `allowed` is what sound and the effects allow [s].
    void note_step(double time, double step, double allowed);

private:
    static constexpr double collapsed = 1e-3;
    static constexpr int longest_row = 200;  ///< of steps: one alone is a collision of two particles
    static constexpr double most_steps = 20, most_water = 1.5;

    Expected expected_;
    int row_ = 0;
    double steps_ = 0;  ///< since this start: a resumed run gets as many again
    double first_step_ = 0;
};

}  // namespace tw
