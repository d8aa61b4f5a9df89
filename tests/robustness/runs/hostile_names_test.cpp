#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "program.h"
#include "record/run_record.h"

namespace tw::test {
namespace hostile_names_test {

std::string content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// A name is a name: never a command, a directive, a path elsewhere, or markup.
TEST(HostileNames, StayNames) {
    const std::string title =
        R"(<script>alert(1)</script> $(touch pwned) `touch pwned` "; touch pwned; #calc "system" ../../x)";
    const ScratchFolder scratch("names");
    const auto folder = scratch.path() / "with spaces $(touch pwned) 'single' \"double\" <b>;&";
    std::filesystem::create_directories(folder);
    const auto scene = write_small_scene(folder / "a scene $(touch pwned).toml", 0.1, title);
    const auto out = folder / "the run $(touch pwned)";

    Program run({"run", scene.string(), "--method", "sph", "--out", out.string()}, scratch.path());
    ASSERT_EQ(run.wait(), 0) << run.output();
    EXPECT_EQ(read_record(out / "sph" / "record.h5").attributes.at("title"), title);

    Program compare({"compare", (out / "sph").string(), (out / "sph").string(), "--out", (out / "report").string()},
                    scratch.path());
    EXPECT_EQ(compare.wait(), 0) << compare.output();
    int pages = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.path())) {
        EXPECT_EQ(entry.path().filename().string().find("pwned") == 0, false) << entry.path();
        if (entry.path().extension() == ".html") {
            ++pages;
            EXPECT_EQ(content(entry.path()).find("<script>alert"), std::string::npos) << entry.path();
            EXPECT_NE(content(entry.path()).find("&lt;script&gt;alert"), std::string::npos) << entry.path();
        }
    }
    EXPECT_GE(pages, 1);
}

}  // namespace hostile_names_test
}  // namespace tw::test
