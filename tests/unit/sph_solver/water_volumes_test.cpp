// The water in a box, counted from the particles.
#include <gtest/gtest.h>

#include "tests/run_of.h"
#include "tests/still_block_scene.h"

namespace tw {
namespace water_volumes_test {

TEST(WaterVolumes, AreThoseOfAStillBlockCutByTheBox) {
    const RunRecord record = run_of(still_block_scene, "water_volumes_test");
    ASSERT_EQ(record.tables.at(volume_table).time.front(), 0);
    expect_volumes_of_still_block(record, 1e-7);  // places are multiples of dp/2^18
    // weight compresses the particles, and takes no water away
    EXPECT_NEAR(record.series(volume_table, "all")->values.back(), 0.08, 1e-9);
}

}  // namespace water_volumes_test
}  // namespace tw
