#pragma once
#include <algorithm>
#include <cstddef>

#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// The cut-off of cavitation.h.
struct CutOffTension {
    PackedGradientPressure* stress;
    float lowest;  ///< [Pa]

    void operator()(std::size_t i) const { stress[i].p = std::max(stress[i].p, lowest); }
};

}  // namespace tw
