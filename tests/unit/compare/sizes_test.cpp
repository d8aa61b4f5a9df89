// What runs of several sizes make of a comparison: error bars, verdicts, and choices that are no evidence.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/grid_study/grid_study_report.h"
#include "compare/grid_study/judge_by_sizes.h"
#include "compare/metrics/box_walls.h"
#include "compare/report/report_files.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace sizes_test {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// One run of a family whose lift is limit + error (h / 0.04)^2, with steps as its spacing asks for them.
RunRecord member(const std::string& method, double limit, double error, double h) {
    SyntheticRun run;
    run.method = method, run.lift = limit + error * std::pow(h / 0.04, 2), run.noise = 2, run.frames = false;
    run.seed = static_cast<unsigned>(1000 * h) + (method == "sph" ? 1 : 2);
    RunRecord r = synthetic_run(run);
    r.numbers["near_hull"] = h;
    const double box[] = {-3, 4.5, -2, 2, -1.6, 2};
    for (int k = 0; k < 6; ++k) r.numbers[std::string("domain_") + "xyz"[k / 2] + (k % 2 ? "_max" : "_min")] = box[k];
    r.steps = 1000 * 0.04 / h;
    r.phases = {{"solving", 100 * std::pow(0.04 / h, 4), 0}};
    return r;
}

constexpr double spacings[] = {0.04, 0.0565685, 0.08};

std::vector<GridStudyRun> runs_of(double sph_error, double fvm_limit, double fvm_error) {
    std::vector<GridStudyRun> runs;
    for (const double h : spacings) {
        runs.push_back(grid_study_run(member("sph", 2800, sph_error, h)));
        runs.push_back(grid_study_run(member("fvm", fvm_limit, fvm_error, h)));
    }
    return runs;
}

Comparison finest(double sph_error, double fvm_limit, double fvm_error) {
    return compare_records({member("sph", 2800, sph_error, 0.04), member("fvm", fvm_limit, fvm_error, 0.04)});
}

TEST(Sizes, ThreeSizesPutTheDiscretisationErrorIntoTheVerdictEverywhere) {
    Comparison c = finest(100, 2800, 10);
    const Quantity before = *c.find("lift");
    ASSERT_EQ(before.verdict, Verdict::not_estimated);
    const GridStudy grid_study = build_grid_study(runs_of(100, 2800, 10));
    judge_by_sizes(c, grid_study);
    const Quantity& lift = *c.find("lift");
    // 2900 and 2810 N: 90 N apart, and 100 N of it is the error of the coarser family
    EXPECT_GT(before.interval, 0);
    EXPECT_LT(before.interval, 10);
    EXPECT_GT(lift.interval, 90);
    EXPECT_TRUE(lift.verdict == Verdict::agree || lift.verdict == Verdict::undecided) << to_string(lift.verdict);
    EXPECT_GT(lift.values[0].discretisation, 80);
    EXPECT_NEAR(lift.values[0].uncertainty, std::hypot(lift.values[0].half_width, lift.values[0].discretisation), 1e-6);
    EXPECT_EQ(c.discretisation_from, "runs of 3 sizes");
    EXPECT_TRUE(has(lift.sentence, "Lift: SPH 3.")) << lift.sentence;
    EXPECT_TRUE(has(lift.sentence, "% above interFoam, discretisation error ±")) << lift.sentence;

    const std::string text = summary_text(c);
    EXPECT_LT(text.find(lift.sentence), text.find("| Quantity"));  // first thing on the console
    const auto j = nlohmann::json::parse(comparison_json(c));
    EXPECT_EQ(j["quantities"][0]["sentence"], lift.sentence);
    EXPECT_EQ(j["quantities"][0]["verdict"], to_string(lift.verdict));
    EXPECT_DOUBLE_EQ(j["quantities"][0]["intervals"][0], lift.values[0].uncertainty);
    EXPECT_DOUBLE_EQ(j["quantities"][0]["sources"][0]["scatter"], lift.values[0].half_width);
    EXPECT_TRUE(has(quantities_csv(c), lift.sentence.substr(0, 20)));
    for (const std::string& out : {text, comparison_json(c)})
        EXPECT_FALSE(has(out, "Lift: apart by")) << "the verdict of one size is gone";
}

TEST(Sizes, TwoLimitsDiffer) {
    Comparison c = finest(10, 3200, 10);
    judge_by_sizes(c, build_grid_study(runs_of(10, 3200, 10)));
    EXPECT_EQ(c.find("lift")->verdict, Verdict::differ);
    EXPECT_TRUE(has(c.find("lift")->sentence, "SPH 13 % below interFoam")) << c.find("lift")->sentence;
    EXPECT_TRUE(has(c.find("lift")->sentence, ": they differ.")) << c.find("lift")->sentence;
}

