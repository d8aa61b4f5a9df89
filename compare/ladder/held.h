#pragma once
#include "compare/ladder/ladder.h"

namespace tw {

/// Low and high of x, y, z of the run's domain; of x, z in two dimensions [m].
std::vector<double> domain_of(const RunRecord& record);
/// Holds the ladder's values against a measured record, within the time that its runs cover. Throws InputError: of
/// another hull, another tank, or in another unit.
void add_measured(Ladder& ladder, const RunRecord& record);
/// Holds them against the formulas of the finest run that has some: the same formula says the same of every size.
void add_references(Ladder& ladder);

}  // namespace tw
