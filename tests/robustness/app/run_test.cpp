#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "program.h"

namespace tw::test {
namespace run_test {

const std::string column =
    falling_column(R"(a \"column\" of $(touch pwned) <script>)", "duration = 0.1", "[0.4, 0.1, 0.02]");

std::string longer(const std::string& seconds) {
    return with(column, "duration = 0.1", "duration = " + seconds + "\ncheckpoint = 0.02");
}

void wait_for(const fs::path& file, double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!fs::exists(file) && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

TEST_F(Command, ARunLeavesItsRecordAndIsNotWrittenOver) {
    write("my column.toml", column);
    const Outcome o = twinwake({"run", "my column.toml"});
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(fs::exists(folder_ / "runs/my column/sph/record.h5"));
    EXPECT_FALSE(files().contains("pwned"));
    const std::string record = content(folder_ / "runs/my column/sph/record.h5");
    const Outcome again = twinwake({"run", "my column.toml"});
    EXPECT_EQ(again.status, 2);
    EXPECT_NE(again.err.find("there is a run already; continue it with --resume, run anew with --overwrite"),
              std::string::npos)
        << again.err;
    EXPECT_EQ(content(folder_ / "runs/my column/sph/record.h5"), record);
    const Outcome facts = twinwake({"run", "my column.toml", "--overwrite", "-q", "--json", "-"});
    EXPECT_EQ(facts.status, 0);
    EXPECT_NE(facts.out.find("\"state\": \"finished\""), std::string::npos) << facts.out;
    EXPECT_EQ(twinwake({"run", "my column.toml", "--resume"}).status, 0);  // nothing left to do is no error
}

TEST_F(Command, SnapshotsHoldParticlesFreeSurfaceAndHullUnderTheirTimes) {
    write("snap.toml", with(with(planing, "[run]", "[sampling]\nsnapshots = 0.01\ninterval = 0.01\n[run]\nthreads = 1"),
                            "0.02 s", "0.03 s"));
    const Outcome o = twinwake({"run", "snap.toml", "--method", "sph"});
    ASSERT_EQ(o.status, 0) << o.err;
    for (const std::string name : {"particles.hdf", "free_surface.vtp", "hull.vtp"}) {
        const auto series =
            nlohmann::json::parse(content(folder_ / "runs/snap/sph/snapshots" / (name + ".series")))["files"];
        ASSERT_GE(series.size(), 2u) << name;
        for (const auto& entry : series) {
            EXPECT_TRUE(fs::exists(folder_ / "runs/snap/sph/snapshots" / entry["name"].get<std::string>()));
            EXPECT_GT(entry["time"].get<double>(), 0);
        }
    }
}

TEST_F(Command, TheLastMomentIsDrawnUnaskedAndOfATwinNot) {
    write("short.toml", with(planing, "[run]", "[run]\nthreads = 1"));
    const Outcome o = twinwake({"run", "short.toml", "--method", "sph", "--quiet"});
    ASSERT_EQ(o.status, 0) << o.err;
    const fs::path run = folder_ / "runs/short";
    for (const std::string name : {"particles.hdf", "free_surface.vtp", "hull.vtp"}) {
        const auto series = nlohmann::json::parse(content(run / "sph/snapshots" / (name + ".series")))["files"];
        ASSERT_EQ(series.size(), 1u) << name;
        EXPECT_NEAR(series[0]["time"].get<double>(), 0.02, 1e-3) << name;
    }
    for (const auto& twin : fs::directory_iterator(run / "twins"))
        EXPECT_FALSE(fs::exists(twin.path() / "sph/snapshots")) << twin.path();
}

TEST_F(Command, AGridStudyTakesWhatIsFinishedAndNamesWhatTheBudgetLeavesOut) {
    write("my column.toml", column);
    const Outcome small = twinwake({"ladder", "my column.toml", "--levels", "2", "--budget", "1 us"});
    EXPECT_EQ(small.status, 2);
    EXPECT_NE(small.err.find("--budget 1 us: no run fits; the cheapest needs about"), std::string::npos) << small.err;

    const Outcome plan = twinwake({"ladder", "my column.toml", "--levels", "2", "--plan", "--budget", "1 us"});
    EXPECT_EQ(plan.status, 0) << plan.err;
    EXPECT_NE(plan.out.find("SPH at 0.02 m"), std::string::npos) << plan.out;
    EXPECT_NE(plan.out.find("beyond the budget"), std::string::npos) << plan.out;
    EXPECT_FALSE(fs::exists(folder_ / "runs"));

    const Outcome first = twinwake({"ladder", "my column.toml", "--levels", "2", "--json", "facts.json"});
    ASSERT_EQ(first.status, 0) << first.err;
    const fs::path out = folder_ / "runs/my column_ladder";
    EXPECT_TRUE(fs::exists(out / "near_hull_20mm/sph/record.h5"));
    EXPECT_TRUE(fs::exists(out / "near_hull_28.2843mm/sph/record.h5"));
    for (const char* file : {"ladder.md", "ladder.json", "ladder_sph.csv"}) EXPECT_TRUE(fs::exists(out / file)) << file;
    EXPECT_NE(content(folder_ / "facts.json").find("0.0282842712"), std::string::npos);
    EXPECT_FALSE(files().contains("pwned"));

    const std::string record = content(out / "near_hull_20mm/sph/record.h5");
    const Outcome again = twinwake({"ladder", "my column.toml", "--levels", "2", "--budget", "1 us"});
    EXPECT_EQ(again.status, 0) << again.err;  // what is there costs nothing
    EXPECT_NE(again.out.find("finished before, taken from"), std::string::npos) << again.out;
    EXPECT_TRUE(content(out / "near_hull_20mm/sph/record.h5") == record);
    EXPECT_TRUE(fs::exists(out / "near_hull_20mm/time_step_0.5/sph/record.h5"));  // the choices' runs
    EXPECT_NE(content(out / "ladder.md").find("sound speed x 1.5"), std::string::npos);
    EXPECT_NE(content(out / "report.html").find("What accuracy costs"), std::string::npos);

    // the same grid study from the records alone
    const std::string grid_study = "runs/my column_ladder/";
    const Outcome compared = twinwake({"compare", "--ladder", grid_study + "near_hull_20mm/sph",
                                       grid_study + "near_hull_28.2843mm/sph", "--out", "from_records"});
    EXPECT_EQ(compared.status, 0) << compared.err;
    EXPECT_EQ(content(folder_ / "from_records/ladder_sph.csv"), content(out / "ladder_sph.csv"));
    const Outcome by_folder = twinwake({"compare", "--ladder", "runs/my column_ladder", "--out", "from_folder"});
    EXPECT_EQ(by_folder.status, 0) << by_folder.err;
    EXPECT_EQ(content(folder_ / "from_folder/ladder.md"), content(out / "ladder.md"));
    EXPECT_EQ(twinwake({"compare", "--ladder", grid_study + "near_hull_20mm/sph"}).status, 2);  // nowhere to write it

    write("my column.toml", with(column, "max = [0.2, 0.2, 0.2]", "max = [0.2, 0.2, 0.1]"));
    const Outcome refused = twinwake({"ladder", "my column.toml", "--levels", "2"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("belongs to another scene"), std::string::npos) << refused.err;
    EXPECT_TRUE(content(out / "near_hull_20mm/sph/record.h5") == record);
    EXPECT_EQ(twinwake({"ladder", "my column.toml", "--levels", "2", "--overwrite"}).status, 0);
    EXPECT_FALSE(content(out / "near_hull_20mm/sph/record.h5") == record);
}

TEST_F(Command, AMeasuredHistoryBecomesARecordThatStandsBesideARun) {
    write("column.toml", column);
    ASSERT_EQ(twinwake({"run", "column.toml"}).status, 0);
    write("gauge.csv", "t [ms],p [kPa]\n0,0\n50,1.5\n100,2.5\n");
    write("gauge.toml",
          "kind = \"csv\"\nname = \"gauge\"\nsource = \"gauge.csv\"\nscene = \"column.toml\"\ntime = \"t "
          "[ms]\"\n[pressure]\n"
          "P1 = \"p [kPa]\"\n");
    const Outcome imported = twinwake({"import", "gauge.toml", "--out", "gauge"});
    ASSERT_EQ(imported.status, 0) << imported.err;
    EXPECT_EQ(twinwake({"import", "gauge.toml", "--out", "gauge"}).status, 2);  // a record is not written over
    const Outcome compared = twinwake({"compare", "runs/column/sph", "gauge", "--out", "cmp"});
    EXPECT_EQ(compared.status, 0) << compared.err;
    EXPECT_NE(content(folder_ / "cmp/report.html").find("gauge"), std::string::npos);
    const Outcome absent = twinwake({"import", "absent.toml", "--out", "x"});
    EXPECT_EQ(absent.status, 2);
    EXPECT_FALSE(fs::exists(folder_ / "x"));
}

TEST_F(Command, AnInterruptedRunSavesItsStateAndContinues) {
    write("long.toml", longer("3"));
    const Started run = start({"run", "long.toml", "--no-twins", "--out", "out"});
    wait_for(folder_ / "out/sph/checkpoint.h5", 120);
    ASSERT_TRUE(fs::exists(folder_ / "out/sph/checkpoint.h5"));
    kill(run.child, SIGINT);
    const Outcome stopped = finish(run);
    EXPECT_EQ(stopped.status, 3);
    EXPECT_NE(stopped.err.find("continue it with --resume"), std::string::npos) << stopped.err;
    EXPECT_EQ(twinwake({"run", "long.toml", "--no-twins", "--out", "out", "--resume", "--duration", "0.2"}).status, 0);
}

TEST_F(Command, TwoRunsNeverShareAFolder) {
    write("long.toml", longer("3"));
    const Started first = start({"run", "long.toml", "--no-twins", "--out", "out"});
    wait_for(folder_ / "out/sph/checkpoint.h5", 120);
    for (const char* how : {"--overwrite", "--resume"}) {
        const Outcome second = twinwake({"run", "long.toml", "--no-twins", "--out", "out", how});
        EXPECT_EQ(second.status, 2) << how << second.err;
        EXPECT_NE(second.err.find("another run is using it"), std::string::npos) << second.err;
    }
    kill(first.child, SIGKILL);
    EXPECT_EQ(finish(first).status, 128 + SIGKILL);
    // A killed run holds nothing: its last checkpoint goes on.
    EXPECT_EQ(twinwake({"run", "long.toml", "--no-twins", "--out", "out", "--resume", "--duration", "0.2"}).status, 0);
}

TEST_F(Command, AFullDiskIsAFailedRunWithTheSystemsReason) {
    const Outcome stl = twinwake({"hull", "make", "sphere", "-o", "ball.stl", "level=6"}, 10000);
    EXPECT_EQ(stl.status, 2);  // a target that cannot be written; no run failed
    EXPECT_NE(stl.err.find("ball.stl: cannot be written: File too large"), std::string::npos) << stl.err;
    EXPECT_TRUE(files().empty());  // no half-written file, no temporary one
    write("column.toml", column);
    const Outcome run = twinwake({"run", "column.toml"}, 2000);
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_NE(run.err.find("cannot be written"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(folder_ / "runs/column/sph/record.h5"));
}

TEST_F(Command, ARunThatFailsLeavesAReportOfWhatThereIs) {
    write("column.toml", column + "[sph]\nc0 = 2\n");  // far too low
    const Outcome o = twinwake({"run", "column.toml"});
    EXPECT_EQ(o.status, 3) << o.out;
    EXPECT_NE(o.err.find("often a sound speed that is too low"), std::string::npos) << o.err;
    const std::string page = content(folder_ / "runs/column/report.html");
    EXPECT_NE(page.find("One run only, SPH"), std::string::npos);
    EXPECT_NE(page.find("<div class=\"verdict\"><p>SPH failed: "), std::string::npos);
    EXPECT_NE(page.find("<pre>twinwake run column.toml"), std::string::npos);
}

TEST_F(Command, ARunWhoseWaterHasLeftEndsAndLeavesAReport) {
    // The tank falls faster than the drop in it, which leaves through the open top.
    write("lost.toml",
          "[tank]\nsize = [0.1, 0.1, 0.1]\nlaw = \"ramp\"\nalong = [0, 0, -1]\nrate = \"20 m/s\"\nramp = 0.5\n"
          "[domain]\ndimensions = 2\n[[water_block]]\nmin = [0.03, 0, 0.04]\nmax = [0.07, 0.1, 0.07]\n"
          "[resolution]\nnear_hull = 0.01\n[run]\nduration = 1\nmethods = [\"sph\"]\n");
    const Outcome o = twinwake({"run", "lost.toml", "--no-twins"});
    EXPECT_EQ(o.status, 3) << o.out;
    EXPECT_NE(o.err.find("no water is left at t = 0."), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("12 particles have left"), std::string::npos) << o.err;
    const auto left = nlohmann::json::parse(content(folder_ / "runs/lost/report.json"));
    EXPECT_EQ(left["sources"][0]["state"], "failed");
    EXPECT_EQ(left["cost"][0]["elements"], 0);
    EXPECT_FALSE(left["sources"][0]["numbers"]["bytes_per_particle"].is_null()) << "per particle of none";
    EXPECT_NE(content(folder_ / "runs/lost/report.html").find("SPH failed: no water is left"), std::string::npos);
}

TEST_F(Command, AGridStudyOfRunsThatAllFailSaysWhy) {
    write("column.toml", column + "[sph]\nc0 = 2\n");
    const Outcome o = twinwake({"ladder", "column.toml", "--levels", "2"});
    EXPECT_EQ(o.status, 3) << o.out;
    EXPECT_NE(o.err.find("no run of the grid-convergence study is left: "), std::string::npos) << o.err;
    EXPECT_EQ(twinwake({"ladder", "column.toml", "--levels", "2"}).status, 3);  // nothing was saved: it begins anew
}

TEST_F(Command, AGridStudySaysInItsReportWhatTheBudgetLeftOutAndHowToMakeItAgain) {
    write("column.toml", column);
    // 0.10, 0.11 and 0.14 s by the cost model, without what this machine has taught
    const Outcome o = twinwake({"ladder", "column.toml", "--levels", "3", "--no-variations", "--budget", "0.3 s"});
    ASSERT_EQ(o.status, 0) << o.err << o.out;
    const std::string page = content(folder_ / "runs/column_ladder/report.html");
    EXPECT_NE(page.find("SPH at 0.02 m: left out"), std::string::npos);
    EXPECT_NE(page.find("twinwake ladder column.toml --levels 3 --no-variations --budget &#39;0.3 s&#39;"),
              std::string::npos);
    EXPECT_NE(content(folder_ / "runs/column_ladder/ladder.md").find("! SPH at 0.02 m: left out"), std::string::npos);
}

TEST_F(Command, OneMethodAlonePrintsItsQuantitiesAndLeavesAReport) {
    write("column.toml", column);
    const Outcome o = twinwake({"run", "column.toml", "--method", "sph", "--json", "facts.json"});
    ASSERT_EQ(o.status, 0) << o.err;
    for (const char* part :
         {"Peak pressure at P1", "Mean pressure at P1", "Splash height", "report: runs/column/report.html"})
        EXPECT_NE(o.out.find(part), std::string::npos) << part << o.out;
    EXPECT_EQ(o.out.find("cells"), o.out.rfind("particles or cells") + 13) << o.out;  // fvm is not predicted
    EXPECT_TRUE(fs::exists(folder_ / "runs/column/report.html"));
    const auto facts = nlohmann::json::parse(content(folder_ / "facts.json"));
    EXPECT_EQ(facts["runs"][0]["state"], "finished");
    EXPECT_FALSE(facts["quantities"].empty());
}

TEST_F(Command, AnotherScenesRecordInTheFolderIsLeftOutOfTheReport) {
    write("column.toml", column);
    ASSERT_EQ(twinwake({"run", "column.toml", "-q"}).status, 0);
    fs::rename(folder_ / "runs/column/sph", folder_ / "runs/column/fvm");
    const Outcome o = twinwake({"run", "column.toml", "--near-hull", "0.025"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_NE(o.out.find("fvm/record.h5: of another scene than this run, left out"), std::string::npos) << o.out;
    EXPECT_NE(content(folder_ / "runs/column/report.html").find("One run only, SPH"), std::string::npos);
}

TEST_F(Command, ARunThatFailedBeforeItSavedIsRunAnewWhereverItIsAskedForAgain) {
    write("column.toml", column + "[sph]\nc0 = 2\n");  // stopped before the first checkpoint
    ASSERT_EQ(twinwake({"run", "column.toml"}).status, 3);
    ASSERT_FALSE(fs::exists(folder_ / "runs/column/sph/checkpoint.h5"));
    const Outcome run = twinwake({"run", "column.toml", "--resume"});
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_NE(run.err.find("sound speed that is too low"), std::string::npos) << run.err;
    for (int k = 0; k < 2; ++k) {
        const Outcome ablate = twinwake({"ablate", "column.toml", "--effects", "shifting"});
        EXPECT_EQ(ablate.status, 3) << ablate.err;
        EXPECT_NE(ablate.err.find("the base failed, so there is nothing to compare with"), std::string::npos)
            << ablate.err;
    }
}

TEST_F(Command, AgreementCannotBeRequiredOfRunsOfOneSize) {
    write("column.toml", column);
    ASSERT_EQ(twinwake({"run", "column.toml", "-q"}).status, 0);
    const Outcome o = twinwake({"compare", "runs/column/sph", "runs/column/sph", "--require", "agree", "-q"});
    EXPECT_EQ(o.status, 4);
    EXPECT_NE(o.err.find("twinwake ladder"), std::string::npos) << o.err;
    ASSERT_EQ(twinwake({"ladder", "column.toml", "--levels", "2", "--no-variations", "-q"}).status, 0);
    const std::string grid_study = "runs/column_ladder/near_hull_";
    const Outcome alone = twinwake({"compare", "--ladder", grid_study + "20mm/sph", grid_study + "28.2843mm/sph",
                                    "--out", "cmp", "--require", "agree", "-q"});
    EXPECT_EQ(alone.status, 4);  // one method has nothing to agree with
    EXPECT_NE(alone.err.find("--require agree is not met: "), std::string::npos) << alone.err;
}

}  // namespace run_test
}  // namespace tw::test
