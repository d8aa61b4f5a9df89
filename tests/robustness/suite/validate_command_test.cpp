#include <nlohmann/json.hpp>
#include <tuple>

#include "tests/robustness/app/program.h"

namespace tw::test {
namespace validate_command_test {

/// Water at rest in two dimensions, 0.2 m deep: some hundred particles.
const std::string still = R"(title = "still"
[tank]
size = [0.2, 0.02, 0.3]
[domain]
dimensions = 2
[[water_block]]
min = [0, 0, 0]
max = [0.2, 0.02, 0.2]
[resolution]
near_hull = 0.02
[[probe]]
name = "floor"
pressure = [0.1, 0, 0]
[run]
duration = 0.2
threads = 1
methods = ["sph"]
)";

std::string suite(const std::string& depth, const std::string& more = "") {
    return R"(title = "Mine"
[[case]]
name = "still"
family = "tanks"
why = "Water at rest."
scene = "still.toml"
)" + more + R"([[case.quantity]]
name = "floor"
unit = "Pa"
formula = "hydrostatic_pressure"
parameters = { depth = ")" +
           depth + R"(" }
goal = "10 %"
reading = { table = "pressure", column = "floor", kind = "mean", from = 0.1 }
[[case]]
name = "night"
tier = "night"
why = "Not now."
scene = "still.toml"
[[case.quantity]]
name = "pressure_mean:floor"
unit = "Pa"
truth = 1962
source = "hydrostatics"
goal = "10 %"
)";
}

class ValidateCommand : public Command {
protected:
    nlohmann::json report(const std::string& name = "out/validation.json") const {
        return nlohmann::json::parse(content(folder_ / name));
    }
    static bool says(const Outcome& o, const std::string& words) { return o.err.find(words) != std::string::npos; }
};

TEST_F(ValidateCommand, JudgesReusesItsRunsAndNamesWhatBecameWorse) {
    write("my/still.toml", still);
    write("my/suite.toml", suite("0.2 m"));
    const Outcome first = twinwake({"validate", "my", "--out", "out", "--require", "goals"});
    EXPECT_EQ(first.status, 0) << first.err << first.out;
    const nlohmann::json value = report()["cases"][0]["quantities"][0]["values"][0];
    EXPECT_NEAR(value["value"].get<double>(), 1962, 0.1 * 1962);
    EXPECT_GT(value["U_num"].get<double>(), 0);
    EXPECT_EQ(value["spacings"].size(), 3u);
    EXPECT_EQ(report()["cases"][1]["quantities"][0]["values"][0]["outcome"], "not_run");
    for (const char* file : {"validation.html", "validation.csv", "junit.xml", "still/ladder.md"})
        EXPECT_TRUE(fs::exists(folder_ / "out" / file)) << file;
    fs::rename(folder_ / "out/validation.json", folder_ / "old.json");

    write("my/suite.toml", suite("0.4 m"));  // now the truth is another
    const Outcome worse =
        twinwake({"validate", "my", "--out", "out", "--against", "old.json", "--require", "no-worse"});
    EXPECT_EQ(worse.status, 4) << worse.err;
    EXPECT_TRUE(says(worse, "--require no-worse is not met: still, floor, SPH")) << worse.err;
    EXPECT_NE(worse.out.find("finished before"), std::string::npos) << worse.out;
    EXPECT_EQ(report()["cases"][0]["quantities"][0]["values"][0]["value"], value["value"]);

    const Outcome pages = twinwake({"validate", "old.json", "--out", "again", "--pages", "docs"});
    EXPECT_EQ(pages.status, 0) << pages.err;
    EXPECT_EQ(content(folder_ / "again/validation.json"), content(folder_ / "old.json"));
    EXPECT_TRUE(fs::exists(folder_ / "docs/still.md") && fs::exists(folder_ / "docs/README.md"));
}

TEST_F(ValidateCommand, WhatIsNotRunIsTakenFromAnEarlierReport) {
    write("my/still.toml", still);
    write("my/suite.toml", suite("0.2 m"));
    ASSERT_EQ(twinwake({"validate", "my", "--out", "out"}).status, 0);
    std::string earlier = content(folder_ / "out/validation.json");
    for (std::size_t at = 0; (at = earlier.find("\"version\": \"", at)) != std::string::npos; ++at)
        earlier.insert(at + 12, "0.0.9 of ");
    write("earlier.json", earlier);
    const Outcome o =
        twinwake({"validate", "my", "--out", "night", "--case", "night", "--tier", "night", "--keep", "earlier.json"});
    EXPECT_EQ(o.status, 0) << o.err;
    const nlohmann::json cases = report("night/validation.json")["cases"];
    const nlohmann::json kept = cases[0]["quantities"][0]["values"][0], run = cases[1]["quantities"][0]["values"][0];
    EXPECT_EQ(kept["value"], nlohmann::json::parse(earlier)["cases"][0]["quantities"][0]["values"][0]["value"]);
    EXPECT_TRUE(kept["kept"].get<bool>());
    EXPECT_TRUE(kept["version"].get<std::string>().starts_with("0.0.9 of ")) << kept;
    EXPECT_FALSE(run["kept"].get<bool>());
    EXPECT_FALSE(run["version"].get<std::string>().empty());
    EXPECT_EQ(run["date"].get<std::string>().size(), 10u);
}

