// The tyre dropped on a film of water: docs/results/tyre.md.
#include <gtest/gtest.h>

#include <algorithm>

#include "study_run.h"

namespace tw::test {
namespace tyre_test {

/// Water that is caught between rubber and floor stays a particle thick; where rubber meets the tank's own floor it is
/// pressed to 130 % of its density after 13.8 ms, and the run stops.
TEST(TyreDrop, PressesTheFloorThroughTheWaterThatStaysUnderIt) {
    const StudyRun run = run_study("tyre_drop_50", 0.015);
    ASSERT_EQ(run.record.state, "finished") << run.record.reason;
    const Table& tyre = run.record.tables.at(body_table("tyre"));
    const std::vector<double>& floor = tyre.find("floor_force")->values;
    const auto met = std::ranges::find_if(floor, [](double force) { return force > 0; }) - floor.begin();
    EXPECT_NEAR(tyre.time.at(static_cast<std::size_t>(met)), 0.0067, 0.0005) << "free fall through 20 mm of 24";
    EXPECT_GT(floor.back(), 1000) << "the tyre's inner pressure over what has grown flat";
    const double film = run.scene.domain.box.min.z() + run.scene.resolution.near_hull;
    EXPECT_NEAR(std::ranges::min(tyre.find("lowest")->values), film, run.scene.resolution.near_hull / 8)
        << "what the floor's penalty lets in";
    const std::vector<double>& mass = run.record.tables.at("samples").find("mass")->values;
    EXPECT_NEAR(mass.back() / mass.front(), 1, 1e-9);
}

}  // namespace tyre_test
}  // namespace tw::test
