#pragma once
#include <vector>

#include "compare/ladder/ladder.h"

namespace tw {

/// The runs by method, SPH and FVM in this order and others behind them by name; finest first. Throws InputError: two
/// runs of one method with one spacing, or of two families, and more than two methods.
std::vector<LadderSide> sides_of(std::vector<LadderRun> runs);
/// Puts a variation beside the run that it varies. Throws InputError: there is none.
void add_variation(std::vector<LadderSide>& sides, LadderVariation variation);

}  // namespace tw
