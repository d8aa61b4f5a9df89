#pragma once
#include "compare/compare.h"

namespace tw {

/// Splash heights, airborne water, envelope, wake width and elevation cuts of a comparison whose analyses are filled.
void add_splash(Comparison& comparison, const CompareOptions& options);
void add_elevation(Comparison& comparison, const CompareOptions& options);

/// Splash table, elevation map and cuts, envelope of one record.
Analysis analyse(const RunRecord& record);

}  // namespace tw
