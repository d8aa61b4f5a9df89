// Height probes over and beside solids in still water, read from the particles.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "sph_solver/run_sph.h"
#include "tests/height_gauge_scene.h"

namespace tw {
namespace height_gauges_test {

TEST(HeightGauges, KnowTheSolidsThatStandInStillWater) {
    const auto folder = std::filesystem::temp_directory_path() / "height_gauges_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "scene.toml") << height_gauge_scene;
    RunOptions options;
    options.folder = folder / "sph";
    options.threads = 1;
    const RunRecord record = run_sph(read_scene(folder / "scene.toml"), options);
    std::filesystem::remove_all(folder);
    // The kernel's support alone, which a solid's face halves, is 8 mm short over the bar and 4 mm more beside it.
    expect_heights(record, 1e-3);
}

}  // namespace height_gauges_test
}  // namespace tw