TEST(Sizes, ValuesWithoutAHalfWidthThatJumpHaveAnIntervalOfTheirJumps) {
    std::vector<GridStudyRun> runs = runs_of(100, 2800, 10);
    const double peak[] = {23411, 42600, 24849};  // a peak has no scatter of its own
    int k = 0;
    for (GridStudyRun& r : runs)
        for (Quantity& q : r.quantities)
            if (q.name == "lift" && r.method == "sph") q.values[0].value = peak[k++], q.values[0].half_width = 0;
    const GridStudy grid_study = build_grid_study(runs);
    ASSERT_EQ(grid_study.quantities[0].name, "lift");
    EXPECT_GT(grid_study.quantities[0].values[0].uncertainty, 19000);
    EXPECT_EQ(grid_study.quantities[0].verdict, Verdict::no_answer);
}

TEST(Sizes, OfThreeSourcesEachPairHasTheGridStudiesVerdictAndWhatIsInNoGridStudyHasNone) {
    RunRecord tank = member("towing tank", 2805, 0, 0.04);
    tank.numbers.erase("near_hull");
    const GridStudy grid_study = build_grid_study(runs_of(10, 3200, 10));
    // in another order than the grid study's sides: the sign follows the sources
    Comparison c = compare_records({tank, member("fvm", 3200, 10, 0.04), member("sph", 2800, 10, 0.04)});
    const Quantity before = *c.find("lift");
    judge_by_sizes(c, grid_study);
    const Quantity& lift = *c.find("lift");
    ASSERT_EQ(lift.pairs.size(), 3u);
    EXPECT_EQ(lift.pairs[2].verdict, Verdict::differ);
    EXPECT_DOUBLE_EQ(lift.pairs[2].difference, -grid_study.quantities[0].difference);
    EXPECT_TRUE(has(lift.pairs[2].sentence, "they differ")) << lift.pairs[2].sentence;
    for (const std::size_t k : {0u, 1u}) {
        EXPECT_EQ(lift.pairs[k].verdict, Verdict::not_estimated);
        EXPECT_EQ(lift.pairs[k].difference, before.pairs[k].difference);
    }
    EXPECT_TRUE(has(summary_text(c), lift.pairs[2].sentence));
}

TEST(Sizes, AMethodWithoutTwinsKeepsWhatOneSizeSays) {
    std::vector<GridStudyRun> runs = runs_of(100, 2800, 10);
    std::erase_if(runs, [](const GridStudyRun& r) { return r.method == "fvm" && r.spacing > 0.05; });
    GridStudy grid_study = build_grid_study(runs);
    grid_study.left_out = {"interFoam at 0.08 m: failed: snappyHexMesh"};
    Comparison c = finest(100, 2800, 10);
    judge_by_sizes(c, grid_study);
    EXPECT_EQ(c.find("lift")->verdict, Verdict::not_estimated);
    EXPECT_TRUE(std::isfinite(c.find("lift")->values[0].uncertainty));
    EXPECT_FALSE(std::isfinite(c.find("lift")->values[1].uncertainty));
    EXPECT_TRUE(has(summary_text(c), "! interFoam at 0.08 m: failed: snappyHexMesh"));
}

TEST(Sizes, OneMethodHasItsErrorBarAndNoVerdict) {
    std::vector<GridStudyRun> runs = runs_of(100, 2800, 10);
    std::erase_if(runs, [](const GridStudyRun& r) { return r.method == "fvm"; });
    Comparison c = compare_records({member("sph", 2800, 100, 0.04)});
    judge_by_sizes(c, build_grid_study(runs));
    EXPECT_GT(c.find("lift")->values[0].uncertainty, 80);
    EXPECT_TRUE(has(c.find("lift")->sentence, "Lift: 2900 ± ")) << c.find("lift")->sentence;
    EXPECT_TRUE(has(c.find("lift")->sentence, "N by SPH, discretisation error ±")) << c.find("lift")->sentence;
    EXPECT_EQ(c.find("lift")->verdict, Verdict::not_comparable);
}

TEST(Sizes, ARunThatFailedIsNotJudgedByItsTwins) {
    Comparison c = finest(100, 2800, 10);
    c.sources[0].state = "failed";
    judge_by_sizes(c, build_grid_study(runs_of(100, 2800, 10)));
    EXPECT_EQ(c.find("lift")->verdict, Verdict::not_estimated);
}

/// The coarsest run of a method with something changed.
template <class Change>
GridStudyVariation varied(const std::string& method, const std::string& name, double steps, bool box, Change change) {
    RunRecord r = member(method, 2800, method == "sph" ? 100 : 10, 0.08);
    change(r);
    return {name, 2, grid_study_run(r), steps, box};
}

double lift_mean(const GridStudyRun& run) {
    for (const Quantity& q : run.quantities)
        if (q.name == "lift") return q.values[0].value;
    return 0;
}

