// What submit writes and how it meets Slurm; Slurm itself is stood in for by small scripts on the PATH.
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "sph_solver/parallel/comm.h"
#include "study_folder.h"

namespace tw::test {
namespace submit_test {

using Words = std::vector<std::string>;

class Submit : public Command {
protected:
    void SetUp() override {
        Command::SetUp();
        path_ = std::getenv("PATH");
        fs::create_directories(folder_ / "bin");
        for (const char* tool : {"bash", "cat", "env", "hostname", "timeout", "touch", "true"})
            fs::create_symlink(fs::path("/usr/bin") / tool, folder_ / "bin" / tool);
        setenv("PATH", (folder_ / "bin").c_str(), 1);
        setenv("XDG_CONFIG_HOME", (folder_ / "config").c_str(), 1);
        write("column.toml", small_column);
        // No Slurm of this machine is asked: all of its programs are there and refuse, until a test replaces them.
        for (const char* program : {"sbatch", "squeue", "scancel", "sacct", "srun", "scontrol"})
            stub(program, "echo 'not in this test' >&2; exit 1");
    }
    void TearDown() override {
        setenv("PATH", path_.c_str(), 1);
        Command::TearDown();
    }

    /// A program on the PATH that notes its words, one a line, and then does `script`.
    void stub(const std::string& name, const std::string& script) const {
        const fs::path file = write("bin/" + name, "#!/bin/bash\nprintf '%s\\n' \"$@\" >> '" +
                                                       (folder_ / (name + ".words")).string() + "'\n" + script + "\n");
        chmod(file.c_str(), 0755);
    }
    std::string words_of(const std::string& name) const { return content(folder_ / (name + ".words")); }

    /// A submit command: a grid study of three sizes with what else is given.
    Outcome submit(const Words& more = {}, const std::string& levels = "3") const {
        Words words{"submit", "ladder", "column.toml", "--levels", levels, "--no-fill", "--out", "out"};
        words.insert(words.end(), more.begin(), more.end());
        return twinwake(words);
    }
    /// Runs a script of the study as Slurm would: in its folder, as a member of an array.
    int run_script(const std::string& name) const {
        return std::system(("cd '" + (folder_ / "out/study").string() +
                            "' && SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=0 timeout 60 bash " + name + " > '" +
                            (folder_ / "script.log").string() + "' 2>&1")
                               .c_str());
    }

