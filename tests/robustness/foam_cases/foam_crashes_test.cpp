// interFoam's run when twinwake crashes at a step of writing: its case, its dictionaries, its record.
#include <sys/wait.h>

#include "../runs/first_difference.h"
#include "base/atomic_file.h"
#include "foam_test.h"

namespace tw {
namespace foam_crashes_test {

constexpr int crashed = 9;
int steps = 0;  ///< of writing: counted, or left before a crash

class FoamCrash : public FoamTest {
protected:
    void TearDown() override {
        before_write_step = nullptr;
        FoamTest::TearDown();
    }
    RunOptions in(const char* name) const {
        RunOptions o = options();
        o.folder = folder / name;
        return o;
    }
    /// An undisturbed run, whose steps of writing are counted.
    RunRecord whole_run(const Scene& scene) const {
        steps = 0;
        before_write_step = [] { ++steps; };
        return run_fvm(scene, in("whole"));
    }
    /// A run that crashes at a step of writing. Whether it did.
    static bool crashes_at(int step, const Scene& scene, const RunOptions& options) {
        steps = step;
        before_write_step = [] {
            if (steps-- == 0) ::_exit(crashed);
        };
        const pid_t child = ::fork();
        if (child == 0) {
            run_fvm(scene, options);
            ::_exit(0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        before_write_step = nullptr;
        return WIFEXITED(status) && WEXITSTATUS(status) == crashed;
    }
    /// Goes on from there, to the very record of the undisturbed run.
    static void expect_the_same(const RunRecord& whole, const Scene& scene, RunOptions options) {
        options.resume = true;
        const RunRecord rest = run_fvm(scene, options);
        EXPECT_EQ(rest.state, "finished");
        EXPECT_EQ(test::first_difference(whole, rest), "");
        EXPECT_EQ(test::first_difference(whole, read_record(options.folder / "record.h5")), "");
    }
};

// interFoam was not at work in any of these moments, so what is resumed is not its own restart, and the bits are those
// of the undisturbed run. Kills while it is at work: foam_failures_test.cpp.
TEST_F(FoamCrash, AtAStepOfWritingLosesNothing) {
    const Scene s = scene(dam_break("0.06 s"));
    const RunRecord whole = whole_run(s);
    const int all = steps;
    ASSERT_EQ(whole.state, "finished");
    ASSERT_GT(all, 60);

    // Four of them, one for each of a file's four steps.
    for (int step = all / 8; step < all; step += all / 16 * 4 + 1) {
        SCOPED_TRACE(step);
        const RunOptions part = in("part");
        std::filesystem::remove_all(part.folder);
        EXPECT_TRUE(crashes_at(step, s, part)) << "of " << all;
        expect_the_same(whole, s, part);
    }
}

// All is read then, and the last thing to be written is the record that says so.
TEST_F(FoamCrash, BeforeTheLastRecordTheHullKeepsItsPressure) {
    const Scene s = scene(drowned_box("0.1", "0.05"));
    const RunRecord whole = whole_run(s);
    ASSERT_EQ(whole.state, "finished");
    ASSERT_FALSE(whole.hull_pressure.empty());
    const RunOptions part = in("part");
    ASSERT_TRUE(crashes_at(steps - 4, s, part));
    ASSERT_EQ(read_record(part.folder / "record.h5").state, "running");
    expect_the_same(whole, s, part);
}

}  // namespace foam_crashes_test
}  // namespace tw