// A value that was kept of runs of another scene would stand beside the present truth as if it were of it.
TEST_F(ValidateCommand, OfAnotherSceneOrDefinitionNothingIsKept) {
    write("my/still.toml", still);
    write("my/suite.toml", suite("0.2 m"));
    ASSERT_EQ(twinwake({"validate", "my", "--out", "out"}).status, 0);
    fs::rename(folder_ / "out/validation.json", folder_ / "earlier.json");
    const auto kept_with = [&](const std::string& earlier) {
        const Outcome o = twinwake({"validate", "my", "--out", "night", "--case", "night", "--keep", earlier});
        EXPECT_EQ(o.status, 0) << o.err;
        const nlohmann::json c = report("night/validation.json")["cases"][0];
        return std::tuple{c["quantities"][0]["values"][0], c["why_not"].get<std::string>(), o};
    };
    const auto changed = [](const std::string& text, const std::string& was, const std::string& is) {
        return std::string(text).replace(text.find(was), was.size(), is);
    };
    const auto refused = [&](const std::string& part) {
        const auto [value, why_not, o] = kept_with("earlier.json");
        const std::string words = "not run with this version: its " + part + " changed since ";
        EXPECT_TRUE(says(o, "--keep: still, floor, SPH: " + words)) << o.err;
        EXPECT_EQ(value["outcome"], "not_run") << part;
        EXPECT_TRUE(value["value"].is_null()) << part;
        EXPECT_FALSE(value["kept"].get<bool>()) << part;
        EXPECT_NE(why_not.find(words), std::string::npos) << why_not;
    };
    const auto kept = [&](const char* what) {
        const auto [value, why_not, o] = kept_with("earlier.json");
        EXPECT_TRUE(value["kept"].get<bool>() && value["value"].is_number()) << what << ": " << o.err;
        EXPECT_EQ(value["kept_note"], "") << what;
    };
    kept("as it was");
    write("my/still.toml", changed(still, "title = \"still\"", "title = \"at rest\"  # no number"));
    kept("a title and a remark");
    for (const auto& [was, is] : {std::pair{"[0.1, 0, 0]", "[0.1, 0, 0.02]"},             // where it is measured
                                  {"max = [0.2, 0.02, 0.2]", "max = [0.2, 0.02, 0.18]"},  // how much water there is
                                  {"near_hull = 0.02", "near_hull = 0.01"},               // its own size
                                  {"duration = 0.2", "duration = 0.3"},
                                  {"[run]", "[sph]\ncfl = 0.3\n[run]"}}) {
        write("my/still.toml", changed(still, was, is));
        refused("scene has");
    }
    write("my/still.toml", still);
    write("my/suite.toml", changed(suite("0.2 m"), "from = 0.1", "from = 0.15"));
    refused("definition has");
    write("my/suite.toml", suite("0.2 m", "levels = 2\n"));
    refused("definition has");
    write("my/suite.toml", suite("0.2 m", "uncertain = { tank.size.3 = \"1 mm\" }\n"));
    refused("scene has");
    write("my/suite.toml", changed(suite("0.21 m"), "goal = \"10 %\"", "goal = \"20 %\""));
    kept("its truth and goal, by which it is judged");

    nlohmann::json older = nlohmann::json::parse(content(folder_ / "earlier.json"));  // of a version that says less
    for (nlohmann::json& c : older["cases"])
        for (nlohmann::json& q : c["quantities"]) {
            q.erase("basis");
            for (nlohmann::json& v : q["values"]) v.erase("made_for"), v.erase("kept_note");
        }
    write("older.json", older.dump());
    const auto [value, why_not, o] = kept_with("older.json");
    EXPECT_TRUE(value["kept"].get<bool>());
    EXPECT_NE(value["kept_note"].get<std::string>().find("whether its scene has changed since cannot be known"),
              std::string::npos);
    ASSERT_EQ(twinwake({"validate", "night/validation.json", "--out", "again", "--pages", "docs"}).status, 0);
    EXPECT_NE(content(folder_ / "docs/still.md").find("cannot be known"), std::string::npos);
}