    std::string path_;
};

/// A golden file; what differs from machine to machine is named in it.
std::string golden(const std::string& name) {
    return content(fs::path(TWINWAKE_SOURCE) / "tests/robustness/cluster/golden" / name);
}

TEST_F(Submit, ADryRunWritesTheScriptsAndSubmitsNothing) {
    fs::remove(folder_ / "bin/sbatch");
    const fs::path site = write("site.toml",
                                "account = \"hydro\"\npartition = \"compute\"\nlimit = 2\ntime = \"12 h\"\n"
                                "modules = [\"openmpi/4.1\"]\ncontainer = \"apptainer exec tw.sif\"\n"
                                "program = \"twinwake\"\n");
    const Outcome o = submit({"--site", "site.toml", "--qos", "night", "--dry-run"});
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_EQ(content(folder_ / "out/study/sph_1.sbatch"), golden("sph_1.sbatch"));
    const std::string report = content(folder_ / "out/study/report.sbatch");
    EXPECT_EQ(with(report, folder_.string(), "FOLDER"), golden("report.sbatch"));
    EXPECT_TRUE(has(o.out, "sbatch --parsable --chdir=")) << o.out;
    EXPECT_TRUE(has(o.out, "--dependency=afterany:sph_1")) << o.out;
    EXPECT_FALSE(fs::exists(folder_ / "out/study/jobs.json"));
    EXPECT_TRUE(records_below(folder_ / "out").empty());
    for (const char* script : {"sph_1.sbatch", "report.sbatch"})
        EXPECT_EQ(std::system(("bash -n '" + (folder_ / "out/study" / script).string() + "'").c_str()), 0);
    // Where Slurm is there, its own opinion is shown and nothing is submitted either.
    stub("scontrol", "echo 'Slurmctld(primary) at head is UP'");
    stub("sbatch", "echo 'sbatch: Job 5 to start at 2027-01-01'");
    const Outcome asked = submit({"--dry-run"});
    EXPECT_TRUE(has(asked.out, "sph_1: sbatch: Job 5 to start at 2027-01-01")) << asked.out;
    EXPECT_TRUE(has(words_of("sbatch"), "--test-only"));
    EXPECT_FALSE(has(words_of("sbatch"), "--parsable"));
    stub("sbatch", "echo 'sbatch: error: invalid partition specified: compute' >&2; exit 1");
    const Outcome refused = submit({"--dry-run"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(has(refused.err, "invalid partition specified")) << refused.err;
}

/// Slurm's programs without a cluster behind them, as on a desk: nothing is tested, and the scripts are there.
TEST_F(Submit, ADryRunNeedsNoController) {
    stub("sbatch", "echo 'allocation failure: Unable to contact slurm controller' >&2; exit 1");
    stub("scontrol", "echo 'Slurmctld(primary) at head is DOWN'; exit 1");
    const Outcome o = submit({"--dry-run"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(has(o.out, "not tested by Slurm, whose controller does not answer: Slurmctld(primary) at head is DOWN"))
        << o.out;
    EXPECT_TRUE(has(words_of("scontrol"), "ping"));
    EXPECT_TRUE(fs::exists(folder_ / "out/study/sph_1.sbatch"));
}

TEST_F(Submit, WithoutSlurmItIsRefusedByName) {
    setenv("PATH", "/nowhere", 1);
    const Outcome o = submit();
    EXPECT_EQ(o.status, 2);
    EXPECT_TRUE(has(o.err, "there is no sbatch on the PATH")) << o.err;
    EXPECT_TRUE(has(o.err, "--jobs N")) << o.err;
}

TEST_F(Submit, SlurmsOwnWordsAreShownAndHalfASubmissionIsTakenBack) {
    stub("sbatch",
         "case $* in *report*) echo 'sbatch: error: Batch job submission failed: Invalid account or "
         "account/partition combination specified' >&2; exit 1;; esac; echo 41");
    const Outcome o = submit({"--account", "nobody"});
    EXPECT_EQ(o.status, 2);
    EXPECT_TRUE(has(o.err, "Invalid account or account/partition combination specified")) << o.err;
    EXPECT_EQ(words_of("scancel"), "41\n");
    EXPECT_FALSE(fs::exists(folder_ / "out/study/jobs.json"));
}

TEST_F(Submit, ASecondSubmissionIsRefusedWhileJobsOfTheFirstAreQueued) {
    stub("sbatch", "echo 41");
    ASSERT_EQ(submit().status, 0);
    stub("squeue", "echo '41_0|RUNNING|node1'; echo '41_1|PENDING|(Priority)'");
    const Outcome second = submit();
    EXPECT_EQ(second.status, 2);
    EXPECT_TRUE(has(second.err, "this study has been submitted, and 2 of its jobs are in the queue (41 41)"))
        << second.err;
    Words jobs{"ladder", "column.toml", "--levels", "3", "--no-fill", "--out", "out", "--jobs", "2"};
    EXPECT_TRUE(has(twinwake(jobs).err, "this study has been submitted"));
    const Outcome status = twinwake({"status", "out"});
    EXPECT_TRUE(has(status.out, "41_0: RUNNING node1")) << status.out << status.err;
    EXPECT_TRUE(has(status.out, "lost")) << status.out;  // member 2 is in no queue
    EXPECT_TRUE(has(status.out, "out/study/probe")) << status.out;
    stub("scancel", "true");
    ASSERT_EQ(twinwake({"cancel", "out"}).status, 0);
    EXPECT_TRUE(fs::exists(folder_ / "out/study/cancelled"));
    stub("squeue", "true");
    EXPECT_EQ(submit().status, 0);  // and then again
    EXPECT_FALSE(fs::exists(folder_ / "out/study/cancelled"));
}

TEST_F(Submit, AFolderThatNodesDoNotShareIsNamed) {
    stub("sbatch", "echo 41");
    stub("srun", "echo '/bin/cat: x: No such file or directory' >&2; exit 1");
    const Outcome o = submit();
    EXPECT_EQ(o.status, 2);
    EXPECT_TRUE(has(o.err, (folder_ / "out/study/probe").string() + ": a node of the cluster cannot access this file"))
        << o.err;
    EXPECT_TRUE(words_of("sbatch").empty());
    // The jobs look as well: the probe of another disk is no answer.
    stub("srun", "cat \"${@: -1}\"");
    ASSERT_EQ(submit().status, 0);
    write("out/study/probe", "another\n");
    EXPECT_NE(run_script("sph_1.sbatch"), 0);
    EXPECT_TRUE(has(content(folder_ / "script.log"), "has to lie on a disk that all nodes share"));
}

TEST_F(Submit, ASiteFileSaysWhereItIsWrong) {
    const auto refused = [&](const std::string& text) {
        write("site.toml", text);
        const Outcome o = submit({"--site", "site.toml", "--dry-run"});
        EXPECT_EQ(o.status, 2) << text;
        return o.err;
    };
    EXPECT_TRUE(has(refused("account = \"a\"\npartitoin = \"b\"\n"), "site.toml:2:1: partitoin"));
    EXPECT_TRUE(has(refused("account = \"a\"\npartitoin = \"b\"\n"), "did you mean 'partition'"));
    EXPECT_TRUE(has(refused("qos = \"x\\n#SBATCH --wrap=ls\"\n"), "site.toml:1:7: "));
    EXPECT_TRUE(has(refused("time = \"3 m\"\n"), "site.toml:1:8: "));
    EXPECT_TRUE(has(refused("time = \"60 s\"\n"), "expected at least 10 min"));
    EXPECT_TRUE(has(refused("limit = 0\n"), "site.toml:1:9: "));
    EXPECT_TRUE(has(submit({"--account", "a b", "--dry-run"}).err, "--account a b: expected letters"));
    write("config/twinwake/site.toml", "nodes = 3\n");  // the usual place
    EXPECT_TRUE(has(submit({"--dry-run"}).err, "site.toml:1:1: nodes"));
}

TEST_F(Submit, NoNameAndNoTextBecomesShell) {
    const std::string name = "it's $(touch pwned) `touch pwned`.toml";
    write(name, with(small_column, "\"column\"", "\"$(touch pwned)\\n#SBATCH --wrap=ls\""));
    write("site.toml",
          "container = \"env A=$(touch\\u00a0pwned)\"\nmodules = [\"x;touch pwned\"]\nprogram = \"stand in\"\n");
    stub("stand in", "true");
    stub("sbatch", "echo 41");
    const Outcome o =
        twinwake({"submit", "ladder", name, "--levels", "1", "--no-variations", "--out", "out", "--site", "site.toml"});
    ASSERT_EQ(o.status, 0) << o.err;
    run_script("sph_1.sbatch");
    run_script("report.sbatch");
    EXPECT_EQ(words_of("stand in"), "member\n..\n0\n--threads\n1\n--quiet\nladder\n" + name +
                                        "\n--levels\n1\n--no-variations\n--out\nout\n--collect\n");
    for (const std::string& file : files()) EXPECT_FALSE(file.ends_with("pwned")) << file;
}

TEST_F(Submit, AJobThatTheClockEndsSavesAndGoesBackIntoTheQueue) {
    write("column.toml", with(small_column, "duration = 0.1\ncheckpoint = 0.02", "duration = 2\ncheckpoint = 0.25"));
    stub("sbatch", "echo 41");
    ASSERT_EQ(submit({"--no-variations"}, "1").status, 0);
    stub("squeue", "echo RUNNING");
    const std::string script = "cd '" + (folder_ / "out/study").string() +
                               "' && SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=0 exec bash sph_1.sbatch > '" +
                               (folder_ / "script.log").string() + "' 2>&1";
    const pid_t job = fork();
    if (job == 0) execl("/bin/bash", "bash", "-c", script.c_str(), nullptr), _exit(127);
    const fs::path checkpoint = folder_ / "out/near_hull_30mm/sph/checkpoint.h5";
    for (int k = 0; k < 6000 && !fs::exists(checkpoint); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(job, SIGTERM);  // as --signal=B:TERM@120
    int status = 0;
    waitpid(job, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 5) << content(folder_ / "script.log");
    EXPECT_EQ(words_of("scontrol"), "requeue\n7_0\n");
    EXPECT_EQ(read_record(folder_ / "out/near_hull_30mm/sph/record.h5").state, "stopped");
    ASSERT_EQ(run_script("sph_1.sbatch"), 0);  // and the next job ends it
    twinwake({"ladder", "column.toml", "--levels", "1", "--no-variations", "--out", "whole"});
    EXPECT_EQ(first_difference(read_record(folder_ / "whole/near_hull_30mm/sph/record.h5"),
                               read_record(folder_ / "out/near_hull_30mm/sph/record.h5")),
              "");
}

/// Of particles that ranks share: tasks on as many nodes as Slurm takes, memory by core, and a signal that mpirun hands on.
TEST_F(Submit, RanksAreTasksThatMpirunStarts) {
    if (!Comm::built_with_mpi()) GTEST_SKIP() << "built without MPI";
    stub("sbatch", "true");
    const Outcome o = twinwake({"submit", "run", "column.toml", "--no-twins", "--ranks", "2", "--threads", "3", "--out",
                                "out", "--container", "apptainer exec tw.sif", "--dry-run"});
    ASSERT_EQ(o.status, 0) << o.err;
    const std::string script = content(folder_ / "out/study/sph_2x3.sbatch");
    for (const char* line : {"#SBATCH --ntasks=2\n#SBATCH --cpus-per-task=3\n#SBATCH --mem-per-cpu=",
                             "kill -USR1 \"$run\"", "\nmpirun -n 2 --bind-to none --quiet apptainer exec tw.sif "})
        EXPECT_TRUE(has(script, line)) << line << "\n" << script;
    EXPECT_FALSE(has(script, "--nodes")) << script;
    EXPECT_TRUE(has(script, "member .. \"$SLURM_ARRAY_TASK_ID\" --threads 3 --quiet &")) << script;
    EXPECT_EQ(nlohmann::json::parse(content(folder_ / "out/study/study.json"))["members"][0]["ranks"], 2);
    // asked for by the scene's key
    write("key.toml", with(small_column, "[run]\n", "[run]\nranks = 3\n"));
    EXPECT_EQ(twinwake({"submit", "run", "key.toml", "--no-twins", "--out", "key", "--dry-run"}).status, 0);
    EXPECT_TRUE(has(content(folder_ / "key/study/sph_3x1.sbatch"), "#SBATCH --ntasks=3\n"));
}

/// The memory of the nodes is not known here: Slurm compares it.
TEST_F(Submit, AStudyTooLargeForThisMachineIsHandedOver) {
    if (!Comm::built_with_mpi()) GTEST_SKIP() << "built without MPI";
    stub("sbatch", "true");
    write("column.toml", with(small_column, "near_hull = 0.03", "near_hull = 0.0001"));
    const Words run{"run", "column.toml", "--no-twins", "--duration", "1e-5s", "--method", "sph", "--ranks", "2"};
    Words own = run, handed = run;
    own.insert(own.end(), {"--out", "own"});
    handed.insert(handed.begin(), "submit");
    handed.insert(handed.end(), {"--out", "out", "--dry-run"});
    const Outcome refused = twinwake(own), o = twinwake(handed);
    EXPECT_TRUE(has(refused.err, "too fine for this machine")) << refused.err;
    EXPECT_EQ(o.status, 0) << o.err;
}

}  // namespace submit_test
}  // namespace tw::test
