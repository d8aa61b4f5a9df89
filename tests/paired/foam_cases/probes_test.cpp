// Where interFoam's probes look: on walls and solids, and over them.
#include "foam_test.h"
#include "tests/height_gauge_scene.h"
#include "tests/still_block_scene.h"

namespace tw {
namespace probes_test {

using Probes = FoamTest;

TEST_F(Probes, KnowTheSolidsThatStandInStillWater) {
    const RunRecord r = run_fvm(scene(height_gauge_scene), options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    expect_heights(r, 1e-3);
    const auto pressure = [&](const char* probe) { return r.series("pressure", probe)->values.back(); };
    // Cells that the solids cut at the water line stir it by half a millimetre, 5 Pa; half a cell is 98 Pa.
    constexpr double stirred = 10;
    EXPECT_NEAR(pressure("bar_top"), 981, stirred);
    EXPECT_NEAR(pressure("pier_foot"), 1962, stirred) << "an edge of floor and solid";
    EXPECT_NEAR(pressure("between_cells"), 1049.7, stirred);
    EXPECT_NEAR(pressure("under"), 588.6, stirred);
}

TEST_F(Probes, WaterInABoxIsThatOfAStillBlock) {
    const RunRecord r = run_fvm(scene(still_block_scene), options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    expect_volumes_of_still_block(r, 2e-4);  // half a cell's width along one face is 1.5e-3
}

}  // namespace probes_test
}  // namespace tw
