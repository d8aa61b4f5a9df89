// OpenFOAM that is not there, dies, or is killed.
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/run/watchdog.h"
#include "foam_test.h"

namespace tw {
namespace foam_failures_test {
namespace fs = std::filesystem;

TEST(NoOpenFoam, TheMessageSaysWhatToInstall) {
    const EnvironmentGuard guard;
    ::setenv("PATH", "", 1);
    ::unsetenv("WM_PROJECT_DIR");
    ::setenv("TWINWAKE_OPENFOAM_PLACES", "/nowhere", 1);
    EXPECT_TRUE(find_openfoam().empty());
    try {
        sound_openfoam();
        FAIL();
    } catch (const InputError& e) {
        const std::string text = e.what();
        EXPECT_NE(text.find("no OpenFOAM was found"), std::string::npos) << text;
        EXPECT_NE(text.find("apt-get install"), std::string::npos) << text;
        EXPECT_NE(text.find("--method sph"), std::string::npos) << text;
    }
    try {
        sound_openfoam("/home/somebody/OpenFOAM-v9999");
        FAIL();
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("/home/somebody/OpenFOAM-v9999"), std::string::npos) << e.what();
    }
}

class FoamFailure : public FoamTest {
protected:
    /// A solver that is sound in the self-test and in anger does `script`; $REAL is the sound one.
    void use_solver(const std::string& script) {
        const fs::path bin = folder / "bin";
        fs::create_directories(bin);
        std::ofstream(bin / "interFoam") << "#!/bin/sh\nREAL='" << sound_openfoam().solver.string()
                                         << "'\n[ -f system/setFieldsDict ] || exec \"$REAL\" \"$@\"\n"
                                         << script;
        fs::permissions(bin / "interFoam", fs::perms::owner_all);
        ::setenv("TWINWAKE_OPENFOAM_BIN", bin.c_str(), 1);
    }
    std::string failure_of(const Scene& s) {
        try {
            run_fvm(s, options());
        } catch (const RunError& e) { return e.what(); }
        return "no failure";
    }
};

TEST_F(FoamFailure, ASolverThatDiesMidwayLeavesARecordThatSaysSo) {
    use_solver(
        "\"$REAL\" \"$@\" & p=$!\nwhile ! ls -d 0.0[5-9]* > /dev/null 2>&1; do sleep 0.05; done\nkill -FPE $p\nwait "
        "$p\n");
    const std::string text = failure_of(scene(dam_break("5 s")));
    EXPECT_NE(text.find("died at t = "), std::string::npos) << text;
    EXPECT_NE(text.find("floating point exception"), std::string::npos) << text;
    EXPECT_NE(text.find("log.solver"), std::string::npos) << text;
    const RunRecord record = read_record(options().folder / "record.h5");
    EXPECT_EQ(record.state, "failed");
    EXPECT_EQ(record.reason, text);
    EXPECT_GE(record.tables.at("samples").time.size(), 2u) << "what was computed is kept";
}

TEST_F(FoamFailure, OpenFoamsOwnErrorIsShown) {
    use_solver("echo '--> FOAM FATAL ERROR: '; echo 'the moon is in the wrong house'; echo 'FOAM exiting'; exit 1\n");
    const std::string text = failure_of(scene(dam_break("0.1 s")));
    EXPECT_NE(text.find("the moon is in the wrong house"), std::string::npos) << text;
    EXPECT_EQ(read_record(options().folder / "record.h5").state, "failed");
}

TEST_F(FoamFailure, ASolverThatEndsWithoutTheEndIsNotTakenForFinished) {
    use_solver("exit 0\n");
    EXPECT_NE(failure_of(scene(dam_break("0.1 s"))).find("without reaching the end time"), std::string::npos);
}

TEST_F(FoamFailure, AMeshThatFailsNamesTheProgramAndItsMessage) {
    // Solver sound, blockMesh of the case broken by hand between two tries.
    RunOptions o = options();
    o.stop_asked = [] { return true; };
    const Scene s = scene(dam_break("0.1 s"));
    EXPECT_EQ(run_fvm(s, o).state, "stopped");
    fs::remove_all(o.folder / "case" / "constant");
    std::ofstream(o.folder / "case" / "constant") << "a file where a folder should be";
    RunOptions again = options();
    again.resume = true;
    EXPECT_THROW(run_fvm(s, again), std::exception);
}

TEST_F(FoamFailure, AnotherSceneIsNotGoneOnWith) {
    RunOptions o = options();
    o.stop_asked = [] { return true; };
    const auto with_probe = [&](const std::string& name) {
        return scene(dam_break("0.1 s") + "[[probe]]\nname = \"" + name + "\"\npressure = [0.1, 0, 0.02]\n");
    };
    EXPECT_EQ(run_fvm(with_probe("A"), o).state, "stopped");
    o.resume = true;
    try {
        run_fvm(with_probe("B"), o);
        FAIL() << "resumed under another name";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("belongs to another scene"), std::string::npos) << e.what();
    }
    EXPECT_EQ(run_fvm(with_probe("A"), o).state, "stopped");
}

