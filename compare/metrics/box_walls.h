#pragma once
#include <string>

#include "compare/compare.h"

namespace tw {

/// Whether the sides beside the hull are meant: a channel (attribute `channel`).
bool in_a_channel(const Comparison& comparison);

/// Says on top of a comparison, and in Comparison::walls, what the walls of its box do, in place of what was said before;
/// empty: little.
void say_of_the_box(Comparison& comparison, std::string walls);

/// The same as the records expect it (attribute `box_walls`), and that the values are those of a channel, where it is one.
void add_box(Comparison& comparison);

}  // namespace tw
