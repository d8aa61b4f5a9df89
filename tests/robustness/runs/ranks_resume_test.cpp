// Runs that go on with another number of ranks, in which more than water moves.
#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "program.h"
#include "ranks_run.h"
#include "record/run_record.h"
#include "test_paths.h"

namespace tw::test {
namespace ranks_resume_test {

using namespace ranks_test;

constexpr const char* each_tenth = "[run]\nmethods = [\"sph\"]\nduration = 0.3\ncheckpoint = 0.1\n";

/// Its zone of finer particles goes with it, and zones at the ends of the tank absorb its waves.
TEST_F(Ranks, ABodyWithTwoSizesGoesOnWithAnotherNumberOfRanks) {
    const ScratchFolder folder("ranks_resume_body");
    goes_on_with_another_number_of_ranks(std::string(R"(
[tank]
min = [-1.6, 0, -0.4]
max = [1.6, 0.01, 0.4]
[domain]
dimensions = 2
[[body]]
name     = "box"
shape    = "box"
length   = 0.3
beam     = 1
height   = 0.2
position = [0.1, 0]
draft    = 0.02
trim     = "8 deg"
density  = 600
velocity = [0.5, 0, -1]
spin     = [0, 1, 0]
[motion]
kind = "none"
[effects]
forcing_zones = "on"
[resolution]
near_hull = 0.02
[sph]
levels = 2
zone = 8
[sampling]
interval = 0.05
)") + each_tenth,
                                         folder);
    EXPECT_GT(last(folder.path() / "ranks_1/sph", 1, "births"), 10);
}

TEST_F(Ranks, ABodyInAWaveGoesOnWithAnotherNumberOfRanks) {
    const ScratchFolder folder("ranks_resume_wave");
    const std::string text = read_text(fs::path(TWINWAKE_SOURCE) / "studies/box_heaving_in_waves.toml");
    goes_on_with_another_number_of_ranks(
        with(text, "near_hull = \"10 mm\"", "near_hull = \"18 mm\"\n[sampling]\ninterval = 0.05\n") + each_tenth,
        folder);
}

}  // namespace ranks_resume_test
}  // namespace tw::test
