// The force by control volume where the water's weight on the floor of the volume is many times the force.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/run_of.h"

namespace tw {
namespace control_volume_test {

constexpr auto still_tank = R"(
[hull]
shape  = "box"
length = "0.4 m"
beam   = "0.4 m"
height = "0.4 m"
draft  = "0.7 m"
[tank]
min = ["-0.8 m", "-0.8 m", "-1 m"]
max = ["0.8 m", "0.8 m", "0.2 m"]
[motion]
kind = "none"
[resolution]
near_hull = "0.05 m"
[run]
duration = "0.8 s"
methods = ["sph"]
[sampling]
mean_from = "0.4 s"
)";

// 0.64 m3 of water stand in the volume round a box of 0.064 m3. With whole layers of particles counted on its floor the
// buoyancy came out 4.4 % too large (docs/decisions/058).
TEST(ControlVolumeOfABox, InStillWaterHasTheBuoyancyOfArchimedes) {
    const RunRecord record = run_of(still_tank, "control_volume_of_a_box");
    ASSERT_EQ(record.state, "finished") << record.reason;
    const Table& forces = record.tables.at("forces");
    double sum = 0;
    int rows = 0;
    for (std::size_t i = 0; i < forces.time.size(); ++i) {
        const double force = forces.find("fz_volume")->values[i];
        if (forces.time[i] > 0.4 && std::isfinite(force)) sum += force, ++rows;
    }
    ASSERT_GT(rows, 2);
    const double buoyancy = 1000 * 9.81 * 0.4 * 0.4 * 0.4;
    std::printf("by control volume %.1f N, rho g V %.1f N\n", sum / rows, buoyancy);
    EXPECT_NEAR(sum / rows / buoyancy, 1, 0.02);
}

}  // namespace control_volume_test
}  // namespace tw
