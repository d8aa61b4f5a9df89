#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace tw {

/// A zone along a face of the domain that draws the water's velocity towards the undisturbed one, so that waves die out
/// before they meet the face and none comes back from it:
///
///   du/dt += gamma b (u_ref - u),   b = s^2,   s from 0 at `begin` to 1 at `end`
///
/// u_ref: the stream (with its ramp), rest, or in the zone that makes it the scene's wave; of zones the largest gamma b
/// counts. Relaxation of velocity alone, after Peric & Abdel-Maksoud, Ocean Eng. 147 (2018) 132, arXiv:1705.06940.
struct ForcingZone {
    int axis = 0;               ///< 0 x, 1 y
    bool high = false;          ///< at the face of larger coordinate
    double begin = 0, end = 0;  ///< along the axis [m]: where b rises from 0, and the face, where it is 1
    double gamma = 0;           ///< [1/s]
    double share = 1;  ///< u_ref over the stream's speed [-]: of the water behind it may be another (tailwater.h)
    bool makes_wave = false;  ///< u_ref is the scene's wave
};
struct ForcingZones {
    std::vector<ForcingZone> zones = {};
    double wave_length = 0, frequency = 0;  ///< of the wave for which they are made [m], [rad/s]
    double speed = 0;                       ///< of u_ref, along x, after the ramp [m/s]; 0: rest
    std::string why = {};                   ///< which wave, and what made a zone shorter or longer than it asks for
};

/// The zones of a scene whose effect `forcing_zones` is on; none else. Widths and strengths from the reflection of
/// exact linear waves in two dimensions (docs/decisions/082-zones-and-ends.md).
///
/// In a stream they lie outside the box that was asked for (`Domain::undamped`) and are made for the wave that stands
/// in it (at the outlet in the water behind, tailwater.h), of length lambda and frequency g/U in the water: gamma = g/U
/// over lambda ahead, 1.5 lambda behind, and lambda/2 beside a hull in three dimensions, unless [domain] sides =
/// "walls". Widths follow lambda up to 1.5 lengths of a hull in three dimensions, or half of a channel, and are at
/// least eight of the largest spacings; gamma is at most that of deep water's wave of that length.
///
/// In a tank they lie inside, along the walls of [tank] absorbing, one wave length wide for the longest wave of a body
/// that oscillates ([tank] wave_length), but clear of prescribed bodies and over at most half of the tank, with gamma =
/// 1.5 omega / sqrt(tanh k h), and more where there is room for less than 0.6 of a wave length.
///
/// A tank with a [wave] has two, at the ends that it comes from and runs to. The one that absorbs it is one wave length
/// wide. The wall behind the one that makes it sends out a wave of the same height against it; over 1.5 wave lengths and
/// with twice the strength less than 1 % of that is left, and less than half a per cent of a wave that comes back is
/// reflected (docs/decisions/088-waves.md). Those of a sum of waves are made for the longest that count (tank_wave.h).
///
/// In a stream with a wave the zone from which its energy comes makes it: ahead that of a head wave, and that of a
/// following wave where the stream is faster than its energy (tank_wave.h), else the one behind. The other absorbs it.
/// They are as wide at least as in a tank and as the stream itself asks for. The one that makes it has 1.5 times the
/// strength of one that absorbs it over one wave length, at the frequency of encounter, the other what its width needs.
/// A hull's sides are walls, because zones would take the wave away beside it. Of an oblique wave there are zones at all
/// four sides, which all make it (oblique_wave.h).
ForcingZones forcing_zones(const Scene& scene);

/// Length of the wave that stands in a stream, U^2 = g/k tanh(k h) [m]; nothing from the critical speed U^2 = g h on.
std::optional<double> standing_wave_length(double speed, double gravity, double depth);

/// Whether zones are on unless the scene says otherwise: in every stream in which a wave can stand, but for planing
/// hulls (length Froude number 1 and more), which leave their waves behind; and with a [wave], unless it may enter with
/// the stream (scene/box/inlet_wave.h). Its domain has to be known, its weight may be off: `gravity` [m/s2].
bool has_zones_by_default(const Scene& scene, double gravity);

/// How far the zones of a stream reach beyond its box [m].
struct ZoneReach {
    double ahead = 0, behind = 0, side = 0;  ///< [m]
};
/// Of a domain whose box is still without them.
ZoneReach zone_reach(const Scene& scene, double gravity);

}  // namespace tw
