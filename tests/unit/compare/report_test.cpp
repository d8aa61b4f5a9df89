#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "compare/compare.h"
#include "compare/report/egl_window.h"
#include "compare/report/first_screen.h"
#include "compare/report/numbers.h"
#include "compare/report/report_files.h"
#include "compare/report/sentences.h"
#include "record/measured_value.h"
#include "tests/unit/compare/synthetic_pair.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace report_test {

const Comparison& pair() {
    static const Comparison c = compare_records(
        {synthetic_run({.step = 4e-3}),
         synthetic_run(
             {.method = "fvm", .lift = 2722, .moment = 870, .noise = 15, .step = 4e-3, .splash = 0.3, .seed = 2})});
    return c;
}
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Report, IsOneFileThatNeedsNothingElse) {
    const ScratchFolder folder;
    const ReportFiles files = write_report(pair(), folder.path());
    const std::string page = read_text(files.html);
    for (const char* outside : {"<script src", "http://", "https://", "src=\"figures", "<link", "@import"}) {
        std::string rest = page;
        // Name spaces are identifiers, not addresses that are fetched.
        for (const std::string space : {"http://www.w3.org/2000/svg", "http://www.w3.org/1999/xhtml"})
            for (std::size_t at; (at = rest.find(space)) != std::string::npos;) rest.erase(at, space.size());
        EXPECT_FALSE(has(rest, outside)) << outside;
    }
    for (const char* part : {"<h1>Planing prism, synthetic</h1>", "class=\"verdict\"", "Difference by quantity", "Lift",
                             "Savitsky 1964", "Soundness of the runs", "Effects solved and left out", "What it cost",
                             "How to reproduce it", "Splash height (connected sheet)", "multiplied by 2"})
        EXPECT_TRUE(has(page, part)) << part;
    EXPECT_LT(page.find("class=\"verdict\""), page.find("<table"));  // the verdict comes first
    EXPECT_TRUE(std::filesystem::exists(folder / "series.csv"));
    EXPECT_TRUE(std::filesystem::exists(folder / "figures/force_lift.svg"));
}

TEST(Report, PicturesAreDrawnWithoutADisplayOrTheReasonIsSaid) {
    const ScratchFolder folder;
    const std::string page = read_text(write_report(pair(), folder.path()).html);
    bool can_draw = true;
    try {
        EglWindow probe(16, 16);
    } catch (const std::exception&) { can_draw = false; }
    if (!can_draw) {
        EXPECT_TRUE(has(page, "no pictures"));
        return;
    }
    for (const char* name :
         {"figures/free_surface_0.png", "figures/free_surface_1.png", "figures/hull_pressure_0.png"}) {
        ASSERT_TRUE(std::filesystem::exists(folder / name)) << name;
        EXPECT_EQ(read_text(folder / name).substr(1, 3), "PNG");
    }
    // Different water gives a different picture; the same water gives the same bytes.
    EXPECT_NE(read_text(folder / "figures/free_surface_0.png"), read_text(folder / "figures/free_surface_1.png"));
    const Comparison twice = compare_records({pair().sources[0], pair().sources[0]});
    const ScratchFolder again;
    write_report(twice, again.path());
    EXPECT_EQ(read_text(again / "figures/free_surface_0.png"), read_text(again / "figures/free_surface_1.png"));
}

TEST(Report, JsonKeepsItsKeys) {
    const auto j = nlohmann::json::parse(comparison_json(pair()));
    ASSERT_TRUE(j.contains("quantities") && j.contains("gates") && j.contains("cost"));
    const auto& lift = j["quantities"][0];
    EXPECT_EQ(lift["name"], "lift");
    EXPECT_EQ(lift["unit"], "N");
    EXPECT_EQ(lift["values"].size(), 2u);
    EXPECT_EQ(lift["intervals"].size(), 2u);
    for (const char* key : {"difference", "interval", "verdict"}) EXPECT_TRUE(lift.contains(key)) << key;
    EXPECT_NEAR(lift["difference"].get<double>(), lift["values"][1].get<double>() - lift["values"][0].get<double>(),
                1e-9);
    EXPECT_EQ(j["cost"].size(), 2u);
    EXPECT_TRUE(j["cost"][0].contains("wall"));
}

