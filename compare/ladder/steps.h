#pragma once
#include <string>
#include <vector>

#include "compare/ladder/ladder.h"

namespace tw {

// The steps in which build_ladder makes a ladder: sides.cpp, value.cpp, held.cpp, verdict.cpp.

/// The runs by method, in the order of methods() and others behind them by name; finest first. Throws InputError: two
/// runs of one method with one spacing, or of two families.
std::vector<LadderSide> sides_of(std::vector<LadderRun> runs);
/// Puts a variation beside the run that it varies. Throws InputError: there is none.
void add_variation(std::vector<LadderSide>& sides, LadderVariation variation);

/// What the sizes of side `k` say of one quantity: its values, their discretisation error, what other choices change,
/// and what accuracy costs. `scale`: the quantity's own, below which no change of the box is relative to the value.
LadderValue value_of(const std::vector<LadderSide>& sides, std::size_t k, const std::string& name, double scale);

/// Low and high of x, y, z of the run's domain; of x, z in two dimensions [m].
std::vector<double> domain_of(const RunRecord& record);
/// Holds the ladder's values against a measured record, within the time that its runs cover. Throws InputError: of
/// another hull, another tank, or in another unit.
void add_measured(Ladder& ladder, const RunRecord& record);
/// Holds them against the formulas of the finest run that has some: the same formula says the same of every size.
void add_references(Ladder& ladder);

/// The verdict on one quantity whose values are known, its reason, and the time of runs that would decide it (the rule
/// stands at build_ladder). `target`: share of the size that the joint interval may have; `scale`: least size.
void judge(LadderQuantity& quantity, const std::vector<LadderSide>& sides, double target, double scale);

}  // namespace tw
