#pragma once

namespace tw {

/// How long neighbour lists hold: upper bounds of what has moved since they were made. What moves with the stream stays
/// beside its neighbours, so lists among particles need only the motion relative to it. Both slacks are chosen for
/// speed, not derived.
struct ListLife {
    static constexpr double slack_over_dp = 0.3;       ///< slack of the particle lists
    static constexpr double wall_slack_over_dp = 0.6;  ///< slack of the lists between particles and walls

    double travel = 0, travel_in_stream = 0;  ///< of particles [m]
    double wall_travel = 0;                   ///< of walls [m]
    double relative_speed = 0;                ///< largest one relative to the stream after the last step [m/s]
    double age = 0;                           ///< [s]
    bool over = true;                         ///< the lists have to be made anew
};

}  // namespace tw
