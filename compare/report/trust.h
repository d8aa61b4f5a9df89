#pragma once
#include <string>
#include <vector>

#include "compare/compare.h"

namespace tw {

/// What a reader has to know before trusting the numbers, one line each.
struct Doubt {
    bool grave = false;  ///< a check that is not met, or a reference that every method misses; else something to know
    std::string text;
};

/// In this order: references outside the interval of every method, then of one of them (the interval is the root of the
/// squares of the value's and the reference's); checks that are not met; what stands on top of the report.
std::vector<Doubt> doubts_of(const Comparison& comparison);

}  // namespace tw