TEST(Report, UnknownNumbersAreNullInJsonAndEmptyInCsv) {
    RunRecord a = pair().sources[0], b = pair().sources[1];
    b.tables.erase("forces");
    const Comparison c = compare_records({a, b});
    const auto j = nlohmann::json::parse(comparison_json(c));
    EXPECT_TRUE(j["quantities"][0]["values"][1].is_null());
    EXPECT_TRUE(j["quantities"][0]["difference"].is_null());
    const std::string csv = quantities_csv(c);
    EXPECT_FALSE(has(csv, "nan"));
    EXPECT_TRUE(has(csv, "not_comparable"));
}

TEST(Report, CsvHasOneRowPerQuantityAndQuotesWhatNeedsIt) {
    const std::string csv = quantities_csv(pair());
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), pair().quantities.size() + 1);
    EXPECT_TRUE(csv.starts_with("name,unit,sph,sph interval,fvm,fvm interval,difference,interval,per_cent,verdict"));
    EXPECT_TRUE(has(series_csv(pair()), "sph,splash,sheet_height,m,"));
}

TEST(Report, SummaryNamesTheVerdictOfEachQuantity) {
    const std::string text = summary_text(pair());
    EXPECT_TRUE(has(text, "Lift")) << text;
    EXPECT_TRUE(has(text, "Lift: apart by 2.")) << text;
    EXPECT_TRUE(has(text, " % statistical scatter of the means; discretisation error not estimated.")) << text;
    EXPECT_TRUE(has(text, "discretisation error not estimated.")) << text;
    EXPECT_TRUE(has(text, "Savitsky 1964"));
}

TEST(Report, NothingOfOneSizeIsCalledAgreementOrARealDifference) {
    const ScratchFolder folder;
    const std::string page = read_text(write_report(pair(), folder.path()).html), text = summary_text(pair()),
                      csv = quantities_csv(pair());
    const auto j = nlohmann::json::parse(comparison_json(pair()));
    for (const auto& q : j["quantities"])
        for (const char* word : {"agree", "differ"}) EXPECT_NE(q["verdict"], word) << q["name"];
    EXPECT_EQ(j["quantities"][0]["verdict"], "discretisation error not estimated");
    for (const std::string& out : {page, text, csv}) {
        for (const char* word : {"real difference", ">differ<", ">agree<", " differs", ",agree,", ",differ,"})
            EXPECT_FALSE(has(out, word)) << word;
        EXPECT_TRUE(has(out, "discretisation error not estimated"));
    }
    EXPECT_TRUE(has(text, "twinwake ladder"));
}

TEST(Report, TerminalAndPagePrintTheSameFacts) {
    const ScratchFolder folder;
    RunRecord a = pair().sources[0], b = pair().sources[1];
    for (RunRecord* r : {&a, &b}) {
        Table& t = r->table("pressure");
        for (double time = 0; time < 2; time += 0.01) {
            t.time.push_back(time);
            t.column("bow", "Pa").values.push_back(1234.5 + (r == &a ? 0 : 20));
        }
    }
    const Comparison c = compare_records({a, b});
    const std::string page = read_text(write_report(c, folder.path()).html), text = summary_text(c);
    for (const Quantity& q : c.quantities) {  // probes and what stands beside are among them
        EXPECT_TRUE(has(text, q.label)) << q.label;
        EXPECT_TRUE(has(page, q.label)) << q.label;
        for (const MeanValue& m : q.values)
            if (m.known) {
                EXPECT_TRUE(has(text, mean_text(m))) << q.label;
                EXPECT_TRUE(has(page, mean_text(m))) << q.label;
            }
    }
    EXPECT_TRUE(c.find("pressure_mean:bow"));
}

