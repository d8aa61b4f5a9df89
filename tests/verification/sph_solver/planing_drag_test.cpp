// Without friction, and with a dry transom, the water presses on a planing prism's bottom only: its drag is its lift
// times the tangent of the trim, exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/run_of.h"

namespace tw {
namespace planing_drag_test {

const char* const prism_at_beam_10 = R"(
[hull]
shape = "prismatic"
length = "4 m"
beam = "1 m"
deadrise = "20 deg"
trim = "5 deg"
draft = "0.2 m"
half = true
[motion]
speed = "8 m/s"
ramp = "0.15 s"
[resolution]
near_hull = "0.1 m"
[domain]
x = ["-3 m", "4.5 m"]
y = ["-1.4 m", "1.4 m"]
z = ["-1.2 m", "2 m"]
[run]
duration = "0.5 s"
[sampling]
interval = "0.05 s"
)";

TEST(PlaningPrism, DragIsLiftTimesTheTangentOfTheTrim) {
    const RunRecord record = run_of(prism_at_beam_10, "planing_drag");
    ASSERT_EQ(record.state, "finished") << record.reason;

    const Table& forces = record.tables.at("forces");
    const Column &fx = *forces.find("fx"), &fz = *forces.find("fz");
    double drag = 0, lift = 0;
    for (std::size_t i = 0; i < forces.time.size(); ++i)
        if (forces.time[i] > 0.3) drag += fx.values[i], lift += fz.values[i];
    const double share = drag / (lift * std::tan(5 * std::numbers::pi / 180));
    std::printf("drag over lift times tan 5 degrees: %.3f\n", share);
    EXPECT_NEAR(share, 1, 0.04)
        << "found 0.997 here; 0.85 where water before an edge was driven out, 0.76 where that beyond was";
}

}  // namespace planing_drag_test
}  // namespace tw
