#pragma once
#include <cstdint>
#include <limits>

namespace tw {

/// What a particle has of particles of half the spacing in its place.
enum class Daughters : std::uint8_t {
    none = 0,
    all = 1,
    some = 2  ///< has been out of their reach; those may be there still
};

/// Whether air is at a particle (effects/ventilation.h).
enum class Aired : std::uint8_t {
    unknown = 0,  ///< it is new
    no = 1,
    yes = 2
};

/// How the fields of a buffer particle change in time, from the coarser level, and what that level knows of its
/// surroundings.
struct Trend {
    float u = 0, v = 0, w = 0;  ///< [m/s2]
    float drho = 0;             ///< [kg/m3/s]
    float support = 1;          ///< Shepard sum of the coarser particles near [-]: whether it is at a free surface
};

/// Where a particle stood when its distance from the edge of a zone was last worked out, and how far that edge had
/// come.
struct EdgeDistance {
    float x = std::numeric_limits<float>::quiet_NaN(), y = 0, z = 0;  ///< [m]; not a number: it never was
    float outside = 0;                                                ///< Zone::outside there [m]
    float by = 0, turn = 0;                                           ///< Zone::Shift summed since the start [m], [rad]
};

}  // namespace tw
