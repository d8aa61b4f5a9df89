// A hull that is held beside other solids: its force is its own.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "record/run_record.h"
#include "tests/run_of.h"

namespace tw {
namespace hull_beside_solids_test {

/// In still water of two dimensions, a hull, a fixed box of the same size under water, and one that is moved.
constexpr auto scene = R"(
[hull]
shape  = "box"
length = "0.3 m"
beam   = "0.3 m"
height = "0.2 m"
draft  = "0.1 m"
[tank]
min = ["-0.8 m", "-0.1 m", "-0.6 m"]
max = ["0.8 m", "0.1 m", "0.2 m"]
[[obstacle]]
name = "sunk"
min = ["-0.7 m", "-0.1 m", "-0.5 m"]
max = ["-0.4 m", "0.1 m", "-0.4 m"]
[[body]]
name = "moved"
shape = "box"
length = "0.3 m"
beam = "1 m"
height = "0.1 m"
draft = "0.4 m"
position = ["0.5 m", 0]
motion = "prescribed"
law = "constant"
along = [0, 0, 1]
rate = "0.01 m/s"
[motion]
kind = "none"
[domain]
dimensions = 2
[resolution]
near_hull = "0.02 m"
[run]
duration = "0.6 s"
methods = ["sph"]
)";

double mean_of(const RunRecord& record, const std::string& table, const std::string& column) {
    const Table& t = record.tables.at(table);
    const std::vector<double>& values = t.find(column)->values;
    double sum = 0, time = 0;
    for (std::size_t i = 1; i < t.time.size(); ++i)
        sum += (t.time[i] - t.time[i - 1]) * values[i], time += t.time[i] - t.time[i - 1];
    return sum / time;
}

TEST(HullBesideSolids, IsLiftedByItsOwnBuoyancyAlone) {
    const RunRecord record = run_of(scene, "hull_beside_solids");
    ASSERT_EQ(record.state, "finished") << record.reason;
    const double buoyancy = 1000 * 9.81 * 0.3 * 0.1, hull = mean_of(record, "forces", "fz"),
                 body = mean_of(record, "body_moved", "fz");
    std::printf("lift over buoyancy: hull %.3f, body beside it %.3f\n", hull / buoyancy, body / buoyancy);
    // five particles in the draft; the sum over the three solids would be 3
    EXPECT_NEAR(hull / buoyancy, 1, 0.05);
    EXPECT_NEAR(body / buoyancy, 1, 0.05);
    EXPECT_EQ(record.tables.at("forces").find("fz_volume"), nullptr) << "a volume round the hull may hold the others";
}

}  // namespace hull_beside_solids_test
}  // namespace tw
