#pragma once
#include <vector>

#include "compare/ladder/ladder.h"

namespace tw {

/// The runs by method, in the order of methods() and others behind them by name; finest first. Throws InputError: two
/// runs of one method with one spacing, or of two families.
std::vector<LadderSide> sides_of(std::vector<LadderRun> runs);
/// Puts a variation beside the run that it varies. Throws InputError: there is none.
void add_variation(std::vector<LadderSide>& sides, LadderVariation variation);

}  // namespace tw
