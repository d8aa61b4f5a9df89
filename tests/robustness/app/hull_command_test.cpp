#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "base/vec3.h"
#include "program.h"

namespace tw::test {
namespace hull_command_test {

TEST_F(Command, AHullIsMadeInspectedAndConverted) {
    EXPECT_EQ(twinwake({"hull", "make", "box", "-o", "box.stl", "length=2", "beam=1000 mm", "height=0.5"}).status, 0);
    const Outcome info = twinwake({"hull", "info", "box.stl"});
    EXPECT_EQ(info.status, 0);
    EXPECT_NE(info.out.find("volume 1 m3"), std::string::npos) << info.out;
    // Read as millimetres and written in metres: a thousandth of the size, and the finding that it is odd.
    EXPECT_EQ(twinwake({"hull", "convert", "box.stl", "small.stl", "--unit", "mm"}).status, 0);
    EXPECT_NE(twinwake({"hull", "info", "small.stl"}).out.find("volume 1e-09 m3"), std::string::npos);
    EXPECT_EQ(twinwake({"hull", "convert", "box.stl", "box.obj"}).status, 2);
    EXPECT_EQ(files(), (std::set<std::string>{"box.stl", "small.stl"}));
}

/// The box from `low` to `high`, quadrilaterals turned outward, as an object of an OBJ file; `before`: corners of others.
std::string obj_box(const std::string& name, const Vec3& low, const Vec3& high, int before) {
    std::string text = "o " + name + "\n";
    for (int k = 0; k < 8; ++k)
        text +=
            fmt::format("v {} {} {}\n", (k & 1 ? high : low).x(), (k & 2 ? high : low).y(), (k & 4 ? high : low).z());
    constexpr int faces[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
    for (const auto& f : faces)
        text += fmt::format("f {} {} {} {}\n", before + f[0], before + f[1], before + f[2], before + f[3]);
    return text;
}

TEST_F(Command, BodiesOfOneFileAreListedTakenAndMadeASceneOf) {
    fs::create_directories(folder_ / "cad");
    write("cad/logs.obj",
          obj_box("Log 1", {0, 0, -50}, {1000, 200, 150}, 0) + obj_box("Log #2", {0, 500, -50}, {800, 700, 150}, 8));
    const Outcome info = twinwake({"hull", "info", "cad/logs.obj", "--unit", "mm"});
    EXPECT_NE(info.out.find("  solids by name: Log 1, Log #2\n"), std::string::npos) << info.out;
    EXPECT_NE(twinwake({"hull", "info", "cad/logs.obj#Log #2", "--unit", "mm"}).out.find("0.8 x 0.2 x 0.2 m"),
              std::string::npos);

    EXPECT_EQ(twinwake({"new", "body", "logs.toml", "--from", "cad/logs.obj", "--unit", "mm"}).status, 0);
    const std::string scene = content(folder_ / "logs.toml");
    EXPECT_NE(scene.find("name    = \"Log_2\"\nfile    = \"cad/logs.obj#Log #2\"\nunit    = \"mm\"\n"),
              std::string::npos)
        << scene;
    const Outcome check = twinwake({"check", "logs.toml"});
    EXPECT_EQ(check.status, 0) << check.err;
    EXPECT_NE(check.out.find("Log_1"), std::string::npos) << check.out;

    // As one body: check says what it is made of.
    write("raft.toml",
          "[tank]\nmin = [-1, -1, -1]\nmax = [2, 2, 1]\n[[body]]\nfile = \"cad/logs.obj\"\nunit = \"mm\"\n"
          "density = 500\n[motion]\nkind = \"none\"\n[resolution]\nnear_hull = 0.05\n[run]\nduration = 1\n");
    const Outcome raft = twinwake({"check", "raft.toml"});
    EXPECT_NE(raft.out.find("logs.obj names several solids, which are taken together: Log 1, Log #2; file = "
                            "\"cad/logs.obj#Log 1\" takes one"),
              std::string::npos)
        << raft.out << raft.err;

    EXPECT_NE(twinwake({"new", "tank", "a.toml", "--from", "cad/logs.obj"}).err.find("twinwake new body a.toml --from"),
              std::string::npos);
    EXPECT_EQ(twinwake({"new", "body", "a.toml", "--unit", "mm"}).status, 2);
    EXPECT_EQ(twinwake({"new", "body", "a.toml", "--from", "none.step"}).status, 2);
    EXPECT_EQ(files(), (std::set<std::string>{"cad", "cad/logs.obj", "logs.toml", "raft.toml"}));
}

TEST_F(Command, AHullsFileMakesASceneOfItsSize) {
    fs::create_directories(folder_ / "cad");
    write("cad/log.obj", obj_box("Log", {0, -500, 0}, {6000, 500, 900}, 0));
    ASSERT_EQ(twinwake({"new", "hull", "log.toml", "--from", "cad/log.obj", "--unit", "mm"}).status, 0);
    const std::string scene = content(folder_ / "log.toml");
    for (const char* line : {"title = \"log at 7.7 m/s\"\n", "\nfile  = \"cad/log.obj\"", "\nunit  = \"mm\"",
                             "\ndraft = \"0.3 m\"", "\nspeed = \"7.7 m/s\"", "\nnear_hull = \"0.067 m\""})
        EXPECT_NE(scene.find(line), std::string::npos) << line << scene;
    const Outcome check = twinwake({"check", "log.toml"});
    EXPECT_EQ(check.status, 0) << check.err;
    EXPECT_NE(check.out.find("log.obj: 6.056 m long, 1 m wide"), std::string::npos) << check.out;
}

TEST_F(Command, WrongHullArgumentsNameTheKnownOnes) {
    EXPECT_NE(twinwake({"hull", "make", "box", "-o", "b.stl", "lenght=2"}).err.find("did you mean 'length'?"),
              std::string::npos);
    EXPECT_NE(
        twinwake({"hull", "make", "box", "-o", "b.stl", "length=2 kg"}).err.find("length=2 kg: 'kg' does not measure"),
        std::string::npos);
    EXPECT_EQ(twinwake({"hull", "make", "bx", "-o", "b.stl"}).status, 2);
    EXPECT_EQ(twinwake({"hull", "info", "absent.stl"}).status, 2);
    EXPECT_EQ(twinwake({"hull", "info", "absent.stl", "--unit", "parsec"}).status, 2);
    EXPECT_TRUE(files().empty());
    EXPECT_NE(twinwake({"hull", "make"}).out.find("deadrise"), std::string::npos);  // the list of shapes and parameters
}

TEST_F(Command, AHullIsNotWrittenOverItsSourceNorToNowhere) {
    EXPECT_EQ(twinwake({"hull", "make", "box"}).err, "hull make box: no file to write; expected -o FILE.stl\n");
    ASSERT_EQ(twinwake({"hull", "make", "box", "-o", "box.stl"}).status, 0);
    const std::string before = content(folder_ / "box.stl");
    for (const char* action : {"convert", "repair"})
        for (const char* out : {"box.stl", "./box.stl"}) {
            const Outcome o = twinwake({"hull", action, "box.stl", out, "--unit", "mm"});
            EXPECT_EQ(o.status, 2) << action;
            EXPECT_NE(o.err.find("is the input file, which would be overwritten"), std::string::npos) << o.err;
        }
    EXPECT_EQ(content(folder_ / "box.stl"), before);
}

TEST_F(Command, RepairIsSuggestedForWhatItRepairs) {
    ASSERT_EQ(twinwake({"hull", "make", "box", "-o", "box.stl"}).status, 0);
    std::string bytes = content(folder_ / "box.stl");
    std::swap_ranges(bytes.begin() + 84 + 12, bytes.begin() + 84 + 24, bytes.begin() + 84 + 24);  // two corners
    write("flipped.stl", bytes);
    EXPECT_NE(twinwake({"hull", "info", "flipped.stl"}).out.find("\"twinwake hull repair\" repairs it"),
              std::string::npos);
    EXPECT_EQ(twinwake({"hull", "repair", "flipped.stl", "mended.stl"}).status, 0);
    const std::string whole = content(folder_ / "box.stl");
    std::string open = whole.substr(0, whole.size() - 50);
    open[80] = static_cast<char>(open[80] - 1);
    write("open.stl", open);
    const std::string found = twinwake({"hull", "info", "open.stl"}).out;
    EXPECT_EQ(found.find("hull repair"), std::string::npos) << found;
    EXPECT_NE(found.find("close it in your CAD"), std::string::npos) << found;
    EXPECT_EQ(twinwake({"hull", "repair", "open.stl", "no.stl"}).status, 2);
}

TEST_F(Command, AnOpenHullIsFoundAndNotSilentlyMended) {
    ASSERT_EQ(twinwake({"hull", "make", "box", "-o", "box.stl"}).status, 0);
    std::string bytes = content(folder_ / "box.stl");
    bytes.resize(bytes.size() - 50);  // one triangle of 50 bytes less
    bytes[80] = static_cast<char>(bytes[80] - 1);
    write("open.stl", bytes);
    const Outcome o = twinwake({"hull", "info", "open.stl"});
    EXPECT_EQ(o.status, 2);
    EXPECT_NE(o.out.find("open_edges"), std::string::npos) << o.out;
    EXPECT_NE(o.out.find("usable: no"), std::string::npos);
    const Outcome quiet = twinwake({"hull", "info", "open.stl", "-q"});
    EXPECT_EQ(quiet.status, 2);
    EXPECT_EQ(quiet.out, "");
    EXPECT_NE(quiet.err.find("open.stl: not usable"), std::string::npos) << quiet.err;  // quiet is not silent of errors
}

}  // namespace hull_command_test
}  // namespace tw::test
