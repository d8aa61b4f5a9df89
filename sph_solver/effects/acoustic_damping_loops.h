#pragma once
#include <cstddef>

#include "sph_solver/domain/kind.h"
#include "sph_solver/loops/surface.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// Adds the pressure p_v of acoustic_damping.h, but not at the free surface.
struct DampSound {
    PackedGradientPressure* stress;
    const PackedRate* rate;
    const Kind* kind;
    const std::uint32_t* surface;
    float factor;  ///< alpha2 c0 h [m2/s]

    void operator()(std::size_t i) const {
        if (follows_the_equations(kind[i]) && !marked(surface, i)) stress[i].p += factor * rate[i].drho;
    }
};

}  // namespace tw