TEST_F(ValidateCommand, MadeElsewhereTheReportIsTheSame) {
    write("my/still.toml", still);
    write("my/suite.toml", suite("0.2 m"));
    ASSERT_EQ(twinwake({"validate", "my", "--out", "here"}).status, 0);
    ASSERT_EQ(twinwake({"validate", "my", "--out", "there", "--emit", "snakemake"}).status, 0);
    const nlohmann::json study = nlohmann::json::parse(content(folder_ / "there/study/study.json"));
    ASSERT_EQ(study["members"].size(), 3u);
    for (const char* number : {"0", "1", "2"})
        EXPECT_EQ(twinwake({"member", "there", number, "--threads", "1"}).status, 0);
    const Outcome collected = twinwake({"validate", "my", "--out", "there", "--collect"});
    EXPECT_EQ(collected.status, 0) << collected.err;
    EXPECT_EQ(report("there/validation.json")["cases"][0]["quantities"][0]["values"][0]["value"],
              report("here/validation.json")["cases"][0]["quantities"][0]["values"][0]["value"]);
}

TEST_F(ValidateCommand, UncertainSpeedEntersTheInterval) {
    write("my/channel.toml", R"(title = "channel"
[motion]
kind = "stream"
speed = 2
[domain]
dimensions = 2
x = [-0.4, 0.4]
z = [-0.2, 0.2]
[resolution]
near_hull = 0.04
[run]
duration = 0.2
threads = 1
methods = ["sph"]
)");
    write("my/suite.toml", R"([[case]]
name = "channel"
why = "A stream."
scene = "channel.toml"
levels = 2
uncertain = { speed = 0.5 }
[[case.quantity]]
name = "speed"
unit = "m/s"
truth = 2
source = "the scene"
goal = "5 %"
reading = { table = "samples", column = "max_speed", from = 0.1 }
)");
    const Outcome o = twinwake({"validate", "my", "--out", "out"});
    EXPECT_EQ(o.status, 0) << o.err;
    const nlohmann::json value = report()["cases"][0]["quantities"][0]["values"][0];
    EXPECT_NEAR(value["input"].get<double>(), 0.5, 0.1) << o.out;
    EXPECT_EQ(value["inputs"]["motion.speed"], value["input"]);
    EXPECT_EQ(value["discretisation_by"].size(), 4u);
}

TEST_F(ValidateCommand, WhatIsWrongEndsInWordsBeforeAnyRun) {
    write("my/still.toml", still);
    const auto refused = [&](const std::vector<std::string>& arguments, const std::string& words) {
        std::vector<std::string> all{"validate"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Outcome o = twinwake(all);
        EXPECT_EQ(o.status, 2) << o.err;
        EXPECT_TRUE(says(o, words)) << o.err;
        EXPECT_FALSE(fs::exists(folder_ / "runs"));
    };
    refused({}, "expected the folder of a suite");
    refused({"my"}, "my: no suite: it has no suite.toml");
    write("my/suite.toml", suite("0.2"));
    refused({"my", "--case", "stil"}, "did you mean 'still'?");
    refused({"my", "--require", "no-worse"}, "--against FILE");
    refused({"my", "--against", "none.json"}, "none.json");
    write("my/suite.toml", suite("0.2 kg"));
    refused({"my"}, "suite.toml:11");
    EXPECT_NE(twinwake({"validate", "--formulas"}).out.find("hydrostatic_pressure [Pa] = rho g d"), std::string::npos);
}

TEST_F(ValidateCommand, AWrongSceneOrQuantityIsNamedAndTheOthersAreRun) {
    write("my/still.toml", still);
    write("my/suite.toml",
          suite("0.2 m") +
              "[[case]]\nname = \"none\"\nwhy = \"w\"\nscene = \"none.toml\"\n"
              "[[case.quantity]]\nname = \"lift\"\nunit = \"N\"\ntruth = 1\nsource = \"s\"\ngoal = 1\n"
              "[[case]]\nname = \"odd\"\nwhy = \"w\"\nscene = \"still.toml\"\n"
              "[[case.quantity]]\nname = \"pressure_mean:flor\"\nunit = \"Pa\"\ntruth = 1\nsource = \"s\"\ngoal = 1\n");
    const Outcome o = twinwake({"validate", "my", "--out", "out"});
    EXPECT_EQ(o.status, 3) << o.err;
    EXPECT_TRUE(says(o, "none: my/suite.toml:28:9: [[case]] scene = \"none.toml\": my/none.toml: cannot be read"))
        << o.err;
    EXPECT_TRUE(report()["cases"][0]["quantities"][0]["values"][0]["value"].is_number());
    const nlohmann::json odd = report()["cases"][3]["quantities"][0]["values"][0];
    EXPECT_EQ(odd["outcome"], "failed");
    EXPECT_NE(odd["why_not"].get<std::string>().find("did you mean 'pressure_mean:floor'?"), std::string::npos) << odd;
}

}  // namespace validate_command_test
}  // namespace tw::test
