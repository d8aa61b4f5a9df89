#pragma once
#include <string>
#include <vector>

#include "base/numbers.h"
#include "compare/compare.h"

namespace tw {

/// The part of a plan's influence ("drag: ...; lift: ...; splash: ...; ...") that speaks of a quantity; empty: none.
std::string influence_on(const std::string& quantity, const std::string& influence);

/// Something that a run leaves out, so that no interval of its values contains it.
struct LeftOut {
    std::string name;       ///< of the effect, as people say it
    std::string influence;  ///< in short what the effect plan expects of it: "3 to 5 %"; empty: no plan speaks of it
    double bound = nan;     ///< the most that is expected [unit of the quantity]; nan: no number is given
};
/// What one run leaves out of a main quantity (sentence.h): effects that are off in its plan, but for those of which it
/// expects nothing (none, below 1 %, less than a thousandth, not measured). Friction counts as solved where the friction
/// line is added to the drag.
std::vector<LeftOut> left_out_of(const Quantity& quantity, const MeanValue& value, const RunRecord& run);

/// Half width of the outer interval of a value: root of the sum of squares of its interval and of the bounds of what its
/// run leaves out, each taken as a 95 % half width. nan: the value has no interval, or nothing left out has a bound.
double outer_half_width(const Quantity& quantity, const MeanValue& value, const RunRecord& run);

/// What stands in no interval of the main quantities, in one line, with the influences that have a bound: "air (drag
/// 10 %, lift 3 to 5 %), surface tension"; empty: nothing.
std::string left_out_text(const Comparison& comparison);

}  // namespace tw
