#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/numbers.h"
#include "compare/compare.h"
#include "tests/unit/compare/synthetic_pair.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace hostile_records_test {

const std::string hostile = "</title><script>alert('x')</script>\" onload=\"$(touch /tmp/x) `id` \x1b[31m #calc";

RunRecord hostile_run(const std::string& method) {
    RunRecord r =
        synthetic_run({.method = method, .lift = method == "sph" ? 2800.0 : 2500.0, .duration = 3, .step = 4e-3});
    for (auto& [name, text] : r.attributes)
        if (name != "method" && name != "symmetry_factor" && name != "motion") text = hostile;
    r.attributes["hull_finding_00"] = hostile;
    r.attributes["name " + hostile] = "x";
    r.scene_text = hostile;
    r.state = "stopped";
    r.reason = hostile;
    r.effects = {{hostile, true, true, hostile, hostile, 1}};
    r.phases = {{hostile, 1, 1}};
    r.table("height").time = {0, 1};
    r.table("height").column(hostile, hostile).values = {0.1, 0.2};
    return r;
}

TEST(HostileRecords, NoTextBecomesMarkupOrSteersTheTerminal) {
    const ScratchFolder folder;
    RunRecord a = hostile_run("sph"), b = hostile_run("fvm");
    a.attributes["method"] = b.attributes["method"] = hostile;
    const Comparison c = compare_records({a, b});
    const std::string page = read_text(write_report(c, folder.path()).html);
    EXPECT_EQ(page.find("<script>alert"), std::string::npos);
    EXPECT_EQ(page.find("\" onload=\""), std::string::npos);
    EXPECT_EQ(page.find('\x1b'), std::string::npos);
    EXPECT_NE(page.find("&lt;script&gt;"), std::string::npos);
    EXPECT_EQ(summary_text(c).find('\x1b'), std::string::npos);
    EXPECT_NE(summary_text(c).find("Lift: apart by "),
              std::string::npos);  // the sentence that names the runs is there
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "figures"))
        EXPECT_EQ(read_text(entry.path()).find("<script"), std::string::npos) << entry.path();
}

TEST(HostileRecords, TheCommandToPasteIsOneWordPerArgument) {
    const ScratchFolder folder;
    RunRecord r = synthetic_run({.duration = 0.2, .frames = false});
    r.attributes["scene_file"] = "a b'$(id).toml";
    const std::string page = read_text(write_report(compare_records({r}), folder.path()).html);
    EXPECT_NE(page.find("twinwake run &#39;a b&#39;\\&#39;&#39;$(id).toml&#39;"), std::string::npos);
}

TEST(HostileRecords, ACommandOfAForeignRecordIsQuotedWordByWord) {
    const ScratchFolder folder;
    RunRecord r = synthetic_run({.duration = 0.2, .frames = false});
    r.attributes["command"] = "run\n--trim\n-2 deg\nscene.toml; touch pwned\n$(id)";
    const std::string page = read_text(write_report(compare_records({r}), folder.path()).html);
    EXPECT_NE(
        page.find("<pre>twinwake run --trim &#39;-2 deg&#39; &#39;scene.toml; touch pwned&#39; &#39;$(id)&#39;\n"),
        std::string::npos);
}

TEST(HostileRecords, SenselessNumbersDoNotStopTheReport) {
    const ScratchFolder folder;
    RunRecord a = synthetic_run({.duration = 0.3, .step = 4e-3}), b = a;
    b.attributes["method"] = "fvm";
    for (auto& [name, value] : b.numbers) value = nan;
    b.attributes["symmetry_factor"] = "two";
    b.raster.voxel = 0;
    b.elements = infinite;
    b.peak_memory = nan;
    b.phases = {{"solving", nan, infinite}};
    for (double& v : b.table("forces").column("fz", "N").values) v = infinite;
    b.hull_pressure.assign(b.hull.triangles.size(), std::numeric_limits<float>::quiet_NaN());
    const Comparison c = compare_records({a, b});
    EXPECT_FALSE(c.find("lift")->values[1].known);
    write_report(c, folder.path());
    EXPECT_TRUE(std::filesystem::exists(folder / "report.html"));
    EXPECT_FALSE(summary_text(c).empty());
}

TEST(HostileRecords, EmptyRecordsGiveAnEmptyReportNotACrash) {
    const ScratchFolder folder;
    const Comparison c = compare_records({RunRecord{}, RunRecord{}});
    EXPECT_TRUE(c.quantities.empty());
    write_report(c, folder.path());
    EXPECT_TRUE(std::filesystem::exists(folder / "report.html"));
    RunRecord no_rows = synthetic_run({.duration = 0, .frames = false});
    for (auto& [name, table] : no_rows.tables) {
        table.time.clear();
        for (Column& column : table.columns) column.values.clear();
    }
    EXPECT_NO_THROW(write_report(compare_records({no_rows, no_rows}), folder.path()));
}

TEST(HostileRecords, RastersOfDifferentSizeAreComparedWithoutTouchingEachOther) {
    const ScratchFolder folder;
    RunRecord a = synthetic_run({.duration = 1.5, .step = 4e-3}), b = a;
    b.attributes["method"] = "fvm";
    b.raster = {{0, 0, -0.1}, 0.1, {3, 2, 2}};
    for (RasterFrame& f : b.frames) f.water.assign(12, 255);
    EXPECT_NO_THROW(write_report(compare_records({a, b}), folder.path()));
}

TEST(WriteFailure, AFullDiskLeavesTheOldReport) {
    const ScratchFolder folder;
    const Comparison c = compare_records({synthetic_run({.duration = 1.5, .frames = false})});
    write_report(c, folder.path());
    write_text_atomically(folder / "report.html", "the old page");
    rlimit old_limit{};
    getrlimit(RLIMIT_FSIZE, &old_limit);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{2048, old_limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    std::string message;
    try {
        write_report(c, folder.path());
    } catch (const RunError& e) { message = e.what(); }
    setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_NE(message.find("cannot be written"), std::string::npos) << message;
    EXPECT_EQ(read_text(folder / "report.html"), "the old page");
}

TEST(WriteFailure, AFolderThatIsAFileIsRefusedByName) {
    const ScratchFolder folder;
    write_text_atomically(folder / "taken", "x");
    EXPECT_THROW(write_report(compare_records({synthetic_run({.duration = 0.1, .frames = false})}), folder / "taken"),
                 RunError);
}

}  // namespace hostile_records_test
}  // namespace tw
