// What memory the ranks of one run take.
#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "program.h"
#include "ranks_run.h"
#include "record/run_record.h"

namespace tw::test {
namespace ranks_memory_test {

using namespace ranks_test;

/// Peaks of all ranks together [bytes] for each particle more, in some steps from the start on.
double bytes_a_particle(const fs::path& scene, const fs::path& folder, int ranks) {
    const auto made = [&](const char* near_hull) {
        fs::create_directories(folder / near_hull);
        return read_record(run(scene, folder / near_hull, ranks, {"--near-hull", near_hull}) / "record.h5");
    };
    const RunRecord few = made("80mm"), many = made("20mm");
    return (many.peak_memory - few.peak_memory) / (many.elements - few.elements);
}

/// The first rank makes all particles, and each of the others holds its own from the first on. Were all made by each,
/// four ranks would take nearly four times as much.
TEST_F(Ranks, OnlyTheFirstHoldsAllParticlesAtTheStart) {
    const ScratchFolder folder("ranks_memory");
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, R"(
[tank]
size = [2, 1, 1.2]
[motion]
kind = "none"
[[water_block]]
min = [0, 0, 0]
max = [1, 1, 1]
[resolution]
near_hull = 0.02
[run]
duration = 0.0005
)");
    const double one = bytes_a_particle(scene, folder.path(), 1), four = bytes_a_particle(scene, folder.path(), 4);
    EXPECT_GT(one, 300);
    EXPECT_LT(four, 2 * one);
}

}  // namespace ranks_memory_test
}  // namespace tw::test
