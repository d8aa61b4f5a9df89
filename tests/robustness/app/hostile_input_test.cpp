// Input that is a text, and asks for more than there is: of memory, of time, of other people's folders.
#include <sys/resource.h>

#include <chrono>

#include "base/folder_lock.h"
#include "program.h"

namespace tw::test {
namespace hostile_input_test {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

const std::string gate = R"(title = "gate"
[tank]
min = ["-0.1 m", "-0.5 mm", 0]
max = ["0.3 m", "0.5 mm", "0.2 m"]
[domain]
dimensions = 2
[[water_block]]
min = ["-0.1 m", "-0.5 mm", 0]
max = [0, "0.5 mm", "0.14 m"]
[[body]]
name           = "gate"
elastic        = "plate"
plate          = ["79 mm", "1 m"]
cells          = [20, 1]
middle         = ["2.5 mm", 0, "39.5 mm"]
trim           = "90 deg"
thickness      = "5 mm"
youngs_modulus = "12 MPa"
poisson        = 0.4
density        = "1100 kg/m3"
clamped        = ["x_min"]
margin         = 0.008
skin           = "5 mm"
[motion]
kind = "none"
[resolution]
near_hull = "2 mm"
[run]
duration = "0.06 s"
methods  = ["sph"]
)";

const std::string tyre = R"(title = "tyre"
[tank]
min = ["-0.3 m", "-0.3 m", "-20 mm"]
max = ["0.3 m", "0.3 m", "0.4 m"]
[[water_block]]
min = ["-0.1 m", "-0.1 m", "-20 mm"]
max = ["0.1 m", "0.1 m", 0]
[[body]]
name        = "tyre"
elastic     = "tyre"
mass        = "10 kg"
draft       = "-4 mm"
drop_height = "30 cm"
cells       = [24, 10]
contact_depth = 1e-4
[motion]
kind = "none"
[resolution]
near_hull = "10 mm"
[run]
duration = "6 ms"
methods  = ["sph"]
)";

TEST_F(Command, ADeviceIsNoScene) {
    const auto start = std::chrono::steady_clock::now();
    const Outcome o = twinwake({"check", "/dev/zero"});
    EXPECT_EQ(o.status, 2);
    EXPECT_EQ(o.err, "/dev/zero: cannot be read: it is a device; expected a file\n");
    EXPECT_LT(seconds_since(start), 10);
}

TEST_F(Command, WhatAPlateCannotNeedIsRefusedBeforeItIsMade) {
    write("gate.toml", gate);
    EXPECT_EQ(twinwake({"check", "gate.toml"}).status, 0);
    for (const auto& [key, value, message] : {std::array{"margin         = 0.008", "margin = 1e6",
                                                         "bad.toml:22:10: [[body]] margin = 1000000: goes on for more"},
                                              std::array{"skin           = \"5 mm\"", "skin = 1e6",
                                                         "bad.toml:23:8: [[body]] skin = 1000000: is thicker than"}}) {
        write("bad.toml", with(gate, key, value));
        const auto start = std::chrono::steady_clock::now();
        const Outcome o = twinwake({"check", "bad.toml"});
        EXPECT_EQ(o.status, 2);
        EXPECT_EQ(o.err.find(message), 0u) << o.err;
        EXPECT_LT(seconds_since(start), 20);
    }
}

TEST_F(Command, AFloorAgainstWhichNoTyreCanBeFollowedIsRefusedAndWhatTheOthersTakeIsPredicted) {
    const auto predicted = [&](const std::string& depth) {
        write("tyre.toml", with(tyre, "contact_depth = 1e-4", "contact_depth = " + depth));
        return twinwake({"check", "tyre.toml"});
    };
    const auto seconds = [&](const std::string& depth) {
        const std::string text = predicted(depth).out;
        const std::size_t line = text.find("  sph  "), end = text.find('\n', line);
        return std::stod(text.substr(text.rfind(", ", end) + 2));
    };
    EXPECT_GT(seconds("2e-7"), 3 * seconds("1e-4")) << "ten times as many sub-steps";
    const Outcome o = predicted("1e-12");
    EXPECT_EQ(o.status, 2);
    EXPECT_NE(o.err.find("tyre.toml:15:17: [[body]] contact_depth = 1e-12: so stiff a floor cuts time into steps"),
              std::string::npos)
        << o.err;
}

TEST_F(Command, AReportIsNotWrittenThroughALinkNorBesideARunThatUsesItsFolder) {
    write("column.toml", falling_column("column", "duration = 0.02", "[0.4, 0.1, 0.02]"));
    ASSERT_EQ(twinwake({"run", "column.toml", "--out", "run", "--no-twins"}).status, 0);
    fs::create_directories(folder_ / "elsewhere");
    fs::create_directories(folder_ / "report");
    fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "report/figures");
    const Outcome through = twinwake({"compare", "run", "--out", "report"});
    EXPECT_EQ(through.status, 2);
    EXPECT_NE(through.err.find("report/figures: is a symbolic link"), std::string::npos) << through.err;
    EXPECT_TRUE(fs::is_empty(folder_ / "elsewhere"));

    const std::string before = content(folder_ / "run/report.json");
    {
        const FolderLock run(folder_ / "run");
        const Outcome beside = twinwake({"compare", "run", "--out", "run"});
        EXPECT_EQ(beside.status, 2);
        EXPECT_NE(beside.err.find("run: another run is using it"), std::string::npos) << beside.err;
    }
    EXPECT_EQ(content(folder_ / "run/report.json"), before);
    EXPECT_EQ(twinwake({"compare", "run", "--out", "run"}).status, 0);
}

/// Whatever memory there is: where it is enough for the program to be loaded, what it is too little for is said in words,
/// and nothing ends by a signal. What the system's loader does with less is not the program's.
TEST_F(Command, WithLittleMemoryAnEndIsSaidInWords) {
    write("column.toml", falling_column("column", "duration = 0.005", "[0.4, 0.1, 0.02]"));
    rlimit before{};
    getrlimit(RLIMIT_AS, &before);
    const auto with = [&](rlim_t megabytes, const std::vector<std::string>& arguments) {
        rlimit little = before;
        little.rlim_cur = megabytes << 20;
        setrlimit(RLIMIT_AS, &little);
        const Started s = start(arguments);
        setrlimit(RLIMIT_AS, &before);
        return finish(s);
    };
    int without = 0, enough = 0;
    for (rlim_t megabytes = 80; megabytes <= 160 && enough < 3; megabytes += 2) {
        const bool loaded = with(megabytes, {"--version"}).status == 0;
        const Outcome o = with(megabytes, {"check", "column.toml"});
        if (loaded) {
            EXPECT_LT(o.status, 128) << megabytes << " MB: " << o.err;
            EXPECT_EQ(o.err.find("unexpected"), std::string::npos) << megabytes << " MB: " << o.err;
        }
        ++(o.status == 0 ? enough : without);
    }
    EXPECT_GT(without, 0) << "or this test sees nothing";
}

}  // namespace hostile_input_test
}  // namespace tw::test
