#include "program.h"

namespace tw::test {
namespace odd_names_test {

const std::vector<std::string> odd_titles = {"it's a \"title\"",
                                             "$(touch pwned)",
                                             "`touch pwned`",
                                             "#calc \"system(\\\"touch pwned\\\")\"",
                                             "#include \"/etc/passwd\"",
                                             "<script>alert(1)</script>",
                                             "; rm -rf x",
                                             "*/ }; functions { } /*",
                                             "%s%n%d",
                                             "über Ωmega\ttab\nline"};

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\t')
            out += "\\t";
        else if (c == '\n')
            out += "\\n";
        else
            out += c;
    }
    return out + "\"";
}

TEST_F(Command, ATitleIsOnlyEverText) {
    for (std::size_t i = 0; i < odd_titles.size(); ++i) {
        write("a.toml", with(planing, "\"planing\"", quoted(odd_titles[i])));
        const Outcome o = twinwake({"check", "a.toml"});
        EXPECT_EQ(o.status, 0) << o.err;
        EXPECT_EQ(o.out.substr(0, odd_titles[i].size()), odd_titles[i]);
        const std::string folder = "case" + std::to_string(i);
        EXPECT_EQ(twinwake({"case", "a.toml", folder}).status, 0);
    }
    // No directive and no code reached the OpenFOAM dictionaries: those words are nowhere in them.
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
        const std::string name = fs::relative(entry.path(), folder_).string();
        if (!entry.is_regular_file() || name.find("/system/") == std::string::npos) continue;
        for (const char* word : {"#calc", "#include", "$(", "touch", "passwd"})
            EXPECT_EQ(content(entry.path()).find(word), std::string::npos) << name;
    }
    EXPECT_FALSE(files().contains("pwned"));
}

TEST_F(Command, PathsMayHoldBlanksAndQuotes) {
    const std::string place = "my scenes (1)/it's $HOME/";
    write(place + "the scene; x.toml", with(planing, "shape = \"prismatic\"", "file  = \"my hull.stl\""));
    ASSERT_EQ(twinwake({"hull", "make", "prismatic", "-o", place + "my hull.stl"}).status, 0);
    const Outcome o = twinwake({"check", place + "the scene; x.toml"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_NE(o.out.find("my hull.stl"), std::string::npos);
    // A swapped hull is found from where the user stands, not from the scene's folder.
    ASSERT_EQ(twinwake({"hull", "make", "prismatic", "-o", "other hull.stl", "length=5"}).status, 0);
    EXPECT_EQ(twinwake({"check", place + "the scene; x.toml", "--hull", "other hull.stl"}).status, 0);
    const Outcome absent = twinwake({"check", place + "the scene; x.toml", "--hull", "my hull.stl"});
    EXPECT_EQ(absent.status, 2);
    EXPECT_NE(absent.err.find("--hull"), std::string::npos) << absent.err;
}

TEST_F(Command, OpenFoamRunsForAUserWhoStandsInAFolderWithBlanks) {
    if (twinwake({"doctor", "-q"}).status != 0) GTEST_SKIP() << "no sound OpenFOAM here";
    stands_in_ = "my runs (1)";
    fs::create_directories(folder_ / stands_in_);
    write("my runs (1)/a scene.toml", R"([hull]
shape = "box"
length = 0.4
beam = 0.4
height = 0.4
draft = 0.7
[tank]
min = [-0.8, -0.01, -1.2]
max = [0.8, 0.01, 0.6]
[domain]
dimensions = 2
[motion]
kind = "none"
[resolution]
near_hull = 0.1
spacing = 0.1
[run]
duration = 0.04
)");
    EXPECT_EQ(twinwake({"doctor", "-q"}).status, 0);
    const Outcome o = twinwake({"run", "a scene.toml", "--method", "fvm", "--no-twins", "--threads", "1", "-q"});
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(fs::exists(folder_ / stands_in_ / "runs/a scene/fvm/record.h5"));
}

}  // namespace odd_names_test
}  // namespace tw::test
