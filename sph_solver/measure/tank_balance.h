#pragma once
#include "record/run_record.h"
#include "sph_solver/simulation.h"

namespace tw {

/// What a tank that moves and its water do to each other, from frame to frame, in the tank's axes:
///
///   force on tank and fixed solids = (sum of the steps' impulse of f - change of the momentum
///                                     - impulse on the bodies that move) / time
///   work of the motion         = sum over the steps of  dt sum_i m_i (f_i - g) . u_i
///
/// Kinetic, elastic and potential energy (of gravity along the tank's own z) less the work can only fall.
class TankBalance {
public:
    /// Begins at the present state, which is that of a frame or of the start.
    void begin(const Simulation& simulation);
    void after_step(const Simulation& simulation);
    /// A row of the table `tank` at a frame, per metre of span in two dimensions, and begins anew. `N`, `J`: the units.
    void record(const Simulation& simulation, Table& tank, const std::string& N, const std::string& J);

private:
    Vec3 momentum_ = Vec3::Zero();  ///< at the last frame [N s]
    Vec3 impulse_ = Vec3::Zero();   ///< of f since [N s]
    double work_ = 0, since_ = 0, time_ = 0;
};

}  // namespace tw