TEST(Sizes, TheBoxCountsInBothMethodsAndNotInTheirDifference) {
    const std::vector<GridStudyRun> runs = runs_of(100, 2800, 10);
    GridStudyVariation wide = varied("fvm", "box x 1.5", 1, true, [](RunRecord& r) {
        r.numbers["domain_y_min"] = -3, r.numbers["domain_y_max"] = 3, r.numbers["domain_z_min"] = -2.4;
    });
    const double base = lift_mean(wide.run);
    for (Quantity& q : wide.run.quantities)
        if (q.name == "lift") q.values[0].value *= 0.95;  // the walls are worth 5 % and more
    const GridStudy without = build_grid_study(runs), grid_study = build_grid_study(runs, {wide});
    const GridStudyQuantity &a = without.quantities[0], &b = grid_study.quantities[0];
    ASSERT_EQ(b.name, "lift");
    const double share = 0.05 / (1 - 1 / 2.25);  // the cross section is 2.25 times as large
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(b.values[k].box, share * b.values[k].levels.front().value, 1e-3 * base) << k;
        EXPECT_NEAR(b.values[k].uncertainty, std::hypot(a.values[k].uncertainty, b.values[k].box), 1e-6) << k;
    }
    EXPECT_DOUBLE_EQ(a.interval, b.interval);
    EXPECT_EQ(a.verdict, b.verdict);
    const std::string text = grid_study_text(grid_study), page = grid_study_html(grid_study);
    for (const std::string& out : {text, page}) EXPECT_TRUE(has(out, "8.9 %") || has(out, "9 %")) << out;
    EXPECT_TRUE(has(page, "inverse of the water"));
}

// What a run in a wider box measures stands in place of what was expected.
TEST(Sizes, WhatAWiderBoxMeasuresIsSaidInPlaceOfWhatWasExpected) {
    const std::string expected = "the walls of the box (1.5 m to the side) are expected to raise the lift by 12 %";
    const auto judged = [&](const std::string& walls, double change, double wider = 1.5) {
        GridStudyVariation wide = varied("fvm", "box x 1.5", 1, true, [&](RunRecord& r) {
            r.numbers["domain_y_min"] = -2 * wider, r.numbers["domain_y_max"] = 2 * wider;
            r.numbers["domain_z_min"] = -1.6 * wider;
        });
        for (Quantity& q : wide.run.quantities)
            if (q.name == "lift") q.values[0].value *= 1 - change;
        std::vector<RunRecord> records{member("sph", 2800, 100, spacings[0]), member("fvm", 2800, 10, spacings[0])};
        if (!walls.empty()) records[0].attributes["box_walls"] = walls;
        Comparison c = compare_records(std::move(records));
        judge_by_sizes(c, build_grid_study(runs_of(100, 2800, 10), {wide}));
        return c;
    };
    const auto count = [](const Comparison& c, const std::string& part) {
        return std::ranges::count_if(all_banners(c), [&](const std::string& b) { return has(b, part); });
    };
    const Comparison both = judged(expected, 0.05);
    EXPECT_EQ(count(both, "expected to raise"), 0);
    EXPECT_EQ(count(both, "the walls of the box change lift by +9.1 %"), 1) << both.walls;
    EXPECT_EQ(count(both, "measured by interFoam at"), 1) << both.walls;
    EXPECT_EQ(count(judged("", -0.05), "change lift by -9.1 %"), 1) << "walls that nobody expected";
    EXPECT_EQ(count(judged("", 0.005), "walls of the box"), 0) << "0.9 % is not worth a line";
    EXPECT_EQ(count(judged(expected, 0.005), "change lift by +0.9 %"), 1);
    EXPECT_EQ(count(judged(expected, 0.05, 1.05), "expected to raise"), 1) << "a box that is hardly wider says nothing";
}

TEST(Sizes, AChoiceThatDidNotChangeTheStepsIsRefusedAsEvidence) {
    const std::vector<GridStudyRun> runs = runs_of(100, 2800, 10);
    GridStudyVariation half =
        varied("fvm", "half the Courant number", 2, false, [](RunRecord& r) { r.steps = 1.17 * r.steps; });
    for (Quantity& q : half.run.quantities)
        if (q.name == "lift") q.values[0].value += 50;
    const GridStudy refused = build_grid_study(runs, {half});
    const GridStudyValue& fvm = refused.quantities[0].values[1];
    ASSERT_EQ(fvm.sensitivities.size(), 1u);
    EXPECT_FALSE(std::isfinite(fvm.sensitivities[0].uncertainty));
    EXPECT_EQ(fvm.choices, 0);
    ASSERT_EQ(refused.notes.size(), 1u);
    EXPECT_TRUE(has(refused.notes[0], "half the Courant number: no evidence")) << refused.notes[0];
    EXPECT_TRUE(has(refused.notes[0], "1.17 times as many where 2 times were meant")) << refused.notes[0];
    EXPECT_TRUE(has(grid_study_text(refused), "no evidence"));

    half.run.steps *= 1.5 / 1.17;  // half way: three times the change is left
    const GridStudy part = build_grid_study(runs, {half});
    EXPECT_NEAR(part.quantities[0].values[1].sensitivities[0].uncertainty, 3 * 50, 1e-6);
    half.run.steps *= 2 / 1.5;
    const GridStudy full = build_grid_study(runs, {half});
    EXPECT_NEAR(full.quantities[0].values[1].sensitivities[0].uncertainty, 2 * 50, 1e-6);
    EXPECT_TRUE(full.notes.empty());
}

