#pragma once
#include <string>
#include <vector>

#include "compare/ladder/ladder.h"

namespace tw {

/// What the sizes of side `k` say of one quantity: its values, their discretisation error, what other choices change,
/// and what accuracy costs. `scale`: the quantity's own, below which no change of the box is relative to the value.
LadderValue value_of(const std::vector<LadderSide>& sides, std::size_t k, const std::string& name, double scale);

}  // namespace tw