TEST_F(FoamFailure, TwoRunsInOneFolderAreRefused) {
    fs::create_directories(options().folder);
    const FolderLock other(options().folder);
    EXPECT_THROW(run_fvm(scene(dam_break("0.02 s")), options()), InputError);
}

// The solver starts from 0 again then, and openfoam.com begins force_0.dat beside force.dat.
TEST_F(FoamFailure, AKillBeforeTheFirstWriteTimeLosesNoRow) {
    const Scene s = scene(drowned_box("0.2", "0.1"));
    const fs::path tables = options().folder / "case/postProcessing";
    const pid_t child = ::fork();
    if (child == 0) {
        run_fvm(s, options());
        ::_exit(0);
    }
    const auto rows = [&] { return joined_rows(tables / "forces", "force.dat").size(); };
    for (int i = 0; i < 24000 && rows() < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ASSERT_GE(rows(), 2u);
    ASSERT_FALSE(fs::exists(options().folder / "case/0.1")) << "killed too late for this test to see anything";
    std::this_thread::sleep_for(std::chrono::milliseconds(500));  // the solver goes with its parent

    RunOptions resume = options();
    resume.resume = true;
    const RunRecord record = run_fvm(s, resume);
    EXPECT_EQ(record.state, "finished");
    EXPECT_EQ(segments(tables / "forces", "force.dat").size(), 2u);
    for (const char* table : {"forces_total", "pressure"})
        EXPECT_EQ(record.tables.at(table).time.size(), static_cast<std::size_t>(record.steps)) << table;
    EXPECT_NEAR(record.tables.at("forces_total").time.back(), 0.2, 0.02);  // a tank ends at the nearest step
    EXPECT_FALSE(std::isnan(latest_fastest(tables, 0.2)));
}

TEST_F(FoamFailure, ATableThatLostRowsIsNoFinishedRunAndResumeComputesThemAnew) {
    use_solver("\"$REAL\" \"$@\"; rc=$?\n[ -f mended ] || sed -i 12,15d postProcessing/pressureProbes/0/p\nexit $rc\n");
    const Scene s = scene(dam_break("0.1 s"));
    const std::string text = failure_of(s);
    EXPECT_NE(text.find("tables are not whole: pressure has rows for "), std::string::npos) << text;
    EXPECT_NE(text.find("--resume"), std::string::npos) << text;
    EXPECT_EQ(read_record(options().folder / "record.h5").state, "failed");

    std::ofstream(options().folder / "case/mended") << "the disk has room again";
    RunOptions resume = options();
    resume.resume = true;
    const RunRecord record = run_fvm(s, resume);
    EXPECT_EQ(record.state, "finished");
    EXPECT_EQ(record.tables.at("pressure").time.size(), static_cast<std::size_t>(record.steps));
    EXPECT_EQ(record.tables.at("samples").time.size(), 5u);
    // Nothing is left to do: the record is handed back as it is.
    const auto written = fs::last_write_time(options().folder / "record.h5");
    EXPECT_EQ(run_fvm(s, resume).state, "finished");
    EXPECT_EQ(fs::last_write_time(options().folder / "record.h5"), written);
}

/// The forces on what stands in a tank are as much a part of the run as those on a hull.
TEST_F(FoamFailure, RowsOfForcesInATankThatAreLostBeforeAResumeAreComputedAnew) {
    const auto step = [&](const char* duration) {
        return scene(dam_break(duration) +
                     "[[obstacle]]\nname = \"step\"\nmin = [0.3, -0.1, 0]\nmax = [0.35, 0.1, 0.05]\n");
    };
    ASSERT_EQ(run_fvm(step("0.06 s"), options()).state, "finished");
    const fs::path tables = options().folder / "case/postProcessing/forces";
    std::size_t lost = 0;
    for (const char* name : {"force.dat", "forces.dat"})
        for (const Segment& s : segments(tables, name)) {
            std::ifstream in(s.file);
            std::string kept, line;
            for (std::size_t row = 0; std::getline(in, line);)
                if (line.starts_with("#") || row++ < 4 || row > 8)
                    kept += line + "\n";
                else
                    ++lost;
            write_text_atomically(s.file, kept);
        }
    ASSERT_EQ(lost, 4u);
    RunOptions resume = options();
    resume.resume = true;
    const RunRecord record = run_fvm(step("0.1 s"), resume);
    EXPECT_EQ(record.state, "finished");
    EXPECT_EQ(record.attributes.at("loads_of"), "all solids");
    EXPECT_EQ(record.tables.at("forces_total").time.size(), static_cast<std::size_t>(record.steps));
}

TEST_F(FoamFailure, ACaseWithoutItsRecordIsNotGoneOnWith) {
    RunOptions o = options();
    const Scene s = scene(dam_break("0.02 s"));
    EXPECT_EQ(run_fvm(s, o).state, "finished");
    fs::remove(o.folder / "record.h5");
    o.resume = true;
    EXPECT_THROW(run_fvm(s, o), InputError);
}

/// A time folder of `time` or later: tanks write at the nearest step.
bool has_written(const fs::path& run, double time) {
    std::error_code gone;  // the solver may be making the folder
    for (const fs::directory_entry& e : fs::directory_iterator(run, gone)) {
        char* end = nullptr;
        const std::string name = e.path().filename().string();
        if (std::strtod(name.c_str(), &end) >= time && *end == '\0') return true;
    }
    return false;
}

TEST_F(FoamFailure, AfterAKillTheRunIsTakenUpAndEndsAsIfNothingHadBeen) {
    const Scene s = scene(dam_break("0.3 s"));
    const pid_t child = ::fork();
    if (child == 0) {
        run_fvm(s, options());
        ::_exit(0);
    }
    const fs::path run = options().folder / "case";
    for (int i = 0; i < 6000 && !has_written(run, 0.075); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ASSERT_TRUE(has_written(run, 0.075));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));  // the solver goes with its parent
    // What a kill in the middle of writing leaves: a folder with one cut-off file.
    fs::create_directories(run / "5");
    std::ofstream(run / "5" / "U") << "FoamFile\n{ cut";

    RunOptions resume = options();
    resume.resume = true;
    const RunRecord taken_up = run_fvm(s, resume);
    EXPECT_EQ(taken_up.state, "finished") << taken_up.reason;
    RunOptions whole = options();
    whole.folder = folder / "whole";
    const RunRecord undisturbed = run_fvm(s, whole);
    const Table &a = taken_up.tables.at("samples"), &b = undisturbed.tables.at("samples");
    ASSERT_EQ(a.time.size(), b.time.size());
    // Not bitwise (interFoam does not store its last compression correction, and a tank writes at the nearest step),
    // but the same flow: energies at the same times, by straight lines between frames.
    const std::vector<double>& energy = b.find("kinetic_energy")->values;
    for (std::size_t i = 1; i + 1 < a.time.size(); ++i) {
        EXPECT_NEAR(a.time[i], b.time[i], 0.01);
        const std::size_t k = b.time[i] < a.time[i] ? i : i - 1;
        const double share = (a.time[i] - b.time[k]) / (b.time[k + 1] - b.time[k]);
        const double there = energy[k] + share * (energy[k + 1] - energy[k]);
        EXPECT_NEAR(a.find("kinetic_energy")->values[i], there, 0.02 * energy.back());
    }
}

}  // namespace foam_failures_test
}  // namespace tw
