#include <cctype>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "program.h"

namespace tw::test {
namespace {

TEST_F(Command, HelpAndVersionAreNoErrors) {
    for (const std::vector<std::string>& a :
         {std::vector<std::string>{"--help"}, {"--version"}, {"run", "--help"}, {"hull", "make", "--help"}}) {
        const Outcome o = twinwake(a);
        EXPECT_EQ(o.status, 0) << a.back();
        EXPECT_FALSE(o.out.empty()) << a.back();
    }
    EXPECT_NE(twinwake({"--version"}).out.find("twinwake 0."), std::string::npos);
}

TEST_F(Command, WrongUsageIsStatusTwoAndSaysWhatIsKnown) {
    EXPECT_EQ(twinwake({}).status, 2);
    const Outcome misspelt = twinwake({"chekc", "x.toml"});
    EXPECT_EQ(misspelt.status, 2);
    EXPECT_NE(misspelt.err.find("did you mean 'check'?"), std::string::npos) << misspelt.err;
    EXPECT_EQ(twinwake({"check"}).status, 2);
    EXPECT_EQ(twinwake({"check", "absent.toml"}).status, 2);
    EXPECT_EQ(twinwake({"check", "."}).status, 2);
    write("a.toml", planing);
    EXPECT_EQ(twinwake({"check", "a.toml", "--sped", "3"}).status, 2);
    EXPECT_EQ(twinwake({"check", "a.toml", "--speed", "3 kg"}).err,
              "--speed 3 kg: 'kg' does not measure the right thing; expected a unit like m/s, kn, kt, mph\n");
    EXPECT_EQ(twinwake({"run", "a.toml", "--method", "dns"}).status, 2);
    EXPECT_EQ(twinwake({"run", "a.toml", "--resume", "--overwrite"}).status, 2);
    EXPECT_EQ(twinwake({"compare", "absent"}).status, 2);
    EXPECT_EQ(files(), std::set<std::string>{"a.toml"});
}

TEST_F(Command, WhatThisMachineWasFoundToTakeIsInThePrediction) {
    write("a.toml", planing);
    const auto seconds = [&] {
        const Outcome o = twinwake({"check", "a.toml", "--json", "-"});
        EXPECT_EQ(o.status, 0) << o.err;
        return nlohmann::json::parse(o.out)["predicted"]["sph"]["seconds"].get<double>();
    };
    const double by_table = seconds();
    std::string model = "unknown processor", line;  // as record/this_machine.cpp names it
    for (std::ifstream info("/proc/cpuinfo"); std::getline(info, line);)
        if (line.starts_with("model name")) {
            model = line.substr(line.find(": ") + 2);
            break;
        }
    model += ", " + std::to_string(std::thread::hardware_concurrency()) + " threads";
    // doctor calibrates by a second of the particle engine
    EXPECT_NE(twinwake({"doctor"}).out.find("\npace "), std::string::npos);
    const double bench = nlohmann::json::parse(content(folder_ / "cache/twinwake/pace.json"))[model]["bench"];
    EXPECT_NEAR(seconds() / by_table, bench, 1e-3 * bench);
    write("cache/twinwake/pace.json", nlohmann::json{{model, {{"sph", {2, 30, 3}}}}}.dump());
    EXPECT_NEAR(seconds() / by_table, 3, 1e-3);  // the median
    write("cache/twinwake/pace.json", "{\"not\": [json");
    EXPECT_NEAR(seconds() / by_table, 1, 1e-3);
}

TEST_F(Command, EveryTemplateThatNeedsNoFilePassesItsOwnCheck) {
    for (const char* kind : {"planing", "seaplane", "tank"}) {
        const std::string file = std::string(kind) + ".toml";
        EXPECT_EQ(twinwake({"new", kind, file}).status, 0);
        const Outcome o = twinwake({"check", file});
        EXPECT_EQ(o.status, 0) << kind << o.err;
        EXPECT_NE(o.out.find("predicted"), std::string::npos);
    }
    EXPECT_EQ(twinwake({"new", "planing", "planing.toml"}).status, 2);  // a file that is there is not lost
    // The template for an own hull works as soon as that hull is there.
    EXPECT_EQ(twinwake({"new", "own", "own.toml"}).status, 0);
    EXPECT_EQ(twinwake({"check", "own.toml"}).err,
              "own.toml:4:9: [hull] file = \"my_hull.stl\": there is no file my_hull.stl\n");
    EXPECT_EQ(
        twinwake({"hull", "make", "prismatic", "-o", "my_hull.stl", "length=8 m", "beam=2 m", "height=1.5"}).status, 0);
    const Outcome own = twinwake({"check", "own.toml"});
    EXPECT_EQ(own.status, 0) << own.err;
}

TEST_F(Command, CheckPredictsForTheThreadsThatARunWouldGet) {
    write("a.toml", planing);
    const auto seconds = [&](const char* threads) {
        const Outcome o = twinwake({"check", "a.toml", "--threads", threads, "--json", "-"});
        EXPECT_EQ(o.status, 0) << o.err;
        return nlohmann::json::parse(o.out)["predicted"]["sph"]["seconds"].get<double>();
    };
    EXPECT_NEAR(seconds("1") / seconds("4"), 4, 1e-6);
    EXPECT_EQ(twinwake({"check", "a.toml", "--threads", "0"}).status, 2);
}

TEST_F(Command, TheReferenceNamesEveryKeyAndEffectAndHelpAndCompletionReadTheSameList) {
    const Outcome names = twinwake({"reference", "--names", "effects"});
    EXPECT_EQ(names.status, 0) << names.err;
    const std::string whole = twinwake({"reference"}).out, help = twinwake({"check", "--help"}).out,
                      ablate = twinwake({"ablate", "--help"}).out;
    std::istringstream lines(names.out);
    std::string name, together;
    for (std::string text = help; const char c : text)  // the help is broken into lines
        if (!std::isspace(static_cast<unsigned char>(c))) together += c;
    int count = 0;
    for (; std::getline(lines, name); ++count) {
        EXPECT_NE(whole.find("| `" + name + "` |"), std::string::npos) << name;
        EXPECT_NE(together.find(name), std::string::npos) << name;
        EXPECT_NE(ablate.find(name), std::string::npos) << name;
    }
    EXPECT_GE(count, 12);
    EXPECT_EQ(twinwake({"reference", "--out", "reference.md"}).status, 0);
    EXPECT_EQ(content(folder_ / "reference.md"), whole);
    EXPECT_NE(twinwake({"reference", "--names", "shapes"}).out.find("prismatic\n"), std::string::npos);
    // What the shell offers behind --effect is that list.
    write("complete.sh", "source " TWINWAKE_SOURCE
                         "/app/completion/twinwake.bash\n"
                         "COMP_WORDS=(" TWINWAKE_PROGRAM
                         " check a.toml --effect '')\nCOMP_CWORD=4\n_twinwake\n"
                         "printf '%s\\n' \"${COMPREPLY[@]}\" > offered\n");
    const std::string shell = "cd '" + folder_.string() + "' && bash complete.sh";
    ASSERT_EQ(std::system(shell.c_str()), 0);
    const std::string offered = content(folder_ / "offered");
    std::istringstream again(names.out);
    while (std::getline(again, name)) EXPECT_NE(offered.find(name + "=on\n"), std::string::npos) << name << offered;
}

TEST_F(Command, CheckGivesItsFactsToPrograms) {
    write("a.toml", planing);
    const Outcome o = twinwake({"check", "a.toml", "--json", "-"});
    EXPECT_EQ(o.status, 0);
    EXPECT_EQ(o.out.substr(0, 1), "{");  // nothing but JSON on standard output
    for (const char* key :
         {"\"particles\"", "\"cells\"", "\"hull\"", "\"findings\"", "\"effects\"", "\"name\"", "\"on\"", "\"reason\"",
          "\"influence\"", "\"cost\"", "\"predicted\"", "\"sph\"", "\"fvm\"", "\"seconds\"", "\"bytes\""})
        EXPECT_NE(o.out.find(key), std::string::npos) << key;
    EXPECT_EQ(twinwake({"check", "a.toml", "-q", "--json", "facts.json"}).out, "");
    EXPECT_EQ(content(folder_ / "facts.json"), o.out);
    EXPECT_EQ(twinwake({"check", "a.toml", "--json", "no/such/folder/facts.json"}).status, 3);
}

}  // namespace
}  // namespace tw::test
