// Studies on a disk that lets them down: a grid study, and a run with its coarser members, are resumed to the same
// results after a crash at a step of writing, after SIGINT there, and after the disk was full from there on.
#include "study_folder.h"

namespace tw::test {
namespace crashed_studies_test {

using Words = std::vector<std::string>;

class CrashedStudy : public Command {
protected:
    void SetUp() override {
        Command::SetUp();
        write("column.toml", small_column);
    }
    void TearDown() override {
        unsetenv("LD_PRELOAD");
        unsetenv("TWINWAKE_DISK");
        Command::TearDown();
    }

    Outcome with_fault(const std::string& fault, const Words& command) const {
        setenv("LD_PRELOAD", TWINWAKE_FAULTY_DISK, 1);
        setenv("TWINWAKE_DISK", fault.c_str(), 1);
        const Outcome o = twinwake(command);
        unsetenv("LD_PRELOAD");
        return o;
    }
    /// The study with the fault at every `stride`-th step of writing, and then the command that goes on; `answer`: what
    /// is said to the fault. Returns the number of faults.
    int loses_nothing(const Words& command, const Words& going_on, const std::string& fault, const std::string& answer,
                      int stride) {
        const auto to = [](Words words, const std::string& out) {
            words.insert(words.end(), {"--out", out});
            return words;
        };
        EXPECT_EQ(twinwake(to(command, "whole")).status, 0);
        int faults = 0;
        for (int step = 1; !HasFailure(); step += stride) {
            fs::remove_all(folder_ / "part");
            const std::string at = fault + " " + std::to_string(step);
            const Outcome o = with_fault(at, to(command, "part"));
            if (o.status == 0) break;
            ++faults;
            EXPECT_TRUE(has(o.err, answer)) << at << " ended with " << o.status << "\n" << o.err;
            const Outcome rest = twinwake(to(going_on, "part"));
            EXPECT_EQ(rest.status, 0) << at << "\n" << rest.err;
            expect_same_records(folder_ / "whole", folder_ / "part");
            expect_same_tables(folder_ / "whole", folder_ / "part");
            for (const auto& file : fs::recursive_directory_iterator(folder_ / "part"))
                EXPECT_NE(file.path().extension(), ".tmp") << at << "\n" << file.path();
            if (HasFailure()) ADD_FAILURE() << at << "\n" << o.err << rest.err;
        }
        return faults;
    }

    const Words grid_study{"ladder", "column.toml", "--levels", "2", "--no-fill", "--no-variations"};
    const Words run{"run", "column.toml"}, resumed{"run", "column.toml", "--resume"};
};

// Strides are no multiples of three: each of a file's three steps takes its turn.

TEST_F(CrashedStudy, AGridStudyLosesNothing) { EXPECT_GT(loses_nothing(grid_study, grid_study, "crash", "", 25), 3); }

TEST_F(CrashedStudy, ARunWithTwinsLosesNothing) { EXPECT_GT(loses_nothing(run, resumed, "crash", "", 40), 3); }

TEST_F(CrashedStudy, AGridStudyThatIsInterruptedWhileItWritesGoesOn) {
    EXPECT_GT(loses_nothing(grid_study, grid_study, "interrupt", "stopped on request; the same command continues", 40),
              1);
}

TEST_F(CrashedStudy, AGridStudyWhoseDiskIsFullGoesOnWhenThereIsRoom) {
    EXPECT_GT(loses_nothing(grid_study, grid_study, "full", "cannot be written: No space left on device", 40), 1);
}

}  // namespace crashed_studies_test
}  // namespace tw::test
