// `twinwake run` with its coarser members, as a user meets it.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "program.h"

namespace tw::test {
namespace twins_test {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Its coarser members have 350 and 125 particles.
const std::string column = falling_column("column", "duration = 0.3\ncheckpoint = 0.02", "[0.4, 0.04, 0.02]") +
                           "[sampling]\nsnapshots = 0.05\n";

nlohmann::json splash_in(const std::string& json) {
    const auto facts = nlohmann::json::parse(json);
    for (const auto& q : facts["quantities"])
        if (q["name"] == "splash_sheet_height") return q;
    return {};
}

TEST_F(Command, ARunHasCoarserTwinsAndItsNumbersAnErrorBar) {
    write("column.toml", column);
    const Outcome o = twinwake({"run", "column.toml", "--json", "facts.json"});
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(has(o.out, "grid triplet: 2 coarser runs, about ")) << o.out;
    EXPECT_TRUE(has(o.out, "--no-twins leaves them out")) << o.out;
    const fs::path out = folder_ / "runs/column";
    for (const char* twin : {"twins/near_hull_28.2843mm/sph", "twins/near_hull_40mm/sph"}) {
        EXPECT_TRUE(fs::exists(out / twin / "record.h5")) << twin;
        EXPECT_FALSE(fs::exists(out / twin / "snapshots")) << twin;
    }
    EXPECT_TRUE(fs::exists(out / "sph/record.h5"));  // where it has always been
    EXPECT_TRUE(fs::exists(out / "sph/snapshots"));
    const auto splash = splash_in(content(folder_ / "facts.json"));
    EXPECT_FALSE(splash["sources"][0]["discretisation"].is_null() && splash["sources"][0]["no_interval"] == "")
        << splash;
    EXPECT_TRUE(has(splash["sentence"], " by SPH, ")) << splash;
    EXPECT_EQ(splash["sentence"], splash_in(content(out / "report.json"))["sentence"]);
    for (const std::string& text : {o.out, content(out / "quantities.csv")})
        EXPECT_TRUE(has(text, splash["sentence"])) << splash["sentence"] << text;
    EXPECT_TRUE(has(content(out / "report.html"), "Values by size"));
    EXPECT_EQ(nlohmann::json::parse(content(folder_ / "facts.json"))["ladder"]["sides"][0]["runs"].size(), 3u);
}

TEST_F(Command, WithoutTwinsEveryFileSaysThatTheDiscretisationErrorIsNotEstimated) {
    write("column.toml", column);
    ASSERT_EQ(twinwake({"run", "column.toml", "--no-twins", "--out", "a", "-q"}).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "a/twins"));
    EXPECT_FALSE(has(content(folder_ / "a/report.html"), "Values by size"));
    // one more run beside it, as if another method had made it
    const Outcome o = twinwake({"compare", "a/sph", "a/sph", "--out", "pair", "--json", "facts.json"});
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_EQ(splash_in(content(folder_ / "facts.json"))["verdict"], "discretisation error not estimated");
    for (const std::string& text :
         {o.out, content(folder_ / "pair/report.html"), content(folder_ / "pair/quantities.csv")})
        EXPECT_TRUE(has(text, "discretisation error not estimated")) << text;
    EXPECT_TRUE(has(o.out, "apart by 0.0 % at this size")) << o.out;
    const Outcome required = twinwake({"run", "column.toml", "--no-twins", "--out", "b", "-q", "--require", "agree"});
    EXPECT_EQ(required.status, 4);
    EXPECT_TRUE(has(required.err, "without the coarser runs (twins) the discretisation error is not known"))
        << required.err;
}

TEST_F(Command, ARunStoppedAmongItsTwinsGoesOnThere) {
    write("column.toml", with(column, "duration = 0.3", "duration = 1.2"));
    const fs::path coarser_members = folder_ / "runs/column/twins";
    const Started run = start({"run", "column.toml"});
    for (int k = 0; k < 6000 && !fs::exists(coarser_members / "near_hull_28.2843mm/sph/checkpoint.h5"); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    kill(run.child, SIGINT);
    const Outcome stopped = finish(run);
    EXPECT_EQ(stopped.status, 3);
    EXPECT_TRUE(has(stopped.err, "coarser runs: stopped on request")) << stopped.err;
    ASSERT_TRUE(fs::exists(coarser_members / "near_hull_40mm/sph/record.h5"));
    EXPECT_FALSE(fs::exists(folder_ / "runs/column/sph"));
    const std::string coarsest = content(coarser_members / "near_hull_40mm/sph/record.h5");
    const Outcome again = twinwake({"run", "column.toml", "--resume"});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_TRUE(has(again.out, "SPH at 0.04 m: finished before, taken from")) << again.out;
    EXPECT_TRUE(content(coarser_members / "near_hull_40mm/sph/record.h5") == coarsest);
    EXPECT_TRUE(has(again.out, " by SPH, ")) << again.out;
}

TEST_F(Command, ATwinThatIsTooCoarseIsLeftOutAndNamed) {
    write("column.toml", with(with(column, "size = [0.4, 0.2, 0.4]", "size = [0.4, 0.06, 0.4]"),
                              "max = [0.2, 0.2, 0.2]", "max = [0.2, 0.06, 0.2]"));
    const Outcome o = twinwake({"run", "column.toml"});  // 40 mm do not fit twice into 60 mm
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(has(o.out, "! grid triplet: run at 2 times the scene's size: left out: column.toml:")) << o.out;
    EXPECT_TRUE(has(o.out, "grid triplet: 1 coarser run, about ")) << o.out;
    for (const char* file : {"report.html", "ladder.json"})
        EXPECT_TRUE(has(content(folder_ / "runs/column" / file), "run at 2 times")) << file;
    EXPECT_TRUE(fs::exists(folder_ / "runs/column/sph/record.h5"));
}

TEST_F(Command, TwinsOfAnotherSceneAreRefusedBeforeAnythingRuns) {
    write("column.toml", column);
    ASSERT_EQ(twinwake({"run", "column.toml", "-q"}).status, 0);
    fs::remove_all(folder_ / "runs/column/sph");
    write("column.toml", with(column, "max = [0.2, 0.2, 0.2]", "max = [0.2, 0.2, 0.1]"));
    const Outcome o = twinwake({"run", "column.toml"});
    EXPECT_EQ(o.status, 2);
    EXPECT_TRUE(has(o.err, "there is a run of another scene already; run anew with --overwrite")) << o.err;
    EXPECT_FALSE(fs::exists(folder_ / "runs/column/sph"));
    EXPECT_EQ(twinwake({"run", "column.toml", "--overwrite"}).status, 0);
}

TEST_F(Command, OpenWaterHasARunInAWiderBoxAndATankHasNone) {
    write("open.toml", planing);
    const Outcome open = twinwake({"run", "open.toml", "--method", "sph"});
    ASSERT_EQ(open.status, 0) << open.err;
    EXPECT_TRUE(has(open.out, "2 coarser runs and one in a wider box")) << open.out;
    EXPECT_TRUE(fs::exists(folder_ / "runs/open/twins/near_hull_200mm/box_1.5/sph/record.h5"));
    const Outcome grid_study = twinwake({"ladder", "open.toml", "--method", "sph", "--levels", "2", "--plan"});
    EXPECT_TRUE(has(grid_study.out, "box x 1.5")) << grid_study.out;
    write("tank.toml", column);
    EXPECT_FALSE(has(twinwake({"ladder", "tank.toml", "--levels", "2", "--plan"}).out, "box"));
    write("channel.toml", planing + "[water]\ndepth = 1\n[domain]\nsides = \"walls\"\n");
    const Outcome channel = twinwake({"ladder", "channel.toml", "--method", "sph", "--levels", "2", "--plan"});
    EXPECT_EQ(channel.status, 0) << channel.err;
    EXPECT_FALSE(has(channel.out, "box x 1.5")) << channel.out;
}

TEST_F(Command, ABudgetChoosesTheFinestSizesThatFit) {
    write("column.toml", column);
    const double own =
        nlohmann::json::parse(twinwake({"check", "column.toml", "--json", "-"}).out)["predicted"]["sph"]["seconds"];
    const double step = std::pow(2, 0.125);
    const auto sizes_for = [&](double budget) {  // without making the run
        twinwake({"run", "column.toml", "--no-twins", "--budget", fmt::format("{} s", budget), "--out",
                  fmt::format("{}", budget), "--collect", "-q"});
        return nlohmann::json::parse(content(folder_ / fmt::format("{}", budget) / "sizes.json"));
    };
    EXPECT_NEAR(double(sizes_for(1.05 * own)["scale"]), 1, 1e-9);
    EXPECT_NEAR(double(sizes_for(0.95 * own)["scale"]), step, 1e-9);
    const auto finer = sizes_for(5 * own);
    EXPECT_LT(double(finer["scale"]), 1 / step);
    EXPECT_LT(double(finer["seconds"]), 5 * own);
    EXPECT_GT(double(finer["seconds"]), 5 * own / 1.5);
    const Outcome none = twinwake({"run", "column.toml", "--budget", "1 us"});
    EXPECT_EQ(none.status, 2);
    EXPECT_TRUE(has(none.err, "no sizes that the scene allows fit")) << none.err;
}

TEST_F(Command, ABudgetThatPaysForFewSizesAcrossTheBeamSaysWhatTenTake) {
    const std::string scene = std::string(TWINWAKE_SOURCE) + "/studies/demo.toml";
    const auto said = [&](const std::string& out, const std::string& sizes) {  // without choosing, or making the run
        fs::create_directory(folder_ / out);
        write(out + "/sizes.json", R"({"budget": 60, "seconds": 60, )" + sizes + "}");
        return twinwake({"run", scene, "--method", "sph", "--budget", "1min", "--out", out, "--collect"}).out;
    };
    const std::string coarse = said("coarse", R"("scale": 2, "near_hull": 0.0324)");
    EXPECT_TRUE(has(coarse, "! near_hull is the beam over 7.1: ")) << coarse;
    EXPECT_TRUE(has(coarse, "; ten take about ")) << coarse;
    EXPECT_FALSE(has(said("fine", R"("scale": 1, "near_hull": 0.0162)"), "over ")) << "14 across the beam";
}

TEST_F(Command, ABudgetIsPlannedAgainWhenTheCoarsestRunsTakeLongerThanPredicted) {
    write("column.toml", column);
    // as if the machine were believed three times as fast as the table's
    const std::string model = nlohmann::json::parse(twinwake({"doctor", "--json", "-"}).out)["processor"];
    write("cache/twinwake/pace.json", nlohmann::json{{model, {{"sph", {0.35, 0.35, 0.35}}}}}.dump());
    const Outcome o = twinwake({"run", "column.toml", "--threads", "1", "--budget", "6 s", "--out", "out"});
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(has(o.out, "of the budget of 6 s are used: near_hull = ")) << o.out;
    const auto sizes = nlohmann::json::parse(content(folder_ / "out/sizes.json"));
    const auto number_after = [&](const std::string& words) {
        const std::size_t at = o.out.find(words);
        return at == std::string::npos ? NAN : std::stod(o.out.substr(at + words.size()));
    };
    const double first = number_after("budget of 6 s: near_hull = "), then = number_after("are used: near_hull = ");
    EXPECT_GT(then, 1.1 * first) << o.out;
    EXPECT_LE(then, double(sizes["near_hull"]) * (1 + 5e-3)) << "said to three digits";
    EXPECT_TRUE(has(o.out, fmt::format("SPH at {:g} m", 2 * double(sizes["near_hull"])))) << o.out;
}

TEST_F(Command, ARunWithABudgetGoesOnAtTheSizesItBeganWith) {
    write("column.toml", column);
    fs::create_directory(folder_ / "out");
    // as if the machine had been thought slower then
    write("out/sizes.json", R"({"budget": 3600, "scale": 1.25, "near_hull": 0.025, "seconds": 1})");
    const auto run = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"run", "column.toml", "--no-twins", "--threads", "1", "--json", "facts.json"};
        words.insert(words.end(), more.begin(), more.end());
        return twinwake(words);
    };
    const auto particles = [&] {
        return nlohmann::json::parse(content(folder_ / "facts.json"))["runs"][0]["elements"];
    };
    const Outcome other = run({"--out", "out", "--budget", "2h"});
    EXPECT_EQ(other.status, 2);
    EXPECT_TRUE(has(other.err, "chosen for --budget 3600 s")) << other.err;
    const Outcome o = run({"--out", "out", "--budget", "1h"});
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(has(o.out, "near_hull = 0.025 m, 1.25 times the scene's size")) << o.out;
    const double with_budget = particles();
    ASSERT_EQ(run({"--out", "same", "--scale", "1.25"}).status, 0);
    EXPECT_EQ(with_budget, particles());
    EXPECT_GT(with_budget, 0);
}

}  // namespace twins_test
}  // namespace tw::test
