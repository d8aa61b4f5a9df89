// A grid study of jobs that is killed again and again, at random moments.
#include <chrono>
#include <random>
#include <sstream>
#include <thread>

#include "study_folder.h"

namespace tw::test {
namespace killed_grid_study_test {

using Words = std::vector<std::string>;

/// A process and all that it has begun, at once, as when a machine loses its power.
void kill_with_children(pid_t process) {
    kill(process, SIGSTOP);  // it begins no more
    const std::string id = std::to_string(process);
    std::istringstream children(content("/proc/" + id + "/task/" + id + "/children"));
    for (pid_t child; children >> child;) kill_with_children(child);
    kill(process, SIGKILL);
}

TEST_F(Command, AGridStudyOfJobsKilledTenTimesEndsInTheReportOfAnUndisturbedOne) {
    write("column.toml", with(small_column, "duration = 0.1\ncheckpoint = 0.02", "duration = 2\ncheckpoint = 0.1"));
    const auto grid_study = [](const std::string& out) {
        return Words{"ladder",          "column.toml", "--levels", "3",     "--no-fill",
                     "--no-variations", "--jobs",      "2",        "--out", out};
    };
    const auto begun = std::chrono::steady_clock::now();
    ASSERT_EQ(twinwake(grid_study("whole")).status, 0);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - begun;

    // Ten times a twelfth in the mean: the grid study is not finished before the last kill, however slow the machine.
    std::mt19937 lot(20261127);
    std::uniform_real_distribution<double> share(0, 1.0 / 6);
    int killed = 0;
    for (int k = 0; k < 10; ++k) {
        const Started run = start(grid_study("killed"));
        std::this_thread::sleep_for(share(lot) * whole);
        kill_with_children(run.child);
        const Outcome o = finish(run);
        if (o.status == 128 + SIGKILL)
            ++killed;
        else
            EXPECT_EQ(o.status, 0) << o.err;
    }
    EXPECT_GE(killed, 5);
    const Outcome last = twinwake(grid_study("killed"));
    ASSERT_EQ(last.status, 0) << last.err;
    expect_same_records(folder_ / "whole", folder_ / "killed");
    expect_same_tables(folder_ / "whole", folder_ / "killed");
}

}  // namespace killed_grid_study_test
}  // namespace tw::test
