#pragma once
#include <set>
#include <string>

#include "compare/compare.h"

namespace tw {

/// The height gauges of all records before and behind what is in the waves between them, obstacles and bodies where they are
/// at the start, by the way that the wave runs (numbers height_x_GAUGE; obstacle_x_min_NAME, obstacle_x_max_NAME,
/// body_x_min_NAME, body_x_max_NAME; wave_direction). One counts that has gauges on both of its sides; of several, what lies
/// between the first and the last of them is neither before nor behind. Where none does, as where a slope ends the tank,
/// and in oblique waves (number wave_across), all gauges are before and none behind.
struct GaugeSides {
    std::set<std::string> before, behind;
};
GaugeSides gauge_sides(const Comparison& comparison);

}  // namespace tw
