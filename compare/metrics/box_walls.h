#pragma once
#include <string>
#include <vector>

#include "compare/compare.h"

namespace tw {

/// Whether the sides beside the hull are meant: a channel (attribute `channel`).
bool in_a_channel(const Comparison& comparison);

/// What the records expect the walls of the box to do to the loads (attribute `box_walls`), and that the values are
/// those of a channel, where it is one.
void add_box(Comparison& comparison);

/// All that stands on top of the report: the comparison's own warnings, that its values are those of its box, and what
/// was tuned.
std::vector<std::string> all_banners(const Comparison& comparison);

}  // namespace tw