TEST(Sizes, StepsThatDoNotFollowTheSpacingAreSaid) {
    std::vector<GridStudyRun> runs = runs_of(100, 2800, 10);
    EXPECT_TRUE(build_grid_study(runs).notes.empty());
    const double counted[] = {1275, 1260, 1259};
    int k = 0;
    for (GridStudyRun& r : runs)
        if (r.method == "fvm") r.steps = counted[k++];
    const GridStudy grid_study = build_grid_study(runs);
    ASSERT_EQ(grid_study.notes.size(), 1u);
    EXPECT_TRUE(has(grid_study.notes[0], "interFoam: 1275, 1260, 1259 time steps at 3 sizes")) << grid_study.notes[0];
}

TEST(Sizes, RunsWithOtherNumbersOfSizesOfParticlesAreSaidNotToBeSimilar) {
    std::vector<GridStudyRun> runs = runs_of(100, 2800, 10);
    for (GridStudyRun& r : runs) r.element_sizes = 2;
    EXPECT_TRUE(build_grid_study(runs).notes.empty());
    std::ranges::max_element(runs, {}, [](const GridStudyRun& r) { return r.spacing; })->element_sizes = 1;
    const GridStudy grid_study = build_grid_study(runs);
    ASSERT_EQ(grid_study.notes.size(), 1u);
    EXPECT_TRUE(has(grid_study.notes[0], "the runs are not similar")) << grid_study.notes[0];
    RunRecord record = member("sph", 2800, 10, spacings[0]);
    record.numbers["levels"] = 3;
    EXPECT_EQ(grid_study_run(record).element_sizes, 3);
}

TEST(Sizes, AWiderBoxIsFoundAmongRecords) {
    std::vector<GridStudyRun> runs;
    for (const double h : spacings) {
        RunRecord r = member("fvm", 2800, 10, h);
        r.attributes["family_hash"] = "family";
        runs.push_back(grid_study_run(r));
    }
    RunRecord wide = member("fvm", 2800, 10, 0.08);
    wide.attributes["family_hash"] = "wide";
    wide.numbers["domain_y_min"] = -3, wide.numbers["domain_y_max"] = 3;
    runs.push_back(grid_study_run(wide));
    const std::vector<GridStudyVariation> found = take_variations(runs);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].box);
    EXPECT_EQ(found[0].name, "box x 1.5");
    EXPECT_EQ(runs.size(), 3u);
}

TEST(Sizes, AnotherSceneTakesTheRelativeErrorAndSaysFromWhere) {
    const RelativeErrors errors = relative_errors(build_grid_study(runs_of(100, 2800, 10)), "prism, 6 m/s");
    Comparison c = finest(400, 2800, 40);  // 3200 and 2840 N: alone they look apart by 12 %
    judge_by_errors_of(c, errors);
    const Quantity& lift = *c.find("lift");
    const double share = errors.of.at({"lift", "sph"}).discretisation;
    EXPECT_NEAR(lift.values[0].discretisation, share * lift.size, 1e-9);
    EXPECT_GT(share, 0.02);
    EXPECT_NE(lift.verdict, Verdict::not_estimated);
    EXPECT_TRUE(has(lift.sentence, "discretisation error as in prism, 6 m/s ±")) << lift.sentence;
    EXPECT_TRUE(has(lift.remark, "discretisation error taken from prism, 6 m/s")) << lift.remark;
    EXPECT_TRUE(has(summary_text(c), "the coarser runs of prism, 6 m/s"));

    RelativeErrors none = errors;
    none.of.at({"lift", "sph"}).discretisation = std::nan("");
    none.of.at({"lift", "sph"}).why_not = "the changes do not decrease";
    Comparison d = finest(400, 2800, 40);
    judge_by_errors_of(d, none);
    EXPECT_EQ(d.find("lift")->verdict, Verdict::not_converged);
    EXPECT_TRUE(has(d.find("lift")->sentence, "without an interval")) << d.find("lift")->sentence;
}

}  // namespace sizes_test
}  // namespace tw
