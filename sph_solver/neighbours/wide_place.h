#pragma once
#include <cstdint>

#include "sph_solver/equations/vector.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// A position in fixed-point units from the origin, in full.
struct WidePlace {
    std::int64_t x, y, z;
    /// As the pair loops see it: modulo 2^32.
    PackedPlace packed(float volume) const {
        return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z), volume};
    }
};

}  // namespace tw
