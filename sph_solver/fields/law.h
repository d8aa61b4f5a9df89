#pragma once
#include <cstdint>

namespace tw {

/// How an image of a particle has a quantity of its source (ghosts/laws.h).
enum class Law : std::uint8_t {
    unseen,      ///< not at all: the array ends with the particles
    place,       ///< where the plane puts it
    scalar,      ///< as it is
    vector,      ///< turned by the plane
    held,        ///< a velocity against walls that hold the water: turned, and against them along the plane too
    tensor,      ///< turned twice
    hydrostatic  ///< turned, and carried on along the hydrostatic line
};

}  // namespace tw