TEST(Report, WhatCanBeTrustedBeginsWithAReferenceThatBothMethodsMiss) {
    std::vector<RunRecord> records{synthetic_run({.lift = 3258}), synthetic_run({.method = "fvm", .lift = 3131})};
    records[0].attributes["box_walls"] =
        "the walls of the box (1.5 m to the side) are expected to raise the lift by 12 %; 3 m would leave 2 %";
    const Comparison c = compare_records(records);
    const std::vector<Doubt> doubts = doubts_of(c);
    ASSERT_FALSE(doubts.empty());
    EXPECT_TRUE(doubts.front().grave);
    for (const char* part : {"Both methods lie outside Savitsky 1964: ", "lift 35 to 40 % above",
                             "measured lifts lie 7 to 19 % above this formula", "raise the lift by 12 %",
                             "at the wetted lengths that the runs find it gives 2420 and 2420 N of lift"})
        EXPECT_TRUE(has(doubts.front().text, part)) << part << ": " << doubts.front().text;
    EXPECT_FALSE(has(doubts.front().text, "would leave 2 %"));
    // A value whose interval holds the formula misses nothing.
    for (const Doubt& d :
         doubts_of(compare_records({synthetic_run({.lift = 2400}), synthetic_run({.method = "fvm", .lift = 3131})})))
        EXPECT_FALSE(has(d.text, "Both methods lie outside Savitsky 1964: lift")) << d.text;
}

TEST(Report, WhatToDoNextKeepsTheStudysOwnSizeAndSaysItsTime) {
    std::vector<RunRecord> records{synthetic_run({}), synthetic_run({.method = "fvm", .lift = 2600})};
    for (RunRecord& r : records) {
        r.attributes["command"] = "run\nprism.toml\n--budget\n4min\n--speed\n8 m/s";
        r.numbers["size_scale"] = 1.54;
        r.phases = {{"solving", 120, 200}};
    }
    Comparison c = compare_records(records);
    const NextStep coarser_members = next_steps(c).front();
    EXPECT_TRUE(has(coarser_members.what, "at this study's 40 mm")) << coarser_members.what;
    EXPECT_EQ(coarser_members.command, "twinwake run prism.toml --scale 1.54 --speed '8 m/s'");
    c.discretisation_from = "runs of 3 sizes";
    for (Quantity& q : c.quantities) q.verdict = Verdict::agree;
    for (Quantity& q : c.quantities)
        if (q.name == "lift") q.verdict = Verdict::undecided, q.seconds_to_target = 24 * 60;
    const std::vector<NextStep> steps = next_steps(c);
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_TRUE(has(steps[0].what, "Refine from 40 mm to 28.3 mm at the hull, about 21 min of computing here"))
        << steps[0].what;
    EXPECT_TRUE(has(steps[0].command, "--scale 1.089 --speed '8 m/s' --out")) << steps[0].command;
    EXPECT_TRUE(has(steps[1].what, "24 min of computing")) << steps[1].what;
    EXPECT_TRUE(has(steps[1].command, "prism.toml --speed '8 m/s' --budget 24min --out")) << steps[1].command;
}

TEST(Report, NoCommandIsOfferedForRunsThatNobodyWaitsForAndTheStudysOwnSizeComesFirst) {
    std::vector<RunRecord> records{synthetic_run({}), synthetic_run({.method = "fvm"})};
    for (RunRecord& r : records) r.attributes["command"] = "run\nprism.toml", r.phases = {{"solving", 100, 100}};
    Comparison c = compare_records(records);
    c.discretisation_from = "runs of 3 sizes";
    c.study_seconds = 310;
    for (Quantity& q : c.quantities) {
        q.verdict = Verdict::agree;
        if (q.name == "lift") q.verdict = Verdict::undecided, q.seconds_to_target = 3.9 * 86400;
        if (q.name == "trim_moment") q.verdict = Verdict::undecided, q.seconds_to_target = 600;
        if (q.name == "splash_raised") q.values[0].known = false, q.values[0].seconds_needed = 2;
    }
    const std::vector<NextStep> steps = next_steps(c);
    ASSERT_EQ(steps.size(), 3u);
    EXPECT_EQ(steps[0].what,
              "Simulate longer at 40 mm: the means need about 2 s more, about 11 min of computing here.");
    EXPECT_EQ(steps[1].what,
              "Refine from 40 mm to 28.3 mm at the hull, about 18 min of computing here: that would bring trim moment "
              "to ±5 %.");
    EXPECT_EQ(steps[2].what, "To bring lift to ±5 % would take 3.9 days of computing, by the slopes of this study.");
    EXPECT_EQ(steps[2].command, "");
    EXPECT_EQ(longest_offer(300), 6000);
    EXPECT_EQ(longest_offer(10), always_offered);
    EXPECT_EQ(longest_offer(1e7), longest_runs);
}

