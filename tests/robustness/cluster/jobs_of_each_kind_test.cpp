// --jobs with every command that has runs of its own to make: a sweep, an ablation, a run with an interFoam member.
// For a grid study and a run of particles see jobs_test.cpp.
#include "foam_cases/doctor.h"
#include "study_folder.h"

namespace tw::test {
namespace jobs_of_each_kind_test {

using Words = std::vector<std::string>;

class JobsOfEachKind : public Command {
protected:
    void SetUp() override {
        Command::SetUp();
        setenv("TWINWAKE_OPENFOAM_BIN", TWINWAKE_SOURCE "/.openfoam/bin", 0);
    }
    /// The study one by one, and side by side: the same records and tables. `members`: how many runs it has.
    void expect_same_by_jobs(Words command, std::size_t members) const {
        const auto made = [&](const std::string& out, const Words& more) {
            Words words = command;
            words.insert(words.end(), {"--out", out});
            words.insert(words.end(), more.begin(), more.end());
            return twinwake(words);
        };
        const Outcome one = made("one", {}), two = made("two", {"--jobs", "2"});
        ASSERT_EQ(one.status, 0) << one.err;
        ASSERT_EQ(two.status, 0) << two.err;
        EXPECT_EQ(records_below(folder_ / "one").size(), members);
        expect_same_records(folder_ / "one", folder_ / "two");
        expect_same_tables(folder_ / "one", folder_ / "two");
        const std::string all = std::to_string(members);
        EXPECT_TRUE(has(two.err, "runs: 100 %  " + all + " of " + all + " runs")) << two.err;
        for (const char* own : {"SPH: 100 %", "interFoam: 100 %", "meshing"}) {
            EXPECT_FALSE(has(two.err, own)) << "a second display\n" << two.err;
            EXPECT_TRUE(has(one.err, own) || !has(own, "SPH")) << "or there is nothing to see here\n" << one.err;
        }
    }
};

TEST_F(JobsOfEachKind, AnAblationEndsAsOneByOne) {
    write("column.toml", small_column);
    expect_same_by_jobs({"ablate", "column.toml", "--effects", "shifting", "gravity"}, 3);
    EXPECT_TRUE(has(content(folder_ / "two/ablation.csv"), "gravity off,base,sph,"));
}

class JobsWithInterFoam : public JobsOfEachKind {
protected:
    void SetUp() override {
        JobsOfEachKind::SetUp();
        if (find_openfoam().empty()) GTEST_SKIP() << "no OpenFOAM is installed";
    }
};

TEST_F(JobsWithInterFoam, ARunEndsAsOneByOne) {
    write("dam.toml", R"(title = "dam break"
[tank]
size = [0.584, 0.0146, 0.4]
[domain]
dimensions = 2
[[water_block]]
min = [0, 0, 0]
max = [0.146, 0.0146, 0.292]
[resolution]
near_hull = 0.0292
[[probe]]
name = "wall"
pressure = [0, 0, 0.01]
[sampling]
interval = 0.02
[run]
duration = 0.06
threads = 1
)");
    expect_same_by_jobs({"run", "dam.toml", "--no-twins"}, 2);
}

TEST_F(JobsWithInterFoam, ASweepEndsAsOneByOne) {
    write("box.toml", R"(title = "box in a tank"
[hull]
shape = "box"
length = 0.4
beam = 0.4
height = 0.4
draft = 0.7
[tank]
min = [-0.8, -0.01, -1.2]
max = [0.8, 0.01, 0.6]
[domain]
dimensions = 2
[motion]
kind = "none"
[resolution]
near_hull = 0.1
spacing = 0.1
[sampling]
interval = 0.02
[run]
duration = 0.04
threads = 1
)");
    expect_same_by_jobs({"sweep", "box.toml", "--trims", "3 deg", "--twins", "none"}, 2);
    EXPECT_EQ(content(folder_ / "one/sweep.md"), content(folder_ / "two/sweep.md"));
}

}  // namespace jobs_of_each_kind_test
}  // namespace tw::test
