#pragma once
#include <string>

#include "scene/scene.h"

namespace tw {

/// What the walls of the box are expected to do to a hull in a stream. With s the half width, d the depth of the box, B
/// the beam, L the wetted length at rest, V the displaced volume, A the water's cross section, F_L and F_d the Froude
/// numbers of length and depth:
///
///   F_L >= 1   lift         0.139 L B^2 / s^3 + 0.0148 L B / d^2
///   F_L <  1   resistance   2 m / (1 - m - F_d^2),   m = V / (0.6 L A),   F_d < 0.9
///
/// First line: least squares through the lift of the prism of studies/planing_prism.toml in ten boxes (s from 1 to 4 B, d
/// from 1 to 3.2 B), mean of both methods; each of them lies within 2 % of the lift from it for s of 1.5 B and more, and at
/// half the draft it is a third too large (docs/results/planing_prism.md). Second line: the blockage correction of the
/// speed after Schuster, as in ITTC 7.5-02-02-01, without its wave term, twice because resistance goes with the square of
/// the speed; m estimates the blockage by the midship section. Walls that the scene means, a bed and the sides of a
/// channel, have no part in the first line; where it means both there is nothing to estimate.
struct WallEffect {
    double change = 0;  ///< relative [-]
    /// "lift", "resistance"; empty: no formula holds (a tank, a depth Froude number of 0.9 and more), or all is meant.
    std::string of;
};
WallEffect wall_effect(const Scene& scene);

/// Whether the scene's hull has the first line's speed.
bool planes(const Scene& scene);

/// Where the box ends: half width and depth [m].
struct WallReach {
    double side = 0, depth = 0;  ///< [m]
};
/// Where sides and floor raise the lift of a planing hull by half of `change` each, by the first line.
WallReach reach_for_lift(const Hull& hull, double change);

/// Above this `check` warns.
inline constexpr double noticed_wall_effect = 0.02;
/// "the walls of the box (1.5 m to the side, 1.25 m below) are expected to raise the lift by 12 %; ...": empty where they
/// matter less, or are meant.
std::string wall_warning(const Scene& scene);

/// Whether the sides beside the scene's hull are the walls of a channel ([domain] sides = "walls") and no end of a box.
bool sides_are_meant(const Scene& scene);
/// "a channel of this size (1.5 m to each side, 1.25 m deep)", or of this width where its floor ends the box: of a scene
/// whose sides are meant; else empty.
std::string channel_text(const Scene& scene);

}  // namespace tw
