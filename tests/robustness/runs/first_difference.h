#pragma once
#include <string>

#include "record/run_record.h"

namespace tw::test {

/// What differs first between the series, raster frames and sizes of two runs, to the last bit; empty when nothing
/// does. NaN equals the same NaN.
std::string first_difference(const RunRecord& a, const RunRecord& b);

}  // namespace tw::test
