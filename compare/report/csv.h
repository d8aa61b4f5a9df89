#pragma once
#include <string>

#include "compare/compare.h"

namespace tw {

/// One cell by RFC 4180; what a spreadsheet would take for a formula is kept as text.
std::string csv_cell(const std::string& text);
/// One row per quantity: name, unit, value and interval per source, difference, interval, per cent, verdict.
std::string quantities_csv(const Comparison& comparison);
/// Long form: source, table, column, unit, time, value; forces thinned to at most 5000 rows per column.
std::string series_csv(const Comparison& comparison);

}  // namespace tw
