#include <algorithm>

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
