#pragma once
#include <algorithm>
#include <cmath>

namespace tw {

/// How long neighbour lists hold: upper bounds of what has moved since they were made. What moves with the stream stays
/// beside its neighbours, so lists among particles need only the motion relative to it. The slacks are chosen for
/// speed (decision 060), not derived.
struct ListLife {
    static constexpr double least_slack_over_dp = 0.3, most_slack_over_dp = 0.9;  ///< of the particle lists
    static constexpr double wall_slack_over_dp = 0.6;  ///< slack of the lists between particles and walls

    /// Slack of particle lists that are made now [m], of particles that come nearer to each other by `approach` a in a
    /// step [m] at most, and past walls by `passage` b [m]:
    ///
    ///   s = 1.8 sqrt(a dp),   0.3 dp <= s <= 0.9 dp,   s <= 0.6 dp a / b
    ///
    /// With a slack s lists hold s / a steps and cost more in each as they are longer, so the cheapest slack goes with
    /// the square root of a. The walls let no lists live for more than 0.6 dp / b steps.
    static double slack_for(double dp, double approach, double passage) {
        double slack = 1.8 * std::sqrt(approach * dp);
        if (passage > 0) slack = std::min(slack, wall_slack_over_dp * dp * approach / passage);
        return std::clamp(slack, least_slack_over_dp * dp, most_slack_over_dp * dp);
    }

    double slack = 0;                         ///< of the particle lists made last [m]
    double travel = 0, travel_in_stream = 0;  ///< of particles [m]
    double wall_travel = 0;                   ///< of walls [m]
    double relative_speed = 0;                ///< largest one relative to the stream after the last step [m/s]
    double since_walls = 0;                   ///< since the walls nearest to particles were found [s]
    bool over = true;                         ///< the lists have to be made anew
};

}  // namespace tw
