// Two report.json files: what their runs say otherwise.
#include "compare/reports/two_reports.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "compare/compare.h"
#include "tests/unit/compare/synthetic_pair.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace two_reports_test {

ReportFacts report_of(const ScratchFolder& folder, const std::string& name, std::vector<RunRecord> records) {
    CompareOptions options;
    options.force = true;
    write_text_atomically(folder / name, comparison_json(compare_records(std::move(records), options)));
    return read_report(folder / name);
}
RunRecord run(const std::string& method, double lift, unsigned seed = 1) {
    return synthetic_run({.method = method, .lift = lift, .step = 4e-3, .seed = seed, .frames = false});
}
const ReportChange& change(const TwoReports& t, const std::string& quantity, const std::string& run) {
    for (const ReportChange& c : t.headline)
        if (c.quantity == quantity && c.run == run) return c;
    throw std::runtime_error("no " + quantity + " of " + run);
}

TEST(TwoReports, EachRunIsComparedWithItselfAndTheIntervalIsOfBoth) {
    const ScratchFolder folder;
    const TwoReports t = compare_reports(report_of(folder, "a.json", {run("sph", 2800), run("fvm", 2600)}),
                                         report_of(folder, "b.json", {run("fvm", 2603, 2), run("sph", 3000, 2)}));
    const ReportChange &sph = change(t, "lift", "sph"), &fvm = change(t, "lift", "fvm");
    EXPECT_NEAR(sph.difference, 200, 60) << "of the same method, whatever the order in the reports";
    EXPECT_NEAR(fvm.difference, 3, 60);
    EXPECT_GT(sph.first.half_width, 0);
    EXPECT_DOUBLE_EQ(sph.interval, std::hypot(sph.first.half_width, sph.second.half_width));
    EXPECT_TRUE(sph.beyond_interval());
    EXPECT_FALSE(fvm.beyond_interval());
    EXPECT_NE(text_of(t).find("beyond the interval"), std::string::npos) << text_of(t);
    const auto json = nlohmann::json::parse(json_of(t));
    EXPECT_EQ(json["quantities"].size(), t.headline.size());
}

TEST(TwoReports, OfOneReportNothingDiffers) {
    const ScratchFolder folder;
    const ReportFacts a = report_of(folder, "a.json", {run("sph", 2800), run("fvm", 2600)});
    const TwoReports t = compare_reports(a, a);
    ASSERT_GE(t.headline.size(), 4u);
    for (const ReportChange& c : t.headline) EXPECT_FALSE(std::abs(c.difference) > 0) << c.quantity;
    EXPECT_TRUE(t.otherwise.empty());
    EXPECT_TRUE(t.in_one_of_them.empty());
    EXPECT_NE(text_of(t).find("Nothing differs in what was solved."), std::string::npos);
}

TEST(TwoReports, WhatDiffersIsSaidOnceForAllRunsAndProvenanceApart) {
    const ScratchFolder folder;
    std::vector<RunRecord> first{run("sph", 2800), run("fvm", 2600)}, second = first;
    for (RunRecord& r : second) {
        r.numbers["draft"] = 0.25;
        r.numbers["predicted_steps"] = 1e5;  // follows from the others
        r.attributes["code_version"] = "0.2.0";
    }
    second[0].numbers["near_hull"] = 0.02;
    const TwoReports t = compare_reports(report_of(folder, "a.json", first), report_of(folder, "b.json", second));
    ASSERT_EQ(t.otherwise.size(), 3u) << text_of(t);
    EXPECT_EQ(t.otherwise[0].name, "draft");
    EXPECT_EQ(t.otherwise[0].run, "all");
    EXPECT_EQ(t.otherwise[0].first, "0.2");
    EXPECT_EQ(t.otherwise[0].second, "0.25");
    EXPECT_EQ(t.otherwise[1].name, "near_hull");
    EXPECT_EQ(t.otherwise[1].run, "sph");
    EXPECT_FALSE(t.otherwise[1].provenance);
    EXPECT_EQ(t.otherwise[2].name, "code_version");
    EXPECT_TRUE(t.otherwise[2].provenance);
}

TEST(TwoReports, WhatOnlyOneHasIsListedAndNothingInCommonIsRefused) {
    const ScratchFolder folder;
    RunRecord without = run("sph", 2800);
    without.tables.erase("forces");
    const ReportFacts both = report_of(folder, "a.json", {run("sph", 2800), run("fvm", 2600)}),
                      sph = report_of(folder, "b.json", {without}),
                      fvm = report_of(folder, "c.json", {run("fvm", 2600)});
    const TwoReports t = compare_reports(both, sph);
    EXPECT_EQ(std::ranges::count(t.in_one_of_them, "run fvm: first report only"), 1);
    for (const ReportChange& c : t.headline)
        if (c.quantity == "lift") {
            EXPECT_TRUE(std::isnan(c.difference));
            EXPECT_EQ(c.why_not, "no value in the second");
        }
    try {
        compare_reports(sph, fvm);
        FAIL();
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("b.json has the runs sph, "), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("no run is in both"), std::string::npos) << e.what();
    }
}

TEST(TwoReports, QuantitiesOfAnotherMeaningAreNotCompared) {
    ReportFacts a{"a.json", {{"sph", {}, {}}}, {{"drag", "Drag", "N", "known to half a voxel (0.004 m)", {{250, 1}}}}};
    ReportFacts b = a;
    b.quantities[0].values[0].value = 240;
    b.quantities[0].definition = "known to half a voxel (0.002 m)";
    EXPECT_EQ(change(compare_reports(a, b), "drag", "sph").difference, -10) << "its size is no other meaning";
    b.quantities[0].definition = "of the pressure alone";
    EXPECT_FALSE(change(compare_reports(a, b), "drag", "sph").why_not.empty());
    b = a;
    b.quantities[0].unit = "N/m";
    EXPECT_EQ(change(compare_reports(a, b), "drag", "sph").why_not, "N against N/m");
    EXPECT_TRUE(std::isnan(change(compare_reports(a, b), "drag", "sph").difference));
}

TEST(TwoReports, WhatIsNoReportIsRefusedByName) {
    const ScratchFolder folder;
    const std::string quantity =
        R"({"name":"lift","label":"Lift","unit":"N","definition":"","values":[1],"intervals":[2]})";
    for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
             {"", "parse error"},
             {"{}", "sources"},
             {"[1, 2]", "at()"},
             {R"({"sources":[],"quantities":[]})", "without a run"},
             {R"({"sources":[{"name":1,"numbers":{},"attributes":{}}],"quantities":[]})", "must be string"},
             {R"({"sources":[],"quantities":[)" + quantity + "]}", "has 1 values, expected 0"}}) {
        write_text_atomically(folder / "x.json", text);
        try {
            read_report(folder / "x.json");
            ADD_FAILURE() << text;
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find("x.json: "), std::string::npos) << e.what();
            EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what();
        }
    }
    EXPECT_THROW(read_report(folder / "absent.json"), InputError);
}

}  // namespace two_reports_test
}  // namespace tw
