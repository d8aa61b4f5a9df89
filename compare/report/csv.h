#pragma once
#include <string>

#include "compare/compare.h"

namespace tw {

/// One row per quantity: name, unit, value and interval per source, difference, interval, per cent, verdict.
std::string quantities_csv(const Comparison& comparison);
/// Long form: source, table, column, unit, time, value; forces thinned to at most 5000 rows per column.
std::string series_csv(const Comparison& comparison);

}  // namespace tw
