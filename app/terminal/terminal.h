#pragma once
#include <cstddef>
#include <string>

namespace tw::app {

/// Whether a line can be written over there: a terminal, and not one that says of itself that it is dumb.
bool is_terminal(int descriptor);
/// Columns of the terminal now; where it does not say, those of the environment variable COLUMNS, else 80.
std::size_t terminal_columns(int descriptor);
/// The beginning of a line of UTF-8 text that is shorter than so many columns; a cut is shown by "...".
std::string fitted(const std::string& line, std::size_t columns);

}  // namespace tw::app
