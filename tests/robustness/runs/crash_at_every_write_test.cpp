// A run that crashes between any two steps of writing, or is asked to stop, is resumed to the same record: nothing
// is lost, and nothing is called finished that is not.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <limits>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "first_difference.h"
#include "program.h"
#include "record/snapshot.h"
#include "record/spray_table.h"
#include "scene/hash.h"
#include "sph_solver/run_sph.h"
#include "test_paths.h"

namespace tw::test {
namespace crash_at_every_write_test {
namespace fs = std::filesystem;

constexpr int crashed = 9, refused = 2, ended = 0;
int steps_left = 0;

/// Runs in a child process, as a crash needs one; its status. `steps`: of writing, before it crashes. `stop_at`: the
/// steps of time after which it is asked to stop.
int run_in_child(const fs::path& scene, const fs::path& folder, bool resume, int steps,
                 long stop_at = std::numeric_limits<long>::max()) {
    const pid_t child = fork();
    if (child == 0) {
        steps_left = steps;
        before_write_step = [] {
            if (steps_left-- == 0) _exit(crashed);
        };
        long asked = 0;
        RunOptions options;
        options.folder = folder, options.resume = resume, options.threads = 1;
        options.stop_asked = [&] { return ++asked >= stop_at; };
        try {
            run_sph(read_scene(scene), options);
        } catch (const InputError&) { _exit(refused); } catch (const std::exception&) {
            _exit(3);
        }
        _exit(ended);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class Crash : public testing::Test {
protected:
    ScratchFolder scratch{"crash"};
    fs::path scene = write_scene("");
    const int never = std::numeric_limits<int>::max();

    fs::path write_scene(const std::string& more) const {
        const fs::path file = scratch.path() / "scene.toml";
        write_text_atomically(file,
                              "[tank]\nsize = [1, 0.02, 1]\n[domain]\ndimensions = 2\n"
                              "[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 0.02, 0.5]\n"
                              "[resolution]\nnear_hull = 0.05\n[sampling]\ninterval = 0.02\nsnapshots = 0.02\n"
                              "[[probe]]\nname = \"A\"\npressure = [0.25, 0, 0.02]\n"
                              "[run]\nmethods = [\"sph\"]\ncheckpoint = 0.02\nduration = 0.05\n" +
                                  more);
        return file;
    }
    void expect_same(const fs::path& whole, const fs::path& other, const std::string& what) const {
        const RunRecord a = read_record(whole / "record.h5"), b = read_record(other / "record.h5");
        EXPECT_EQ(b.state, "finished") << what;
        EXPECT_EQ(first_difference(a, b), "") << what;
        EXPECT_EQ(a.hull_pressure, b.hull_pressure) << what;
        const auto frames = read_series(whole / "snapshots/particles.hdf.series");
        EXPECT_GE(frames.size(), 3u);
        EXPECT_EQ(read_series(other / "snapshots/particles.hdf.series"), frames) << what;
    }
    /// Crashes at every `stride`-th step of writing, and goes on; the whole run.
    RunRecord loses_nothing(int stride) const {
        const fs::path whole = scratch.path() / "whole", part = scratch.path() / "part";
        EXPECT_EQ(run_in_child(scene, whole, false, never), ended);
        int crashes = 0;
        for (int steps = 0; !HasFailure(); steps += stride) {
            fs::remove_all(part);
            const int status = run_in_child(scene, part, false, steps);
            if (status == ended) break;
            EXPECT_EQ(status, crashed);
            ++crashes;
            EXPECT_EQ(run_in_child(scene, part, true, never), ended) << "crashed after " << steps;
            expect_same(whole, part, "crashed after " + std::to_string(steps));
        }
        EXPECT_GT(crashes, 5);
        return read_record(whole / "record.h5");
    }
};

// Each step of a file takes its turn: there are four, and the strides are odd.

TEST_F(Crash, BetweenAnyTwoStepsOfWritingLosesNothing) { loses_nothing(7); }

TEST_F(Crash, OfABodyThatFallsLosesNothing) {
    write_scene(
        "[[body]]\nname = \"box\"\nshape = \"box\"\nlength = 0.2\nheight = 0.1\ntrim = 0.3\ndraft = -0.3\n"
        "position = [0.75, 0]\ndensity = 600\nvelocity = [0, 0, -1]\nspin = [0, 1, 0]\n");
    EXPECT_TRUE(loses_nothing(11).tables.contains("body_box"));
}

TEST_F(Crash, OfAPlateThatBendsLosesNothing) {
    write_scene(
        "[[body]]\nname = \"wall\"\nelastic = \"plate\"\nplate = [0.4, 1]\ncells = [16, 1]\nmiddle = [0.8, 0, 0]\n"
        "trim = \"90 deg\"\nthickness = 0.02\nyoungs_modulus = 1e7\npoisson = 0.3\ndensity = 2500\n"
        "clamped = [\"x_max\"]\nmargin = 0\nskin = 0.1\nvelocity = [1, 0, 0]\n");
    EXPECT_TRUE(loses_nothing(11).tables.contains("body_wall"));
}

TEST_F(Crash, OfATankThatRollsLosesNothing) {
    std::string text = read_text(scene);
    text.insert(text.find("size ="),
                "law = \"sinusoid\"\nabout = [0, 1, 0]\namplitude = 0.2\nperiod = 1\nphase = \"90 deg\"\n");
    write_text_atomically(scene, text);
    const RunRecord run = loses_nothing(11);
    EXPECT_NE(run.tables.at("tank").find("work")->values.back(), 0) << "or it rested";
}

TEST_F(Crash, OfTwoSizesOfParticlesLosesNothing) {
    write_scene("[[obstacle]]\nmin = [0.7, 0, 0]\nmax = [0.8, 0.02, 0.1]\n[sph]\nlevels = 2\nzone = 8\n");
    std::string text = read_text(scene);
    write_text_atomically(scene, text.replace(text.find("near_hull = 0.05"), 16, "near_hull = 0.025"));
    EXPECT_TRUE(loses_nothing(11).tables.contains("level_1"));
}

#ifdef TWINWAKE_FAKE_CUDA
// Files are written by a thread of their own while the device makes the next steps.
TEST_F(Crash, BesideTheStepsOfADeviceLosesNothing) {
    setenv("TWINWAKE_LIBCUDA", TWINWAKE_FAKE_CUDA, 1);
    std::string text = read_text(scene);
    write_text_atomically(scene, text.insert(text.find("[run]\n") + 6, "device = \"gpu\"\n"));
    RunRecord run = loses_nothing(5);
    unsetenv("TWINWAKE_LIBCUDA");
    EXPECT_TRUE(run.attributes.contains("device"));
}
#endif

// What is saved and how often is no part of the scene's hash, so it must not be part of the answer.
TEST_F(Crash, HowOftenARunIsSavedOrDrawnShowsInNoBitOfIt) {
    const fs::path planing = fs::path(TWINWAKE_SOURCE) / "tests/robustness/runs/small_planing.toml";
    const auto run = [&](const std::string& checkpoint, const std::string& snapshots) {
        std::string text = read_text(planing);
        text.replace(text.find("\"0.4 s\""), 7, "\"0.1 s\"");
        text.replace(text.find("\"0.05 s\"\n\n[run]"), 8, "\"0.01 s\"\nsnapshots = " + snapshots);
        text.replace(text.find("\"0.04 s\""), 8, checkpoint);
        write_text_atomically(scene, text);
        const fs::path folder = scratch.path() / ("saved_" + checkpoint + "_" + snapshots);
        EXPECT_EQ(run_in_child(scene, folder, false, never), ended);
        return read_record(folder / "record.h5");
    };
    const RunRecord never_saved = run("1", "0"), often = run("0.02", "0"), else_often = run("0.013", "0.03");
    EXPECT_EQ(never_saved.attributes.at("run_hash"), often.attributes.at("run_hash")) << "or another run was asked for";
    EXPECT_EQ(first_difference(never_saved, often), "");
    EXPECT_EQ(first_difference(never_saved, else_often), "");
}

// What was taken at the gate is in the record alone: the particles are gone.
TEST_F(Crash, OfARunThatTakesSprayAtAGateLosesNothing) {
    write_text_atomically(scene, R"([tank]
size = [0.6, 0.2, 0.6]
[[water_block]]
min = [0, 0, 0]
max = [0.2, 0.2, 0.2]
[[water_block]]
min = [0.36, 0.06, 0.24]
max = [0.42, 0.14, 0.3]
[resolution]
near_hull = 0.04
[sampling]
interval = 0.02
snapshots = 0.02
[sph]
gate_point = [0.3, 0, 0.25]
gate_normal = [1, 0, 1]
gate_link = 1.7
[run]
methods = ["sph"]
checkpoint = 0.01
duration = 0.05
)");
    const RunRecord run = loses_nothing(13);
    ASSERT_TRUE(run.tables.contains(spray_table));
    const auto &mass = run.tables.at("samples").find("mass")->values,
               &taken = run.tables.at("samples").find("spray_mass")->values;
    EXPECT_EQ(taken.front(), 0);
    EXPECT_GT(taken.back(), 0) << "or nothing was taken";
    for (std::size_t i = 0; i < mass.size(); ++i)
        EXPECT_NEAR(mass[i] + taken[i], mass.front(), 1e-9 * mass.front()) << "what is left and what was taken, " << i;
}

TEST_F(Crash, OfAHullThatIsFreeInAStreamLosesNothing) {
    write_text_atomically(scene, R"([hull]
shape = "prismatic"
length = 1
beam = 0.3
height = 0.3
trim = "5 deg"
draft = 0.1
half = true
free = ["heave", "pitch"]
mass = 8
lcg = 0.4
vcg = 0.1
release = 0.01
[motion]
kind = "stream"
speed = 4
ramp = 0.01
[domain]
x = [-1, 1]
y = [-0.6, 0.6]
z = [-0.5, 0.7]
[resolution]
near_hull = 0.06
spacing = 0.06
[sampling]
interval = 0.015
snapshots = 0.015
[run]
methods = ["sph"]
checkpoint = 0.01
duration = 0.035
)");
    const RunRecord run = loses_nothing(17);
    const std::vector<double>& trim = run.tables.at("hull_motion").find("trim")->values;
    EXPECT_NE(trim.back(), trim.front()) << "or it was held";
}

TEST_F(Crash, OfATyreThatFallsOnWaterLosesNothing) {
    write_text_atomically(scene, R"([tank]
min = [-0.16, -0.16, -0.02]
max = [0.16, 0.16, 0.4]
[[water_block]]
min = [-0.05, -0.05, -0.02]
max = [0.05, 0.05, 0]
[[body]]
name = "tyre"
elastic = "tyre"
mass = "10 kg"
draft = "-1 mm"
cells = [8, 8]
velocity = [0, 0, -3]
[motion]
kind = "none"
[resolution]
near_hull = 0.01
[sph]
c0 = 40
[sampling]
interval = 0.001
snapshots = 0.001
[run]
methods = ["sph"]
checkpoint = 0.0008
duration = 0.003
)");
    const RunRecord run = loses_nothing(19);
    EXPECT_NE(run.tables.at("body_tyre").find("lowest")->values.back(), 0.001) << "or it did not fall";
}

TEST_F(Crash, ARunAskedToStopBeforeItsFirstCheckpointBeginsAgain) {
    const fs::path whole = scratch.path() / "whole", part = scratch.path() / "part";
    ASSERT_EQ(run_in_child(scene, whole, false, never), ended);
    ASSERT_EQ(run_in_child(scene, part, false, never, 2), ended);
    const RunRecord stopped = read_record(part / "record.h5");
    EXPECT_EQ(stopped.state, "stopped");
    EXPECT_NE(stopped.reason.find("--resume begins it again"), std::string::npos) << stopped.reason;
    EXPECT_FALSE(fs::exists(part / "checkpoint.h5"));
    ASSERT_EQ(run_in_child(scene, part, true, never), ended);
    expect_same(whole, part, "stopped");
}

/// A record that ends before its checkpoint, or is gone, would leave a gap that nothing fills.
TEST_F(Crash, ACheckpointWithoutTheRowsThatLeadToItIsRefused) {
    const fs::path part = scratch.path() / "part";
    ASSERT_EQ(run_in_child(scene, part, false, never), ended);
    RunRecord record = read_record(part / "record.h5");
    record.state = "running";
    record.rewind(0.03);
    write_record(part / "record.h5", record);
    EXPECT_EQ(run_in_child(scene, part, true, never), refused);
    fs::remove(part / "record.h5");
    EXPECT_EQ(run_in_child(scene, part, true, never), refused);
}

TEST_F(Crash, StrayFilesAmongTheSnapshotsAreLeftAlone) {
    const fs::path whole = scratch.path() / "whole", part = scratch.path() / "part";
    ASSERT_EQ(run_in_child(scene, whole, false, never), ended);
    ASSERT_EQ(run_in_child(scene, part, false, 40), crashed);
    ASSERT_TRUE(fs::exists(part / "checkpoint.h5"));
    for (const char* stray : {"particles_abc.hdf", "body_x_.vtp", "other.vtp.series", "hull.vtp.series"})
        write_text_atomically(part / "snapshots" / stray, "{\"files\": 3");
    ASSERT_EQ(run_in_child(scene, part, true, never), ended);
    expect_same(whole, part, "stray files");
}

TEST_F(Crash, ANameThatChangedBetweenKillAndResumeIsRefused) {
    const fs::path part = scratch.path() / "part";
    ASSERT_EQ(run_in_child(scene, part, false, 40), crashed);
    std::string text = read_text(scene);
    write_text_atomically(scene, text.replace(text.find("\"A\""), 3, "\"B\""));
    EXPECT_EQ(run_in_child(scene, part, true, never), refused);
}

TEST_F(Crash, SnapshotsThatAreAFileFailTheRunInWords) {
    const fs::path part = scratch.path() / "part";
    fs::create_directories(part);
    write_text_atomically(part / "record.h5.tmp", "left behind");
    fs::create_symlink(scratch.path() / "precious", part / "checkpoint.h5.tmp");
    write_text_atomically(scratch.path() / "precious", "mine");
    ASSERT_EQ(run_in_child(scene, part, false, 40), crashed);
    EXPECT_EQ(read_text(scratch.path() / "precious"), "mine") << "a link that was in the way was followed";
    fs::remove_all(part / "snapshots");
    write_text_atomically(part / "snapshots", "a file");
    EXPECT_EQ(run_in_child(scene, part, true, never), 3);
    const RunRecord failed = read_record(part / "record.h5");
    EXPECT_EQ(failed.state, "failed");
    EXPECT_NE(failed.reason.find("snapshots"), std::string::npos) << failed.reason;
}

}  // namespace crash_at_every_write_test
}  // namespace tw::test
