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
    std::string influence;  ///< in short what is expected of it: "3 to 5 %"; empty: no plan speaks of it
    double bound = nan;     ///< the most that is expected, to the wider side [unit of the quantity]; nan: no number
    double below = 0, above = 0;  ///< distance of the truth below and above the value [unit], where there is a number
};
/// What one run leaves out of a quantity (quantity_kinds.h):
///
///   effects that are off in its plan, but for those of which it expects nothing (none, below 1 %, less than a thousandth,
///   not measured). What the plan bounds as numbers counts before its words. Not charged: gravity, which only the scene
///   can switch off, since a scene without weight is what was asked for; numerics and the compressibility of the particles
///   in other methods; friction where the friction line is added to the drag
///   the third dimension of a section
///   the gate: where water is let go at the start, when a measured one was free by its clock (gate_time)
///   the reading: what MeanValue::reading_below and reading_above say
std::vector<LeftOut> left_out_of(const Quantity& quantity, const MeanValue& value, const RunRecord& run);

/// A run lets its water go at once and at time 0. A real gate takes its time, and the clock of a measurement begins when
/// the gate begins to move, or when it is open: arrivals are known to 0.13 sqrt(H/g), H: height of the water. Three
/// measured fronts lag a front of ideal water by 0.21 to 0.26 sqrt(a/2g), H = 2a (docs/results/dam_break_pressure.md),
/// others lead (docs/results/coverage.md); a gate that opens in 1.25 sqrt(H/g) counts as sudden (Lauber & Hager 1998,
/// J. Hydraul. Res. 36, 291).
inline constexpr double gate_time = 0.13;

/// Half widths of the outer interval of a value, below and above it: root of the sum of squares of its interval and of
/// the bounds of what its run leaves out, each taken as a 95 % half width. nan: the value has no interval, or nothing left
/// out has a bound.
struct OuterInterval {
    double below = nan, above = nan;  ///< [unit]
};
OuterInterval outer_interval(const Quantity& quantity, const MeanValue& value, const RunRecord& run);
/// The wider of the two: half width of the interval about the value that holds the outer one.
double outer_half_width(const Quantity& quantity, const MeanValue& value, const RunRecord& run);

/// What stands in no interval of the main quantities, in one line, with the influences that have a bound: "air (drag
/// 10 %, lift 3 to 5 %), surface tension"; empty: nothing.
std::string left_out_text(const Comparison& comparison);

}  // namespace tw
