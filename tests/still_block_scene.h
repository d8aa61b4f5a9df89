#pragma once
#include <string>

#include <gtest/gtest.h>

#include "record/run_record.h"
#include "record/water_in_box.h"

namespace tw {

/// A block of still water 0.4 m long and 0.2 m high between the left wall of a flat tank and an obstacle, with boxes that
/// hold all of it, cut through the middle of particles and cells on two sides, and hold air alone; for both methods.
inline const char* const still_block_scene = R"(
[tank]
min = [0, 0, 0]
max = ["0.8 m", "20 mm", "0.4 m"]
[domain]
dimensions = 2
[[water_block]]
min = [0, 0, 0]
max = ["0.4 m", "20 mm", "0.2 m"]
[[obstacle]]
name = "wall"
min = ["0.4 m", -1, 0]
max = ["0.5 m", 1, "0.3 m"]
[[volume]]
name = "all"
min = [-1, -1, -1]
max = [2, 1, 1]
[[volume]]
name = "cut"
min = ["0.105 m", -1, "0.05 m"]
max = ["0.395 m", 1, "0.35 m"]
[[volume]]
name = "dry"
min = ["0.5 m", -1, 0]
max = ["0.8 m", 1, "0.4 m"]
[resolution]
near_hull = "20 mm"
[run]
duration = "20 ms"
[sampling]
interval = "10 ms"
)";

/// Of all rows, from 10 ms on; `off` [m2]: what a method's water may have moved by then, or its mesh's
/// solids differ from the scene's.
inline void expect_volumes_of_still_block(const RunRecord& record, double off) {
    const Table& t = record.tables.at(volume_table);
    ASSERT_GE(t.time.size(), 1u);
    EXPECT_EQ(t.find("all")->unit, "m3/m");
    for (std::size_t row = 0; row < t.time.size(); ++row) {
        EXPECT_NEAR(t.find("all")->values[row], record.series("samples", "mass")->values[row] / 1000, 1e-9);
        EXPECT_NEAR(t.find("all")->values[row], 0.4 * 0.2, off);
        EXPECT_NEAR(t.find("cut")->values[row], 0.29 * 0.15, off);
        EXPECT_NEAR(t.find("dry")->values[row], 0, 1e-12);
    }
}

}  // namespace tw
