// Runs of a study side by side on this machine: --jobs.
#include <chrono>
#include <thread>

#include "study_folder.h"

namespace tw::test {
namespace jobs_test {

using Words = std::vector<std::string>;

Words grid_study_of(const std::string& scene, const std::string& out, const Words& more = {}) {
    Words words{"ladder", scene, "--levels", "3", "--no-fill", "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST_F(Command, AGridStudyOfJobsLeavesTheSameRecordsAndReportAsOneByOne) {
    write("column.toml", small_column);
    ASSERT_EQ(twinwake(grid_study_of("column.toml", "one", {"--json", "one.json"})).status, 0);
    const Outcome two = twinwake(grid_study_of("column.toml", "two", {"--jobs", "2"}));
    ASSERT_EQ(two.status, 0) << two.err;
    EXPECT_EQ(records_below(folder_ / "one").size(), 5u);
    expect_same_records(folder_ / "one", folder_ / "two");
    EXPECT_EQ(content(folder_ / "one/ladder_sph.csv"), content(folder_ / "two/ladder_sph.csv"));
    EXPECT_TRUE(has(two.err, "runs: 100 %  5 of 5 runs")) << two.err;  // one display for all
    // The report can be made again from what is there, and nothing is run for it.
    fs::remove(folder_ / "two/ladder_sph.csv");
    const auto written = fs::last_write_time(folder_ / "two/near_hull_30mm/sph/record.h5");
    ASSERT_EQ(twinwake(grid_study_of("column.toml", "two", {"--collect"})).status, 0);
    EXPECT_EQ(content(folder_ / "one/ladder_sph.csv"), content(folder_ / "two/ladder_sph.csv"));
    EXPECT_EQ(fs::last_write_time(folder_ / "two/near_hull_30mm/sph/record.h5"), written);
}

TEST_F(Command, ARunOfJobsMakesItsTwinsAndItselfWithTheSameBits) {
    write("column.toml", small_column);
    ASSERT_EQ(twinwake({"run", "column.toml", "--out", "one"}).status, 0);
    const Outcome two = twinwake({"run", "column.toml", "--out", "two", "--jobs", "3"});
    ASSERT_EQ(two.status, 0) << two.err;
    EXPECT_EQ(records_below(folder_ / "one").size(), 3u);
    expect_same_records(folder_ / "one", folder_ / "two");
    EXPECT_EQ(content(folder_ / "one/quantities.csv"), content(folder_ / "two/quantities.csv"));
}

TEST_F(Command, AMemberThatFailsIsNamedAndTheOthersAreMade) {
    write("column.toml", small_column);
    // Where its record is to be written first stands a folder.
    write("out/near_hull_42.4264mm/sph/record.h5.tmp/in/the/way", "");
    const Outcome o = twinwake(grid_study_of("column.toml", "out", {"--jobs", "2", "--no-variations"}));
    EXPECT_EQ(o.status, 3) << o.err;
    EXPECT_TRUE(has(o.err, "SPH at 0.0424264 m: failed: ")) << o.err;
    EXPECT_TRUE(has(content(folder_ / "out/ladder.md"), "SPH at 0.0424264 m: failed: "));
    EXPECT_EQ(read_record(folder_ / "out/near_hull_30mm/sph/record.h5").state, "finished");
}

/// A run's answer rests on its coarser members: one that failed, or was killed, is no success.
TEST_F(Command, ATwinThatFailsShowsInTheExitStatus) {
    write("column.toml", small_column);
    for (const Words& jobs : {Words{"--jobs", "2"}, Words{}}) {
        const std::string out = jobs.empty() ? "one" : "two";
        write(out + "/twins/near_hull_42.4264mm/sph/record.h5.tmp/in/the/way", "");
        Words words{"run", "column.toml", "--out", out};
        words.insert(words.end(), jobs.begin(), jobs.end());
        const Outcome o = twinwake(words);
        EXPECT_EQ(o.status, 3) << o.err;
        EXPECT_TRUE(has(o.err, "0.0424264 m: failed: ")) << o.err;
        EXPECT_EQ(read_record(folder_ / out / "sph/record.h5").state, "finished");
    }
}

TEST_F(Command, JobsThatAreInterruptedSaveAndTheSameCommandGoesOnToTheSameBits) {
    write("column.toml", with(small_column, "duration = 0.1\ncheckpoint = 0.02", "duration = 4\ncheckpoint = 0.5"));
    const Words command = grid_study_of("column.toml", "out", {"--jobs", "2", "--no-variations"});
    const Started run = start(command);
    const fs::path checkpoint = folder_ / "out/near_hull_30mm/sph/checkpoint.h5";
    for (int k = 0; k < 6000 && !fs::exists(checkpoint); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(run.child, SIGINT);
    const Outcome stopped = finish(run);
    EXPECT_EQ(stopped.status, 3);
    EXPECT_TRUE(has(stopped.err, "stopped on request; the same command continues")) << stopped.err;
    EXPECT_EQ(read_record(folder_ / "out/near_hull_30mm/sph/record.h5").state, "stopped");
    ASSERT_EQ(twinwake(command).status, 0);
    ASSERT_EQ(twinwake(grid_study_of("column.toml", "whole", {"--no-variations"})).status, 0);
    expect_same_records(folder_ / "whole", folder_ / "out");
}

TEST_F(Command, ABudgetHoldsForJobsByWhatIsPredicted) {
    write("column.toml", small_column);
    const Outcome o = twinwake(grid_study_of("column.toml", "out", {"--jobs", "2", "--budget", "0.25 s"}));
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(has(o.out, "SPH at 0.03 m: left out, ")) << o.out;
    EXPECT_FALSE(fs::exists(folder_ / "out/near_hull_30mm"));
    EXPECT_TRUE(fs::exists(folder_ / "out/near_hull_60mm/sph/record.h5"));
}

TEST_F(Command, AMemberIsRefusedByNumberAndByFolder) {
    EXPECT_TRUE(has(twinwake({"member", "nowhere", "0"}).err, "no study has been submitted or run with --jobs there"));
    write("out/study/study.json", "{\"out\": 3}");
    EXPECT_TRUE(has(twinwake({"member", "out", "0"}).err, "is not as this version writes it"));
    write("column.toml", small_column);
    EXPECT_EQ(twinwake(grid_study_of("column.toml", "out", {"--emit", "snakemake"})).status, 0);
    EXPECT_TRUE(has(twinwake({"member", "out", "5"}).err, "this study has 5 runs, numbered from 0"));
    ASSERT_EQ(twinwake({"member", "out", "0", "-q"}).status, 0);
    EXPECT_EQ(records_below(folder_ / "out").size(), 1u);
    const Outcome collected = twinwake(grid_study_of("column.toml", "out", {"--collect"}));
    EXPECT_EQ(collected.status, 3);
    EXPECT_TRUE(has(collected.err, "SPH at 0.03 m: not finished: not begun")) << collected.err;
}

}  // namespace jobs_test
}  // namespace tw::test
