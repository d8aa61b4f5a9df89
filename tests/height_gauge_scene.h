#pragma once
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "record/run_record.h"

namespace tw {

/// Still water 0.2 m deep round a bar, a pier, a drowned and a floating box, all fixed, in two dimensions, with a height
/// probe at each and one in free water; for both methods.
inline const char* const height_gauge_scene = R"(
[tank]
min = ["-1 m", 0, "-0.2 m"]
max = ["1 m", "20 mm", "0.1 m"]
[domain]
dimensions = 2
[[obstacle]]
name = "bar"
min = ["-0.6 m", -1, "-0.2 m"]
max = ["-0.2 m", 1, "-0.1 m"]
[[obstacle]]
name = "pier"
min = [0, -1, "-0.2 m"]
max = ["0.12 m", 1, "0.05 m"]
[[obstacle]]
name = "drowned"
min = ["0.3 m", -1, "-0.14 m"]
max = ["0.5 m", 1, "-0.06 m"]
[[obstacle]]
name = "afloat"
min = ["0.64 m", -1, "-0.06 m"]
max = ["0.8 m", 1, "0.04 m"]
[[probe]]
name = "bar"
height = ["-0.4 m", 0]
[[probe]]
name = "beside_bar"
height = ["-0.192 m", 0]
[[probe]]
name = "pier"
height = ["0.055 m", 0]
[[probe]]
name = "drowned"
height = ["0.41 m", 0]
[[probe]]
name = "afloat"
height = ["0.73 m", 0]
[[probe]]
name = "free"
height = ["0.9 m", 0]
[[probe]]
name = "bar_top"
pressure = ["-0.4 m", 0, "-0.1 m"]
[[probe]]
name = "pier_foot"
pressure = [0, 0, "-0.2 m"]
[[probe]]
name = "under"
pressure = ["0.72 m", 0, "-0.06 m"]
[[probe]]
name = "between_cells"
pressure = ["0.907 m", 0, "-0.107 m"]
[motion]
kind = "none"
[resolution]
near_hull = "20 mm"
[run]
duration = "40 ms"
[sampling]
interval = "20 ms"
)";

/// `off` [m]: what a method may miss still water by.
inline void expect_heights(const RunRecord& record, double off) {
    const auto last = [&](const char* gauge) { return record.series("height", gauge)->values.back(); };
    for (const char* gauge : {"bar", "beside_bar", "drowned", "free"}) EXPECT_NEAR(last(gauge), 0, off) << gauge;
    EXPECT_NEAR(last("pier"), 0.05, 1e-12) << "dry: its top";
    EXPECT_TRUE(std::isnan(last("afloat"))) << "a solid lies on the water: " << last("afloat");
}

}  // namespace tw
