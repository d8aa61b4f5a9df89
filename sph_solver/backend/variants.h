#pragma once
#include <vector>

#include "sph_solver/pair_loops/passes.h"

namespace tw {

// Which variants of the passes there are; `passes` in the header above gives one.

/// All that this processor runs, the default first.
std::vector<const Passes*> runnable_passes();
/// Those of its best instruction set, the default first.
std::vector<const Passes*> passes_to_choose_from();
/// What TWINWAKE_ISA names ("default" the default); null where it is not set. Throws InputError for a variant that this
/// processor cannot run.
const Passes* passes_asked_for();

}  // namespace tw
