// interFoam's run when twinwake crashes at a step of writing: its case, its dictionaries, its record.
#include <sys/wait.h>

#include "../runs/first_difference.h"
#include "base/atomic_file.h"
#include "foam_test.h"

namespace tw {
namespace foam_crashes_test {

constexpr int crashed = 9;
class FoamCrash : public FoamTest {
protected:
    void TearDown() override {
        before_write_step = nullptr;
        FoamTest::TearDown();
    }
};

int steps = 0;  ///< of writing: counted, or left before a crash

// interFoam was not at work in any of these moments, so what is gone on with is not its restart, and the bits are those
// of the undisturbed run. Kills while it is at work: foam_failures_test.cpp.
TEST_F(FoamCrash, AtAStepOfWritingLosesNothing) {
    const Scene s = scene(dam_break("0.06 s"));
    RunOptions o = options();
    o.folder = folder / "whole";
    before_write_step = [] { ++steps; };
    const RunRecord whole = run_fvm(s, o);
    const int all = steps;
    ASSERT_EQ(whole.state, "finished");
    ASSERT_GT(all, 60);

    // Four of them, one for each of a file's four steps.
    o.folder = folder / "part";
    for (int step = all / 8; step < all; step += all / 16 * 4 + 1) {
        std::filesystem::remove_all(o.folder);
        steps = step;
        before_write_step = [] {
            if (steps-- == 0) ::_exit(crashed);
        };
        const pid_t child = ::fork();
        if (child == 0) {
            run_fvm(s, o);
            ::_exit(0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        before_write_step = nullptr;
        EXPECT_EQ(WEXITSTATUS(status), crashed) << step;
        RunOptions resume = o;
        resume.resume = true;
        const RunRecord rest = run_fvm(s, resume);
        EXPECT_EQ(rest.state, "finished") << step;
        EXPECT_EQ(test::first_difference(whole, rest), "") << "crashed after " << step << " of " << all;
        EXPECT_EQ(test::first_difference(whole, read_record(o.folder / "record.h5")), "") << step;
    }
}

// All is read then, and the last thing to be written is the record that says so.
TEST_F(FoamCrash, BeforeTheLastRecordTheHullKeepsItsPressure) {
    const Scene s = scene(drowned_box("0.1", "0.05"));
    RunOptions o = options();
    o.folder = folder / "whole";
    steps = 0;
    before_write_step = [] { ++steps; };
    const RunRecord whole = run_fvm(s, o);
    ASSERT_EQ(whole.state, "finished");
    ASSERT_FALSE(whole.hull_pressure.empty());
    const int at = steps - 4;
    o.folder = folder / "part";
    steps = at;
    before_write_step = [] {
        if (steps-- == 0) ::_exit(crashed);
    };
    const pid_t child = ::fork();
    if (child == 0) {
        run_fvm(s, o);
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    before_write_step = nullptr;
    ASSERT_EQ(WEXITSTATUS(status), crashed);
    ASSERT_EQ(read_record(o.folder / "record.h5").state, "running");
    o.resume = true;
    const RunRecord rest = run_fvm(s, o);
    EXPECT_EQ(rest.state, "finished");
    EXPECT_EQ(test::first_difference(whole, rest), "");
    EXPECT_EQ(test::first_difference(whole, read_record(o.folder / "record.h5")), "");
}

}  // namespace foam_crashes_test
}  // namespace tw
