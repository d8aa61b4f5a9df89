// The report in a real browser (Chromium, where it is installed): its one script is allowed to run, draws the view and
// complains of nothing.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "base/atomic_file.h"
#include "compare/compare.h"
#include "tests/unit/compare/synthetic_pair.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace browser_test {

bool installed() { return std::system("command -v chromium > /dev/null 2>&1") == 0; }

/// The page after its script has run, as markup, and what the browser logged of it. `page`: a path without quotes.
std::pair<std::string, std::string> opened(const std::filesystem::path& page, const std::filesystem::path& profile) {
    const std::filesystem::path log = profile.string() + ".log";
    const std::string command =
        "timeout 100 chromium --headless=new --no-sandbox --user-data-dir='" + profile.string() +
        "' --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --enable-logging=stderr "
        "--virtual-time-budget=8000 --dump-dom 'file://" +
        page.string() + "' 2> '" + log.string() + "'";
    std::string markup;
    std::array<char, 65536> part;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return {};
    while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe)) markup.append(part.data(), n);
    pclose(pipe);
    return {markup, read_text(log)};
}

TEST(Browser, TheReportsViewRunsOfflineUnderItsOwnPolicy) {
    if (!installed()) GTEST_SKIP() << "no chromium here";
    const ScratchFolder folder;
    const Comparison c = compare_records({synthetic_run({}), synthetic_run({.method = "fvm", .lift = 2600})});
    const auto [markup, log] = opened(write_report(c, folder.path()).html, folder / "profile");
    EXPECT_NE(markup.find("<div id=\"view3d-stage\">"), std::string::npos) << log;  // no longer hidden
    EXPECT_NE(markup.find("id=\"view3d-fallback\" hidden"), std::string::npos);
    EXPECT_EQ(log.find("Uncaught"), std::string::npos) << log;
    EXPECT_EQ(log.find("Content Security Policy"), std::string::npos) << log;
}

// Shaders, too, are compiled there alone: a body on its way through the water, with the water cut open.
TEST(Browser, TheViewDrawsABodyThatMovesAndOffersToCutTheWaterOpen) {
    if (!installed()) GTEST_SKIP() << "no chromium here";
    RunRecord r = synthetic_run({});
    r.bodies.push_back({"body_buoy", r.hull, Vec3::Zero()});
    r.attributes["motion"] = "none";
    r.hull = {};
    r.hull_pressure.clear();
    r.hull_wet.clear();
    Table& t = r.table("body_buoy");
    for (const double time : {0.0, 2.0}) {
        t.time.push_back(time);
        for (const char* column : {"x", "y", "z", "qx", "qy", "qz"}) t.column(column, "").values.push_back(0.1 * time);
        t.column("q0", "-").values.push_back(1);
    }
    const ScratchFolder folder;
    const auto [markup, log] = opened(write_report(compare_records({r}), folder.path()).html, folder / "profile");
    EXPECT_NE(markup.find("<div id=\"view3d-stage\">"), std::string::npos) << log;
    EXPECT_NE(markup.find("water cut open</label>"), std::string::npos);
    EXPECT_NE(markup.find("bodies</label>"), std::string::npos);
    EXPECT_EQ(log.find("Uncaught"), std::string::npos) << log;
    EXPECT_EQ(log.find("INVALID_"), std::string::npos) << log;  // what WebGL says of wrong calls
}

}  // namespace browser_test
}  // namespace tw
