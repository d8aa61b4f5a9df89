#include <sys/stat.h>

#include <cctype>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "program.h"
#include "test_paths.h"

namespace tw::test {
namespace command_test {

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

TEST_F(Command, TwoReportsAreComparedWithEachOther) {
    const auto report = [](const std::string& drag) {
        return R"({"sources":[{"name":"sph","numbers":{"speed":8},"attributes":{}}],"quantities":[{"name":"drag","label":)"
               R"("Drag","unit":"N","definition":"force","values":[)" +
               drag + R"(],"intervals":[2]}]})";
    };
    write("a.json", report("250"));
    write("b.json", report("240"));
    const Outcome o = twinwake({"compare", "a.json", "b.json", "--json", "facts.json"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_NE(o.out.find("beyond the interval"), std::string::npos) << o.out;
    EXPECT_EQ(nlohmann::json::parse(content(folder_ / "facts.json"))["quantities"][0]["difference"], -10);
    EXPECT_NE(twinwake({"compare", "a.json"}).err.find("expected two reports"), std::string::npos);
    EXPECT_NE(twinwake({"compare", "a.json", "b.json", "--out", "o"}).err.find("--out is for records"),
              std::string::npos);
    write("c.json", "{}");
    const Outcome none = twinwake({"compare", "a.json", "c.json"});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("c.json: is not as this version writes it"), std::string::npos) << none.err;
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
    fs::remove(folder_ / "cache/twinwake/pace.json");
    ASSERT_EQ(mkfifo((folder_ / "cache/twinwake/pace.json").c_str(), 0600), 0);
    EXPECT_NEAR(seconds() / by_table, 1, 1e-3) << "and nobody waits for the pipe's other end";
}

TEST_F(Command, EveryTemplateThatNeedsNoFilePassesItsOwnCheck) {
    for (const char* kind : {"planing", "seaplane", "tank", "waves", "body"}) {
        const std::string file = std::string(kind) + ".toml";
        EXPECT_EQ(twinwake({"new", kind, file}).status, 0);
        const Outcome o = twinwake({"check", file});
        EXPECT_EQ(o.status, 0) << kind << o.err;
        EXPECT_NE(o.out.find("predicted"), std::string::npos);
    }
    EXPECT_EQ(twinwake({"new", "planing", "planing.toml"}).status, 2);  // a file that is there is not lost
    // The template for an own hull works as soon as that hull is there.
    EXPECT_EQ(twinwake({"new", "hull", "own.toml"}).status, 0);
    EXPECT_EQ(twinwake({"check", "own.toml"}).err,
              "own.toml:5:9: [hull] file = \"my_hull.stl\": there is no file my_hull.stl\n");
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
    const double one = seconds("1"), two = seconds("2"), four = seconds("4");  // the start is not shared out
    EXPECT_NEAR((one - two) / (two - four), 2, 1e-6);
    EXPECT_GT(one / four, 2);
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
    write("complete.sh", "source <(" TWINWAKE_PROGRAM
                         " completion bash)\n"
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
    EXPECT_EQ(twinwake({"check", "a.toml", "--json", "no/such/folder/facts.json"}).status, 2);
}

TEST_F(Command, CheckDrawsTheSizesOfParticlesAndCells) {
    write("a.toml", planing + "[domain]\nahead = \"4 m\"\n[sph]\nlevels = 2\nzone = 8\n");
    const Outcome o = twinwake({"check", "a.toml", "--picture", "sizes.svg"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_NE(o.out.find("buffer"), std::string::npos) << "a line for each size";
    const std::string picture = content(folder_ / "sizes.svg");
    EXPECT_EQ(picture.substr(0, 5), "<?xml");
    for (const char* drawn : {"particles (sph)", "cells (fvm)", "Side view", "Plan view"})
        EXPECT_NE(picture.find(drawn), std::string::npos) << drawn;
    EXPECT_EQ(twinwake({"check", "a.toml", "--picture", "no/such/folder/sizes.svg"}).status, 2);
}

TEST_F(Command, ASweepRunsTheMethodsOfItsSceneOrThoseAskedFor) {
    write("a.toml", planing + "methods = [\"sph\"]\n");
    const auto methods = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"sweep", "a.toml", "--speeds", "7 m/s", "8 m/s", "--twins", "none"});
        more.insert(more.end(), {"--emit", "snakemake", "--overwrite"});
        const Outcome o = twinwake(more);
        EXPECT_EQ(o.status, 0) << o.err;
        std::string all;
        const auto study = nlohmann::json::parse(content(folder_ / "runs/a_sweep/study/study.json"));
        for (const auto& m : study["members"]) all += m["method"].get<std::string>() + " ";
        return all;
    };
    EXPECT_EQ(methods({}), "sph sph ");
    EXPECT_EQ(methods({"--method", "fvm"}), "fvm fvm ");
    EXPECT_EQ(methods({"--method", "both"}), "sph fvm sph fvm ");
}

TEST_F(Command, ASweepOverWaveLengthsHasARunWithoutTheBodiesForEach) {
    write("box.toml",
          "[tank]\nmin = [-2, 0, -0.4]\nmax = [2, 0.02, 0.2]\n[domain]\ndimensions = 2\n[wave]\nheight = 0.06\n"
          "period = 0.8\n[[body]]\nname = \"box\"\nshape = \"box\"\nlength = 0.2\nbeam = 0.02\nheight = 0.1\n"
          "draft = 0.05\ndensity = 500\n[resolution]\nnear_hull = 0.015\n[run]\nmethods = [\"sph\"]\n");
    const Outcome o =
        twinwake({"sweep", "box.toml", "--wave-lengths", "0.8 m", "1.1 m", "--twins", "none", "--emit", "snakemake"});
    ASSERT_EQ(o.status, 0) << o.err;
    std::string folders;
    const auto study = nlohmann::json::parse(content(folder_ / "runs/box_sweep/study/study.json"));
    for (const auto& m : study["members"]) {
        folders += m["folder"].get<std::string>() + " ";
        EXPECT_EQ(m["changes"]["wave_length"], folders.find("1.1") == folders.npos ? 0.8 : 1.1);
    }
    const std::string at = "runs/box_sweep/waves-of-";
    const Outcome none = twinwake({"sweep", "box.toml", "--wave-lengths", "9 m", "--emit", "snakemake"});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("none of its scenes can be run"), std::string::npos) << none.err;
    EXPECT_EQ(folders, at + "0.8-m/without_bodies/sph " + at + "0.8-m/sph " + at + "1.1-m/without_bodies/sph " + at +
                           "1.1-m/sph ");
}

TEST_F(Command, CheckWritesAPageOfWhatWouldBeSolved) {
    write("a.toml", with(planing, "[run]", "[sph]\nc0 = 20\n[run]"));
    const Outcome o = twinwake({"check", "a.toml", "--html", "a.html"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_NE(o.out.find("written: a.html"), std::string::npos) << o.out;
    const std::string page = content(folder_ / "a.html");
    const auto first = page.find("<h2>Hull");
    ASSERT_NE(first, std::string::npos) << page;
    EXPECT_LT(page.find("this sound speed, which compresses it"), first) << "a warning stands above the picture";
    for (const char* part : {"<svg", "Side view", "class=\"shadow", "<td>ventilation", "scene hash"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    for (const char* loads : {" src=", "<link", "<script"})
        EXPECT_EQ(page.find(loads), std::string::npos) << "it loads nothing from anywhere: " << loads;

    write("tank.toml", falling_column("tank", "duration = 0.1", "[0.4, 0.1, 0.02]"));
    EXPECT_EQ(twinwake({"check", "tank.toml", "--html", "tank.html"}).status, 0) << "one size everywhere";
    const std::string tank = content(folder_ / "tank.html");
    EXPECT_NE(tank.find(">0.02 m<"), std::string::npos);
    EXPECT_NE(tank.find("force up: "), std::string::npos) << "what has no stream has no lift";
    for (const char* of_a_hull : {"<td>drag: ", "; lift: "}) EXPECT_EQ(tank.find(of_a_hull), std::string::npos);
    EXPECT_EQ(twinwake({"check", "tank.toml", "--html", "no/such/folder/a.html"}).status, 2);
}

TEST_F(Command, LostOutputIsNoSuccess) {
    write("a.toml", planing);
    write("table.csv", "h,drag\n1,1\n2,1.1\n4,1.4\n");
    const std::vector<std::vector<std::string>> commands{{"check", "a.toml"},
                                                         {"check", "a.toml", "--json", "-"},
                                                         {"new", "planing", "b.toml"},
                                                         {"uncertainty", "table.csv"},
                                                         {"hull", "make"},
                                                         {"--help"},
                                                         {"bench", "--seconds", "0.1", "--particles", "1000"}};
    for (const std::vector<std::string>& command : commands) {
        const Outcome o = twinwake(command, 0, "/dev/full");
        EXPECT_EQ(o.status, 2) << command[0];
        EXPECT_NE(o.err.find("standard output: cannot be written: No space left on device"), std::string::npos)
            << command[0] << o.err;
    }
    EXPECT_EQ(twinwake({"check", "a.toml", "-q"}, 0, "/dev/full").status, 0);  // nothing was to be printed
    EXPECT_EQ(twinwake({"check", "absent.toml"}, 0, "/dev/full").status, 2);
}

/// A reader that has read enough ends the program, as in `twinwake check a.toml --html a.html | head`.
TEST_F(Command, FilesAreThereWhenNobodyReadsTheWords) {
    write("a.toml", planing);
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    close(ends[0]);
    const std::string closed = "/dev/fd/" + std::to_string(ends[1]);
    twinwake({"check", "a.toml", "--html", "a.html", "--picture", "a.svg", "--json", "a.json"}, 0, closed.c_str());
    close(ends[1]);
    EXPECT_EQ(files(), (std::set<std::string>{"a.html", "a.json", "a.svg", "a.toml"}));
}

TEST_F(Command, ATargetThatCannotBeWrittenIsStatusTwoEverywhere) {
    write("a.toml", planing);
    write("table.csv", "h,drag\n1,1\n2,1.1\n4,1.4\n");
    for (const char* target : {"/dev/full", "no/such/folder/facts.json", "."}) {
        for (const std::vector<std::string>& command :
             {std::vector<std::string>{"check", "a.toml"}, {"uncertainty", "table.csv"}}) {
            std::vector<std::string> all = command;
            all.insert(all.end(), {"--json", target});
            const Outcome o = twinwake(all);
            EXPECT_EQ(o.status, 2) << command[0] << " " << target << o.err;
            EXPECT_EQ(o.err.substr(0, 7), "--json ") << o.err;
        }
    }
    EXPECT_TRUE(fs::is_character_file("/dev/full"));  // and not a file that took its place
    EXPECT_EQ(twinwake({"new", "planing", "no/such/folder/a.toml"}).status, 2);
    EXPECT_EQ(twinwake({"hull", "make", "box", "-o", "no/such/folder/box.stl"}).status, 2);
    EXPECT_EQ(twinwake({"case", "a.toml", "a.toml/case"}).status, 2);
    EXPECT_EQ(files(), (std::set<std::string>{"a.toml", "table.csv"}));
}

TEST_F(Command, QuietHidesNoError) {
    const Outcome doctor = twinwake({"doctor", "-q"});
    EXPECT_EQ(doctor.out, "");
    EXPECT_EQ(doctor.err.empty(), doctor.status == 0) << doctor.err;
    EXPECT_NE(twinwake({"check", "absent.toml", "-q"}).err, "");
}

TEST_F(Command, NoControlCharacterOfASceneReachesTheTerminal) {
    write("a.toml", with(planing, "\"planing\"", "\"a\\u001b[2J\\u001b]0;owned\\u0007 \\u009b31m title\""));
    const Outcome o = twinwake({"check", "a.toml"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_EQ(o.out.substr(0, 12), "a?[2J?]0;own") << o.out;
    for (const char* bytes : {"\x1b", "\x07", "\xC2\x9B"}) EXPECT_EQ(o.out.find(bytes), std::string::npos);
    write("b.toml", with(planing, "draft =", "\"dr\\u001b[31maft\" ="));
    EXPECT_EQ(twinwake({"check", "b.toml"}).err.find('\x1b'), std::string::npos);
}

}  // namespace command_test
}  // namespace tw::test
