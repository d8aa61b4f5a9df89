#pragma once
#include <cstdint>

#include "sph_solver/neighbours/wide_place.h"

namespace tw {

/// A particle that is seen and is none: whose image it is, and by which map (LinkMaps). An image at a mirror plane and
/// one beyond a periodic face are the same but for the map.
struct Link {
    std::int32_t index = 0;  ///< of the source among the particles
    std::uint16_t map = 0;
};

/// What a combination of planes and periodic faces, one at most for each axis, does with places and directions.
struct LinkMap {
    std::int64_t offset[3] = {},
                 turn[3] = {};  ///< x' = offset + x, or offset - x where `turn` is -1 [fixed-point units]
    float sign[3] = {1, 1, 1};  ///< of vectors [-]
    float held[3] = {1, 1, 1};  ///< of velocities against the walls that hold the water, see Law::held [-]
    bool repeats[3] = {};       ///< moved by the domain's length: a periodic flow has the same pressure one length on

    WidePlace place(const WidePlace& p) const { return {coordinate(p.x, 0), coordinate(p.y, 1), coordinate(p.z, 2)}; }

private:
    std::int64_t coordinate(std::int64_t x, int a) const { return offset[a] + ((x ^ turn[a]) - turn[a]); }
};

}  // namespace tw