TEST(Report, FirstScreenSaysHowFarTheValuesAreFromMeasurementAndFormula) {
    std::vector<RunRecord> records{synthetic_run({.lift = 3258}), synthetic_run({.method = "fvm", .lift = 2600})};
    for (RunRecord& r : records) note_measured(r, {"lift", "N", "Tank 3", 2800, 30});
    const Comparison c = compare_records(records);
    const std::string page = first_screen(c, {});
    const auto from = [&](std::size_t source, double reference) {
        return per_cent_text(100 * (c.find("lift")->values[source].value / reference - 1));
    };
    EXPECT_TRUE(has(page, "Against the measurement: SPH " + from(0, 2800) + ", interFoam " + from(1, 2800) +
                              "; against Savitsky 1964: SPH "))
        << page.substr(page.find("Against"), 200);
    EXPECT_TRUE(has(page, ">measured (Tank 3)<"));
    EXPECT_TRUE(has(page, "8 m/s, Froude number 1.28 (Cv 2.55)")) << page.substr(0, 600);
    EXPECT_LT(page.find(">Savitsky 1964<"), page.find(">measured (Tank 3)<")) << "from left to right";
}

TEST(Report, AReasonThatBothMethodsShareIsSaidOnce) {
    std::vector<RunRecord> records{synthetic_run({.duration = 0.4}), synthetic_run({.method = "fvm", .duration = 0.4})};
    const Comparison c = compare_records(records);
    const Quantity& lift = *c.find("lift");
    ASSERT_FALSE(lift.values[0].known || lift.values[1].known);
    ASSERT_EQ(lift.values[0].why_not, lift.values[1].why_not);
    EXPECT_EQ(lift.remark, "SPH and interFoam: " + lift.values[0].why_not);
    EXPECT_TRUE(has(first_screen(c, {}), "<b>Lift: <span class=\"said undecided\">no mean yet</span>.</b> SPH and "))
        << first_screen(c, {}).substr(0, 3000);
}

TEST(Report, WhatWasTunedIsTheLastDoubt) {
    std::vector<RunRecord> records{synthetic_run({}), synthetic_run({.method = "fvm"})};
    records[0].attributes["calibrated"] = "the wall, on a prism";
    records[0].attributes["box_walls"] = "the walls of the box raise the lift by 12 %";
    const std::vector<Doubt> doubts = doubts_of(compare_records(records));
    ASSERT_GE(doubts.size(), 3u);
    EXPECT_TRUE(has(doubts.back().text, "SPH was tuned: the wall, on a prism")) << doubts.back().text;
    EXPECT_TRUE(has(doubts[doubts.size() - 2].text, "Values are those of this box")) << doubts.back().text;
}

TEST(Report, OneRunAloneAndATankWithoutAHullHaveAReportToo) {
    const ScratchFolder folder;
    RunRecord tank = synthetic_run({.step = 4e-3});
    tank.hull = {};
    tank.hull_pressure.clear();
    tank.hull_wet.clear();
    tank.numbers.erase("speed");
    tank.attributes["motion"] = "none";
    tank.tables.erase("forces");
    tank.table("height").time = {0, 1};
    tank.table("height").column("H1", "m").values = {0.1, 0.2};
    const std::string page = read_text(write_report(compare_records({tank}), folder.path()).html);
    EXPECT_TRUE(has(page, "Water height at H1"));
    EXPECT_TRUE(has(page, "largest of the run"));
    RunRecord with_solids = synthetic_run({.step = 4e-3});
    with_solids.attributes["motion"] = "none";
    with_solids.effects = {{"viscosity", false, false, "r", "drag: 1 %; lift: 2 %; splash: none", 0}};
    const std::string forces = read_text(write_report(compare_records({with_solids}), folder.path()).html);
    EXPECT_TRUE(has(forces, "aria-label=\"Force up"));
    EXPECT_TRUE(has(forces, "force along x [N]"));
    EXPECT_FALSE(has(forces, "aria-label=\"Lift"));
    EXPECT_TRUE(has(forces, "force along x: 1 %; force up: 2 %; splash: none"));
}

}  // namespace report_test
}  // namespace tw
