#pragma once
#include <cstdint>

namespace tw {

/// How long a quantity stays with its particle.
enum class Kept : std::uint8_t {
    sorted,  ///< until particles are sorted, come or go; then it is found anew
    moved,   ///< when they are sorted, come and go, too
    saved    ///< and it is written to checkpoints
};

/// What a level has, so that its particles have a quantity.
enum class With : std::uint8_t {
    water = 0,  ///< every level
    coarser = 1,
    finer = 2,
    walls = 4,
    moving_bodies = 8,
    elastic_bodies = 16,
    control_volume = 32,
    ventilation = 64,
    sea_at_inlet = 128  ///< a sum of waves that enters with the stream
};

}  // namespace tw
