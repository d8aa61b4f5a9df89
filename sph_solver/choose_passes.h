#pragma once
#include <vector>

#include "sph_solver/backend/variants.h"

namespace tw {

// Which variant of the passes a run uses. All make the same sums with roundings of their own, so a run keeps the one it
// was started with, on any number of threads. Which is the fastest is a property of the processor: sixteen lanes do
// half the operations and visit a fifth more neighbours in vain, and some processors make a 512-bit operation of two
// halves; roots and quotients by estimates (`rough`) pay where the divider is slow.

struct PassesPace {
    const Passes* passes;
    double evaluations_per_second;  ///< both pair loops, one thread, lists made already [1/s]
};
/// Measures each on a block of water with a floor and a surface, larger than the second cache, in turn; about a second.
std::vector<PassesPace> measure_passes(const std::vector<const Passes*>& which);
/// The fastest; the first where no other is more than 5 % faster.
const Passes& best_of(const std::vector<PassesPace>& paces);

/// What a new run uses: what TWINWAKE_ISA names, else what was found the best on this processor, measured once and
/// remembered in the cache folder (base/cache_folder.h). Where nothing can be remembered the default, so that one
/// machine does not change its mind from run to run.
const Passes& choose_passes();
void remember_passes(const Passes& chosen);

}  // namespace tw
