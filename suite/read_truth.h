#pragma once
#include <set>

#include "suite/suite.h"
#include "text/section.h"

namespace tw {

/// Throws as Section::finish for the first key that is none of these. Before any getter: a misspelt key is then named
/// as such, and not by what is missing without it.
void refuse_others_than(const std::set<std::string>& known, Section section);

/// A size that may be given in per cent: "2 %" is a share of what it belongs to, anything else is in `unit`.
struct SizeOrShare {
    double size = nan;
    bool share = false;
    double of(double whole) const { return share ? size * std::abs(whole) : size; }
};
/// Nothing where the key is missing. `raw`: the section's table.
std::optional<SizeOrShare> size_or_share(Section& section, const TextValue& raw, const std::string& key,
                                         const std::string& unit);

/// Truth, its uncertainty, scale and goal of a quantity whose unit is known, from its section: `truth`, `formula` with
/// [parameters], `csv` with column and row, or `record`. Throws InputError.
void read_truth(Section& section, const TextValue& raw, SuiteQuantity& quantity);

}  // namespace tw
