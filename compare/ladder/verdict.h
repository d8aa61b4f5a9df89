#pragma once
#include <vector>

#include "compare/ladder/ladder.h"

namespace tw {

/// The verdict on one quantity whose values are known, its reason, and the time of runs that would decide it (the rule
/// stands at build_ladder). `target`: share of the size that the joint interval may have; `scale`: least size.
void judge(LadderQuantity& quantity, const std::vector<LadderSide>& sides, double target, double scale);

}  // namespace tw
