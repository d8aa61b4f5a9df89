// Studies on a real Slurm: three nodes on this host, where they can be started (slurm_here.sh).
#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "sph_solver/parallel/comm.h"
#include "study_folder.h"

namespace tw::test {
namespace slurm_test {

using Words = std::vector<std::string>;

Words with_words(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

class Slurm : public Command {
protected:
    void SetUp() override {
        Command::SetUp();
        write("column.toml", small_column);
        setenv("XDG_CONFIG_HOME", (folder_ / "config").c_str(), 1);
        char name[] = "/tmp/tw_slurm_XXXXXX";  // sockets have short names
        cluster_ = mkdtemp(name);
        setenv("SLURM_CONF", (cluster_ / "slurm.conf").c_str(), 1);
        const int status = cluster("start", "> '" + (folder_ / "why").string() + "'");
        if (WEXITSTATUS(status) == 77) GTEST_SKIP() << content(folder_ / "why");
        ASSERT_EQ(status, 0);
    }
    void TearDown() override {
        cluster("stop");
        unsetenv("SLURM_CONF");
        fs::remove_all(cluster_);
        Command::TearDown();
    }

    int cluster(const std::string& action, const std::string& more = {}) const {
        return std::system(
            (TWINWAKE_SOURCE "/tests/robustness/cluster/slurm_here.sh " + action + " " + cluster_.string() + " " + more)
                .c_str());
    }
    /// Waits for the end of all jobs. False: they do not end.
    bool all_ended() const {
        const std::string ask = "[ -z \"$(squeue -h)\" ]";
        return happens([&] { return std::system(ask.c_str()) == 0; }, 200);
    }
    static bool happens(const std::function<bool()>& what, double seconds) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (!what()) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        return true;
    }
    /// What the jobs of a study said.
    std::string logs(const std::string& out) const {
        std::string text = content(folder_ / out / "study/report.log");
        for (int k = 0; k < 8; ++k) text += content(folder_ / out / "study/members" / (std::to_string(k) + ".log"));
        return text;
    }
    nlohmann::json status_of(const std::string& out) const {
        twinwake({"status", out, "--json", "status.json"});
        return nlohmann::json::parse(content(folder_ / "status.json"));
    }

    /// Stops each run of a study as soon as it has saved a state in its folder, so that it cannot end before what is to
    /// meet it; the processes, by its number. Those of `gone` are told to end already, and save once more. Throws
    /// std::runtime_error: one ended.
    std::vector<pid_t> stopped_when_saved(const std::vector<fs::path>& runs,
                                          const std::vector<pid_t>& gone = {}) const {
        std::vector<pid_t> stopped(runs.size(), 0), seen(runs.size(), 0);
        std::vector<fs::file_time_type> before(runs.size());
        const auto saved = [&](std::size_t k) {
            std::error_code not_there;
            return fs::last_write_time(folder_ / runs[k] / "checkpoint.h5", not_there);
        };
        const auto stop = [&](std::size_t k) {
            const pid_t now = member(k);
            if (now == 0 || std::ranges::find(gone, now) != gone.end()) return;
            if (now != seen[k]) {
                seen[k] = now;
                before[k] = saved(k);
            } else if (saved(k) != before[k]) {
                kill(now, SIGSTOP);
                stopped[k] = now;
            }
        };
        const bool all = happens(
            [&] {
                for (std::size_t k = 0; k < runs.size(); ++k)
                    if (stopped[k] == 0) stop(k);
                return std::ranges::find(stopped, 0) == stopped.end();
            },
            60);
        if (!all) throw std::runtime_error("a run ended before it could be stopped");
        return stopped;
    }
    /// Of a process by its folder in /proc; nothing: it ended meanwhile, which a stream that is being read reports so.
    static std::string command_of(const fs::path& process) {
        try {
            return content(process / "cmdline");
        } catch (const std::ios_base::failure&) { return {}; }
    }
    /// The process that makes run `number` of a study that was submitted here; 0: there is none.
    pid_t member(std::size_t number) const {
        const std::string words = std::string("member\0..\0", 10) + std::to_string(number) + '\0';
        for (const auto& entry : fs::directory_iterator("/proc")) {
            std::error_code gone;
            if (has(command_of(entry.path()), words) && fs::read_symlink(entry.path() / "cwd", gone) == folder_)
                return std::stoi(entry.path().filename().string());
        }
        return 0;
    }

    fs::path cluster_;
};

TEST_F(Slurm, StudiesEndInTheReportsOfLocalOnesThoughANodeDiesAndARunFails) {
    const Words grid_study{"ladder", "column.toml", "--levels", "3", "--no-fill"};
    // A run that is long enough to lose its node, and a grid study of which one run cannot begin.
    write("long.toml", with(small_column, "duration = 0.1\ncheckpoint = 0.02", "duration = 5\ncheckpoint = 0.2"));
    const Outcome submitted = twinwake({"submit", "run", "long.toml", "--no-twins", "--out", "lost"});
    ASSERT_EQ(submitted.status, 0) << submitted.err;
    EXPECT_EQ(twinwake({"submit", "run", "long.toml", "--no-twins", "--out", "lost"}).status, 2);  // twice
    const fs::path checkpoint = folder_ / "lost/sph/checkpoint.h5";
    ASSERT_TRUE(happens([&] { return fs::exists(checkpoint); }, 100)) << logs("lost");
    const std::string job = status_of("lost")["runs"][0]["job"];
    ASSERT_TRUE(has(job, "RUNNING node")) << job;
    const std::string node = job.substr(job.find("node"));
    cluster("kill", node);

    ASSERT_EQ(twinwake(with_words({"submit"}, with_words(grid_study, {"--out", "ladder"}))).status, 0);
    ASSERT_EQ(twinwake({"submit", "run", "column.toml", "--out", "run"}).status, 0);
    write("failing/near_hull_42.4264mm/sph/record.h5.tmp/in/the/way", "");
    ASSERT_EQ(twinwake(with_words({"submit"}, with_words(grid_study, {"--out", "failing", "--no-variations"}))).status,
              0);
    const Outcome refused = twinwake({"submit", "run", "column.toml", "--out", "no", "--partition", "moon"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(has(refused.err, "invalid partition specified: moon")) << refused.err;  // Slurm's own words

    ASSERT_EQ(twinwake(with_words(grid_study, {"--out", "own_ladder"})).status, 0);
    ASSERT_EQ(twinwake({"run", "column.toml", "--out", "own_run"}).status, 0);
    ASSERT_EQ(twinwake({"run", "long.toml", "--no-twins", "--out", "own_long"}).status, 0);
    ASSERT_TRUE(all_ended());

    expect_same_records(folder_ / "own_ladder", folder_ / "ladder");
    EXPECT_EQ(content(folder_ / "own_ladder/ladder_sph.csv"), content(folder_ / "ladder/ladder_sph.csv"))
        << logs("ladder");
    expect_same_records(folder_ / "own_run", folder_ / "run");
    EXPECT_EQ(content(folder_ / "own_run/quantities.csv"), content(folder_ / "run/quantities.csv")) << logs("run");
    expect_same_records(folder_ / "own_long", folder_ / "lost");
    EXPECT_TRUE(fs::exists(folder_ / "lost/report.html")) << logs("lost");
    EXPECT_TRUE(has(content(folder_ / "failing/ladder.md"), "SPH at 0.0424264 m: failed: ")) << logs("failing");
    EXPECT_EQ(status_of("failing")["runs"][1]["state"], "failed");
    EXPECT_EQ(status_of("ladder")["runs"][1]["state"], "done");
}

TEST_F(Slurm, JobsThatArePreemptedToldToStopOrKilledEndInTheReportOfALocalGridStudy) {
    write("column.toml", with(small_column, "duration = 0.1\ncheckpoint = 0.02", "duration = 2\ncheckpoint = 0.1"));
    const Words grid_study{"ladder", "column.toml", "--levels", "2", "--ratio", "1.1", "--no-fill", "--no-variations"};
    const Words submission = with_words({"submit"}, with_words(grid_study, {"--out", "slurm"}));
    const Outcome submitted = twinwake(submission);
    ASSERT_EQ(submitted.status, 0) << submitted.err;
    const std::vector<fs::path> runs{"slurm/near_hull_33mm/sph", "slurm/near_hull_30mm/sph"};
    const std::vector<pid_t> first = stopped_when_saved(runs);

    // Somebody who is served first asks for all three nodes.
    const std::string urgent = "sbatch --partition=urgent --nodes=3 --exclusive --output=/dev/null --wrap=true";
    ASSERT_EQ(std::system((urgent + " > '" + (folder_ / "urgent").string() + "'").c_str()), 0);
    const auto journal = [&] { return content(cluster_ / "log/slurmctld.log"); };
    const auto twice = [](const std::string& text, const char* what) { return text.find(what) != text.rfind(what); };
    ASSERT_TRUE(happens([&] { return twice(journal(), "preempted JobId=2_"); }, 60)) << journal();

    // The next time one is told to stop as --signal=B:TERM tells it, and the other is killed.
    const std::vector<pid_t> again = stopped_when_saved(runs, first);
    const std::string job = status_of("slurm")["runs"][0]["job"];  // "2_0: RUNNING node1"
    EXPECT_EQ(std::system(("scancel --batch --signal=TERM " + job.substr(0, job.find(':'))).c_str()), 0);
    kill(again[0], SIGCONT);
    kill(again[1], SIGKILL);
    ASSERT_TRUE(all_ended()) << logs("slurm");
    EXPECT_TRUE(twice(journal(), "Requeuing JobId=2_0")) << "once by who was served first, once by itself\n"
                                                         << journal();
    EXPECT_EQ(status_of("slurm")["runs"][0]["state"], "done");
    EXPECT_EQ(status_of("slurm")["runs"][1]["state"], "lost");
    EXPECT_TRUE(has(logs("slurm"), "SPH at 0.03 m: not finished: ")) << logs("slurm");

    ASSERT_EQ(twinwake(submission).status, 0);
    ASSERT_TRUE(all_ended()) << logs("slurm");
    ASSERT_EQ(twinwake(with_words(grid_study, {"--out", "whole"})).status, 0);
    expect_same_records(folder_ / "whole", folder_ / "slurm");
    expect_same_tables(folder_ / "whole", folder_ / "slurm");
}

/// Of two nodes: told to stop as --signal=B:TERM tells it, it saves and goes on to the bytes of one process.
TEST_F(Slurm, ARunSharedByRanksIsToldToStopAndEndsAsThatOfOneProcess) {
    if (!Comm::built_with_mpi()) GTEST_SKIP() << "built without MPI";
    for (const char* allowed : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"}) setenv(allowed, "1", 1);
    write("column.toml", with(small_column, "duration = 0.1\ncheckpoint = 0.02", "duration = 1\ncheckpoint = 0.05"));
    const Words run{"run", "column.toml", "--no-twins"};
    const Outcome submitted = twinwake(with_words({"submit"}, with_words(run, {"--ranks", "2", "--out", "ranks"})));
    ASSERT_EQ(submitted.status, 0) << submitted.err;
    const fs::path checkpoint = folder_ / "ranks/sph/checkpoint.h5";
    ASSERT_TRUE(happens([&] { return fs::exists(checkpoint); }, 100)) << logs("ranks");
    const std::string job = status_of("ranks")["runs"][0]["job"];  // "2_0: RUNNING node[1-2]"
    EXPECT_TRUE(has(job, "RUNNING node[")) << job;
    EXPECT_EQ(std::system(("scancel --batch --signal=TERM " + job.substr(0, job.find(':'))).c_str()), 0);
    ASSERT_TRUE(all_ended()) << logs("ranks");
    EXPECT_TRUE(has(content(cluster_ / "log/slurmctld.log"), "Requeuing JobId=2_0")) << logs("ranks");
    ASSERT_EQ(twinwake(with_words(run, {"--out", "one"})).status, 0);
    const RunRecord one = read_record(folder_ / "one/sph/record.h5"),
                    two = read_record(folder_ / "ranks/sph/record.h5");
    EXPECT_EQ(two.state, "finished") << logs("ranks");
    EXPECT_EQ(two.attributes.at("ranks"), "2");
    EXPECT_EQ(first_difference(one, two), "");
    EXPECT_TRUE(fs::exists(folder_ / "ranks/report.html")) << logs("ranks");
}

}  // namespace slurm_test
}  // namespace tw::test
