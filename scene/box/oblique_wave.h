#pragma once
#include <Eigen/Core>

#include "scene/box/forcing_zones.h"

namespace tw {

/// A regular wave under an angle b to x in a stream U, on a whole hull or in an empty box in three dimensions. In the
/// water it runs at c and its energy at cg; seen from the hull it is met with, and its energy runs at,
///
///   omega_e = k (c + U cos b),   V = (U + cg cos b, cg sin b)
///
/// Zones at all four sides draw to stream and wave, 1.5 wave lengths wide: such a zone makes the wave, lets it through
/// and absorbs what differs from it, as what a hull adds or what the end behind it sends back. Behind those at the sides
/// stand walls. How long what differs stays in a zone is told by the speed of its energy across it. So strengths are
/// those of a head wave's (forcing_zones.h) with k (c cos b + U), or omega |U + cg cos b|/cg where cos b < 0, in place of
/// the frequency of encounter at inlet and outlet, and omega |sin b| at the sides, each at least omega/2, below which a
/// zone would hardly absorb what comes from elsewhere.
///
/// Taken are streams (scene/read/check_oblique_wave.cpp)
///
/// - of at most 1.5 c, whose inlet does not yet spoil the wave, and of at least the water's own speed against them, both
///   as for head waves;
/// - of c + U cos b >= 0.3 c, so that enough of the waves are met in the time of a run;
/// - where cos b < -sqrt(2/3), nearly following, of U <= 0.7 cg |cos b|, so that energy comes from behind. The speed of
///   energy along x, U + cg cos b = d omega_e / d k_x at a fixed k_y, which is what the inlet's row of crests fixes,
///   falls with k_x down to this angle (in deep water cg cos b ~ k_x (k_x^2 + k_y^2)^(-3/4), least at k_x^2 = 2/3 k^2)
///   and rises beyond. Beyond, a faster stream would bring the wave from ahead together with a longer one of the same
///   frequency and crests; before, the longest wave with them is the one that is asked for.
bool runs_obliquely(const Scene& scene);

/// V, of a scene with a wave [m/s].
Eigen::Vector2d energy_velocity(const Scene& scene);

/// Until what its zones make has come to every place between them [s]: over a zone and the box, along that of the axes
/// that takes less time.
double time_to_fill(const Scene& scene);

inline constexpr double lengths_of_oblique_zones = 1.5;
void take_oblique_wave(const Scene& scene, ForcingZones& plan);  ///< zones as in a stream without it

}  // namespace tw
