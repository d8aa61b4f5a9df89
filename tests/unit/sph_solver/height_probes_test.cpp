// Height probes over and beside solids in still water, read from the particles.
#include <gtest/gtest.h>

#include "tests/height_gauge_scene.h"
#include "tests/run_of.h"

namespace tw {
namespace height_probes_test {

TEST(HeightProbes, KnowTheSolidsThatStandInStillWater) {
    const RunRecord record = run_of(height_gauge_scene, "height_probes_test");
    // The kernel's support alone, which a solid's face halves, is 8 mm short over the bar and 4 mm more beside it.
    expect_heights(record, 1e-3);
}

}  // namespace height_probes_test
}  // namespace tw
