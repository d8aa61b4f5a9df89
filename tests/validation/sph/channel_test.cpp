// A uniform stream between inlet and outlet, with nothing in it, has to stay a uniform stream with a flat surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study_run.h"

namespace tw::test {
namespace {

TEST(EmptyChannel, SurfaceStaysFlatAndNothingIsLost) {
    const StudyRun run = run_study("empty_channel", 2.0);
    ASSERT_EQ(run.record.state, "finished") << run.record.reason;
    const Table& height = run.record.tables.at("height");
    ASSERT_FALSE(height.columns.empty());
    for (const Column& probe : height.columns)
        EXPECT_LT(std::abs(mean_from(height, probe, 0.5 * height.time.back()) - still_level(run.scene)), 0.1 * run.dp()) << probe.name;

    const Column* lost = run.record.series("samples", "particles_lost");
    ASSERT_TRUE(lost);
    EXPECT_EQ(lost->values.back(), 0);
    // What flows in flows out: the mass in the channel stays, though particles come and go all the time.
    const Column *mass = run.record.series("samples", "mass"), *in = run.record.series("samples", "particles_in");
    ASSERT_TRUE(mass && in);
    EXPECT_NEAR(mass->values.back() / mass->values.front(), 1, 0.01);
    EXPECT_GT(in->values.back(), run.record.elements);
}

}  // namespace
}  // namespace tw::test
