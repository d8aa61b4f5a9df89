#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "compare/grid_study/grid_study.h"
#include "compare/grid_study/grid_study_report.h"
#include "compare/uncertainty/refinement_table.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace grid_study_test {

/// Runs of one method whose lift approaches `limit` with the given order: lift = limit + error (h/h_1)^order.
void add_family(std::vector<RunRecord>& records, const std::string& method, double limit, double error, double order,
                int levels = 4) {
    for (int k = 0; k < levels; ++k) {
        const double h = 0.04 * std::pow(std::sqrt(2.0), k);
        SyntheticRun run;
        run.method = method;
        run.lift = limit + error * std::pow(h / 0.04, order);
        run.noise = 2;
        run.frames = false;
        run.seed = static_cast<unsigned>(10 * k + (method == "sph" ? 1 : 2));
        RunRecord record = synthetic_run(run);
        record.numbers["near_hull"] = h;
        record.phases = {{"solving", 100 / std::pow(h / 0.04, 4), 0}};
        record.state = "finished";
        records.push_back(std::move(record));
    }
}

GridStudy grid_study_of(const std::vector<RunRecord>& records) {
    std::vector<GridStudyRun> runs;
    for (const RunRecord& record : records) runs.push_back(grid_study_run(record));
    return build_grid_study(std::move(runs));
}

const GridStudyQuantity& lift_of(const GridStudy& grid_study) {
    for (const GridStudyQuantity& q : grid_study.quantities)
        if (q.name == "lift") return q;
    throw std::runtime_error("no lift");
}

TEST(GridStudy, MethodsThatConvergeToOneValueAgreeThoughTheirFinestValuesDiffer) {
    std::vector<RunRecord> records;
    add_family(records, "fvm", 2800, 2, 2);  // coarsest and finest mixed up on purpose: any order is accepted
    add_family(records, "sph", 2800, 24, 2);
    const GridStudy grid_study = grid_study_of(records);
    ASSERT_EQ(grid_study.sides.size(), 2u);
    EXPECT_EQ(grid_study.sides[0].method, "sph");
    const GridStudyQuantity& lift = lift_of(grid_study);
    EXPECT_EQ(lift.values[0].levels.size(), 4u);
    EXPECT_NEAR(lift.values[0].estimate.order, 2, 0.3);
    EXPECT_NEAR(lift.difference, -22, 3);
    EXPECT_LT(std::hypot(lift.values[0].statistical, lift.values[1].statistical), 10);  // by these alone they differ
    EXPECT_GT(lift.interval, 24);
    EXPECT_EQ(lift.verdict, Verdict::agree) << lift.reason;
}

TEST(GridStudy, MethodsThatConvergeToTwoValuesDiffer) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 3200, 10, 2);
    add_family(records, "fvm", 2800, 10, 2);
    const GridStudyQuantity lift = lift_of(grid_study_of(records));
    EXPECT_EQ(lift.verdict, Verdict::differ);
    EXPECT_NEAR(lift.difference, -400, 5);
}

TEST(GridStudy, ThreeSourcesHaveAVerdictForEveryTwoOfThem) {
    std::vector<RunRecord> records;
    add_family(records, "other code", 3200, 10, 2);
    add_family(records, "fvm", 2800, 2, 2);
    add_family(records, "sph", 2800, 24, 2);
    const GridStudy grid_study = grid_study_of(records);
    ASSERT_EQ(grid_study.sides.size(), 3u);
    EXPECT_EQ(grid_study.sides[0].method, "sph");
    EXPECT_EQ(grid_study.sides[2].method, "other code");  // what is no method of twinwake stands behind
    const GridStudyQuantity& lift = lift_of(grid_study);
    ASSERT_EQ(lift.pairs.size(), 3u);
    std::vector<RunRecord> two;
    add_family(two, "sph", 2800, 24, 2);
    add_family(two, "fvm", 2800, 2, 2);
    const GridStudyQuantity without = lift_of(grid_study_of(two));  // a third source changes nothing of the other two
    EXPECT_DOUBLE_EQ(lift.pairs[0].difference, without.difference);
    EXPECT_DOUBLE_EQ(lift.pairs[0].interval, without.interval);
    EXPECT_EQ(lift.pairs[0].verdict, Verdict::agree) << lift.pairs[0].reason;
    EXPECT_EQ(lift.pairs[1].verdict, Verdict::differ);
    EXPECT_EQ(lift.pairs[2].verdict, Verdict::differ);
    EXPECT_NEAR(lift.pairs[1].difference, 3210 - 2824, 5);
    EXPECT_NEAR(lift.pairs[2].difference, 3210 - 2802, 5);
    EXPECT_EQ(lift.verdict, Verdict::differ);
    EXPECT_EQ(lift.b, 2u);

    const std::string text = grid_study_text(grid_study);
    for (const char* said : {"Lift: SPH ", " above interFoam, ", " below other code, ", "| interFoam − SPH",
                             "| other code − SPH", "| other code − interFoam"})
        EXPECT_NE(text.find(said), std::string::npos) << said << "\n" << text;
    const auto json = nlohmann::json::parse(grid_study_json(grid_study));
    for (const auto& q : json["quantities"])
        if (q["name"] == "lift") {
            ASSERT_EQ(q["pairs"].size(), 3u);
            EXPECT_EQ(q["pairs"][2]["methods"], nlohmann::json({"fvm", "other code"}));
            EXPECT_EQ(q["pairs"][0]["verdict"], "agree");
        }
}

TEST(GridStudy, CoarseRunsAreUndecidedAndTheLargestTermIsNamed) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, 1);
    add_family(records, "fvm", 2800, 5, 2);
    const GridStudyQuantity lift = lift_of(grid_study_of(records));
    EXPECT_EQ(lift.verdict, Verdict::undecided);
    EXPECT_NE(lift.reason.find("SPH's discretisation error"), std::string::npos) << lift.reason;
}

/// The error of the other method is no term that stays as it is: finer runs make both smaller.
TEST(GridStudy, TheRemedyOfADiscretisationErrorIsThatOfBothMethods) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, 1);
    add_family(records, "fvm", 2800, 300, 1);
    const GridStudyQuantity lift = lift_of(grid_study_of(records));
    ASSERT_EQ(lift.verdict, Verdict::undecided);
    ASSERT_TRUE(std::isfinite(lift.seconds_to_target));
    EXPECT_NE(lift.reason.find("; finer runs of "), std::string::npos) << lift.reason;
    EXPECT_EQ(lift.reason.find("already above"), std::string::npos) << lift.reason;
}

TEST(GridStudy, AChoiceThatShouldNotMatterAddsToTheInterval) {
    std::vector<RunRecord> records, varied;
    add_family(records, "sph", 2800, 10, 2);
    add_family(records, "fvm", 2800, 10, 2);
    std::vector<GridStudyRun> runs;
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    const double without = lift_of(build_grid_study(runs)).values[0].uncertainty;
    add_family(varied, "sph", 2900, 10, 2);
    const GridStudyVariation faster{"sound speed x 1.5", 1.8, grid_study_run(varied[2])};  // at 0.08 m: 100 N more
    const GridStudy grid_study = build_grid_study(runs, {faster});
    const GridStudyValue& sph = lift_of(grid_study).values[0];
    ASSERT_EQ(sph.sensitivities.size(), 1u);
    EXPECT_NEAR(sph.sensitivities[0].uncertainty, 180, 8);
    EXPECT_NEAR(sph.uncertainty, std::hypot(without, sph.sensitivities[0].uncertainty), 1e-6);
    EXPECT_EQ(lift_of(grid_study).values[1].sensitivities.size(), 0u);
    EXPECT_NE(grid_study_text(grid_study).find("sound speed x 1.5"), std::string::npos);

    GridStudyVariation same = faster;
    same.run = runs[2];
    EXPECT_TRUE(lift_of(build_grid_study(runs, {same})).values[0].sensitivities[0].idle());
    GridStudyVariation lone = faster;
    lone.run.spacing = 0.05;
    EXPECT_THROW(build_grid_study(runs, {lone}), InputError);
}

TEST(GridStudy, ThePriceOfADigitFollowsFromOrderAndCost) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 100, 2);  // error with h^2 at a cost with h^-4
    const GridStudy grid_study = grid_study_of(records);
    const CostOfAccuracy& cost = lift_of(grid_study).values[0].cost;
    ASSERT_TRUE(cost.known()) << cost.why_not;
    EXPECT_GT(cost.price_of_halving(), 3.4);  // 4, and more for the noise that is allowed for at every size
    EXPECT_LT(cost.price_of_halving(), 9);
    const std::string page = grid_study_html(grid_study);
    EXPECT_NE(page.find("What accuracy costs"), std::string::npos);
    EXPECT_NE(page.find("<svg"), std::string::npos);
}

TEST(GridStudy, WhatIsUndecidedSaysWhatItWouldCostToDecide) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, 1);
    add_family(records, "fvm", 2800, 5, 2);
    EXPECT_NE(lift_of(grid_study_of(records)).reason.find("would suffice"), std::string::npos);
}

TEST(GridStudy, AMeasuredValueIsHeldAgainstEachMethodAndTakesNoPartInTheVerdictBetweenThem) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 10, 2);
    add_family(records, "fvm", 3000, 10, 2);
    std::vector<GridStudyRun> runs;
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    SyntheticRun tank;
    tank.method = "towing tank", tank.lift = 2805, tank.noise = 2, tank.frames = false;
    const RunRecord measured = synthetic_run(tank);
    const GridStudy grid_study = build_grid_study(runs, {}, 0.05, {measured});
    const GridStudyQuantity& lift = lift_of(grid_study);
    EXPECT_EQ(lift.verdict, lift_of(build_grid_study(runs)).verdict);
    const Held& tank_says = lift.held.back();
    EXPECT_EQ(tank_says.source, "towing tank");
    EXPECT_EQ(tank_says.validations[0].verdict, Verdict::agree);
    EXPECT_NEAR(tank_says.validations[0].E, 5, 2);
    EXPECT_EQ(tank_says.validations[1].verdict, Verdict::differ);
    EXPECT_TRUE(lift.held.front().source.starts_with("Savitsky 1964 (")) << lift.held.front().source;  // a prism
    EXPECT_NEAR(lift.held.front().value.half_width, 0.1 * lift.held.front().value.value, 1e-9);
    EXPECT_NE(grid_study_text(grid_study).find("| towing tank  "), std::string::npos);
    EXPECT_NE(grid_study_html(grid_study).find("Compared with measurements"), std::string::npos);
    RunRecord other = measured;
    other.attributes["hull_hash"] = "another";
    EXPECT_THROW(build_grid_study(runs, {}, 0.05, {other}), InputError);
}

/// Two methods of the same limit, SPH's lifts moved up and down from size to size by `scatter` [N].
GridStudyQuantity lift_with_scatter(double scatter, double fvm_limit) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 10, 2);
    add_family(records, "fvm", fvm_limit, 10, 2);
    std::vector<GridStudyRun> runs;
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    double sign = 1;
    for (GridStudyRun& run : runs)
        if (run.method == "sph")
            for (Quantity& q : run.quantities)
                if (q.name == "lift") q.values[0].value += scatter * (sign = -sign);
    return lift_of(build_grid_study(runs));
}

TEST(GridStudy, AScatterWiderThanTheTargetIsUndecidedAndItsRemedySaid) {
    const GridStudyQuantity lift = lift_with_scatter(100, 2800);
    EXPECT_EQ(lift.values[0].estimate.convergence, Convergence::scattered);
    EXPECT_EQ(lift.verdict, Verdict::undecided);
    EXPECT_NE(lift.reason.find("sizes between these narrow the interval"), std::string::npos) << lift.reason;
    EXPECT_EQ(lift.held.front().validations[0].verdict, Verdict::undecided);
    EXPECT_TRUE(std::isfinite(lift.interval));
}

TEST(GridStudy, ValuesThatScatterAgreeOrDifferLikeAnyOthers) {
    EXPECT_EQ(lift_with_scatter(10, 2800).verdict, Verdict::agree) << lift_with_scatter(10, 2800).reason;
    EXPECT_EQ(lift_with_scatter(10, 4500).verdict, Verdict::differ);
}

TEST(GridStudy, ValuesThatRunAwayAreNotConverged) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, -1);
    add_family(records, "fvm", 2800, 10, 2);
    const GridStudyQuantity lift = lift_of(grid_study_of(records));
    EXPECT_EQ(lift.verdict, Verdict::not_converged);
    EXPECT_NE(lift.reason.find("do not decrease"), std::string::npos) << lift.reason;
}

TEST(GridStudy, TheReportNamesTheMethodOfEachUncertaintyAndTheOthersBesideIt) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 100, 2);
    add_family(records, "fvm", 2800, 10, 2, 2);
    GridStudy grid_study = grid_study_of(records);
    grid_study.left_out = {"SPH at 0.02 m: beyond the budget"};
    const std::string text = grid_study_text(grid_study), page = grid_study_html(grid_study);
    for (const std::string& out : {text, page}) {
        EXPECT_NE(out.find("by trend and noise"), std::string::npos) << out;
        EXPECT_NE(out.find("Eça"), std::string::npos);
        EXPECT_NE(out.find("two sizes cannot show whether it converges"), std::string::npos);
        EXPECT_NE(out.find("with Fs = 3"), std::string::npos);
        EXPECT_NE(out.find("GCI"), std::string::npos);
        EXPECT_NE(out.find("factor of safety"), std::string::npos);
        EXPECT_NE(out.find("core hours to 2 %"), std::string::npos);
    }
    EXPECT_NE(text.find("beyond the budget"), std::string::npos);
    EXPECT_GT(lift_of(grid_study).values[0].estimate.celik_gci.uncertainty, 0);
}

TEST(GridStudy, OneSizeAloneIsNotConverged) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2, 1);
    add_family(records, "fvm", 2800, 30, 2);
    EXPECT_EQ(lift_of(grid_study_of(records)).verdict, Verdict::not_converged);
}

TEST(GridStudy, OneMethodAloneHasItsUncertaintyAndNoVerdict) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    const GridStudyQuantity lift = lift_of(grid_study_of(records));
    EXPECT_EQ(lift.verdict, Verdict::not_comparable);
    EXPECT_GT(lift.values[0].uncertainty, 0);
}

TEST(GridStudy, ARunOfAnotherHullIsNoMemberOfTheFamily) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    EXPECT_TRUE(grid_study_of(records).sides[0].similar);
    records[1].attributes["hull_hash"] = "hull-2";
    const GridStudy grid_study = grid_study_of(records);
    EXPECT_FALSE(grid_study.sides[0].similar);
    EXPECT_NE(grid_study_text(grid_study).find("do not form a family"), std::string::npos);
}

/// Four sizes whose records know their family.
std::vector<RunRecord> family_with_hash() {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    for (RunRecord& r : records) {
        r.attributes["family_hash"] = "family-1", r.attributes["time_scheme"] = "leapfrog";
        r.numbers["delta"] = 0.1, r.numbers["c0"] = 80, r.numbers["cfl"] = 1.2;
    }
    return records;
}

std::string refusal_of(const std::vector<RunRecord>& records) {
    try {
        grid_study_of(records);
    } catch (const InputError& e) { return e.what(); }
    return "not refused";
}

TEST(GridStudy, RunsOfTwoFamiliesAreRefusedWithWhatDiffers) {
    EXPECT_EQ(refusal_of(family_with_hash()), "not refused");
    const auto changed = [](auto change) {
        std::vector<RunRecord> records = family_with_hash();
        records[1].attributes["family_hash"] = "family-2";
        change(records[1]);
        return refusal_of(records);
    };
    EXPECT_NE(
        changed([](RunRecord& r) { r.numbers["delta"] = 0.2; }).find("delta is 0.1 and 0.2; expected runs of one"),
        std::string::npos);
    const std::string scheme = changed([](RunRecord& r) { r.attributes["time_scheme"] = "symplectic"; });
    EXPECT_NE(scheme.find("SPH at 0.04 m and SPH at 0.0565685 m are not of one family: time_scheme is leapfrog and "
                          "symplectic"),
              std::string::npos)
        << scheme;
    EXPECT_NE(changed([](RunRecord& r) { r.effects[0].on = true; }).find("effect viscosity is off and on"),
              std::string::npos);
    EXPECT_NE(changed([](RunRecord&) {}).find("numerics that records do not list"), std::string::npos);
    // What follows from the size or the length of a run is no difference.
    std::vector<RunRecord> longer = family_with_hash();
    longer[2].numbers["duration"] = 3, longer[2].numbers["wall_particles"] = 17;
    EXPECT_EQ(refusal_of(longer), "not refused");
}

TEST(GridStudy, RecordsWithoutAFamilyFallBackToTheirMainNumbers) {
    std::vector<RunRecord> records = family_with_hash();
    for (RunRecord& r : records) r.attributes.erase("family_hash");
    records[1].numbers["delta"] = 0.2;  // not among them
    EXPECT_TRUE(grid_study_of(records).sides[0].similar);
    records[1].numbers["c0"] = 90;
    EXPECT_FALSE(grid_study_of(records).sides[0].similar);
}

TEST(GridStudy, ARunWithAGeometricSurfaceIsAVariationOfItsTwinAndCountsInFull) {
    std::vector<RunRecord> records = family_with_hash();
    for (RunRecord& r : records) r.attributes["interface"] = "mules";
    RunRecord geometric = records[2];
    geometric.attributes["family_hash"] = "geometric";
    geometric.attributes["interface"] = "isoadvector";
    std::vector<GridStudyRun> runs{grid_study_run(geometric)};
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    const std::vector<GridStudyVariation> variations = take_variations(runs);
    ASSERT_EQ(variations.size(), 1u);
    EXPECT_EQ(variations[0].name, "geometric surface");
    EXPECT_EQ(variations[0].factor, 1);
    EXPECT_EQ(runs.size(), 4u);
    geometric.numbers["delta"] = 0.2;  // and something else
    runs.push_back(grid_study_run(geometric));
    EXPECT_TRUE(take_variations(runs).empty());
}

// Two ends of a draft that change the lift by +30 and -10, and one of a trim that changes it by 40.
TEST(GridStudy, UncertainInputIsPartOfAValueAndNotOfTheDifference) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 24, 2);
    add_family(records, "fvm", 2800, 2, 2);
    const GridStudy without = grid_study_of(records);
    std::vector<GridStudyRun> runs;
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    std::vector<GridStudyVariation> ends;
    const auto add = [&](const char* input, double change) {
        GridStudyRun run = runs[3];
        for (Quantity& q : run.quantities)
            if (q.name == "lift") q.values[0].value += change;
        ends.push_back({std::string(input) + " at an end", 1, run});
        ends.back().input = input;
    };
    add("hull.draft", 30), add("hull.draft", -10), add("hull.trim", 40);
    const GridStudyQuantity alone = lift_of(without), lift = lift_of(build_grid_study(runs, ends));
    const double draft = std::sqrt((900.0 + 100.0) / 2);
    const auto inputs = inputs_of(lift.values[0].sensitivities);
    EXPECT_NEAR(inputs.at("hull.draft"), draft, 1e-9);
    EXPECT_NEAR(inputs.at("hull.trim"), 40, 1e-9);
    EXPECT_NEAR(lift.values[0].input, std::hypot(draft, 40), 1e-9);
    EXPECT_EQ(lift.values[0].choices, 0);
    EXPECT_NEAR(lift.values[0].uncertainty, std::hypot(alone.values[0].uncertainty, draft, 40), 1e-9);
    EXPECT_EQ(lift.values[1].input, 0);
    EXPECT_EQ(lift.interval, alone.interval);
}

TEST(GridStudy, ARunWithAnotherSoundSpeedOrTimeStepIsAVariationOfItsTwin) {
    std::vector<GridStudyRun> runs;
    const std::vector<RunRecord> records = family_with_hash();
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    const auto add = [&](const char* number, double value) {
        RunRecord r = records[2];
        r.attributes["family_hash"] = std::string("varied ") + number;
        r.numbers[number] = value;
        runs.insert(runs.begin(), grid_study_run(r));
    };
    add("c0", 120);
    add("cfl", 0.6);
    const std::vector<GridStudyVariation> variations = take_variations(runs);
    ASSERT_EQ(variations.size(), 2u);
    EXPECT_EQ(variations[0].name, "half the time step");
    EXPECT_DOUBLE_EQ(variations[0].factor, 2);
    EXPECT_EQ(variations[1].name, "sound speed x 1.5");
    EXPECT_DOUBLE_EQ(variations[1].factor, 1.8);
    EXPECT_EQ(runs.size(), 4u);
    EXPECT_EQ(build_grid_study(runs, variations).sides[0].variations.size(), 2u);
    add("delta", 0.2);  // no choice that should not matter
    EXPECT_TRUE(take_variations(runs).empty());
    EXPECT_THROW(build_grid_study(runs), InputError);
}

TEST(GridStudy, AMeasuredPeakAfterTheRunsTakesNoPart) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 10, 2);
    const auto add_gauge = [](RunRecord& r, double end) {
        r.attributes["motion"] = "none", r.numbers["speed"] = 0;
        Table& t = r.table("pressure");
        for (double time = 0; time <= end + 1e-9; time += 0.1) {
            t.time.push_back(time);
            t.column("P1", "Pa").values.push_back(time < 2.5 ? 1000 : 7000);
        }
    };
    for (RunRecord& r : records) add_gauge(r, 2);
    RunRecord measured = synthetic_run({.method = "basin", .frames = false});
    add_gauge(measured, 5);
    measured.numbers["duration"] = 5;
    std::vector<GridStudyRun> runs;
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    const GridStudy grid_study = build_grid_study(runs, {}, 0.05, {measured});
    for (const char* name : {"pressure_peak:P1", "pressure_mean:P1"}) {
        const auto q = std::ranges::find(grid_study.quantities, name, &GridStudyQuantity::name);
        ASSERT_NE(q, grid_study.quantities.end()) << name;
        ASSERT_FALSE(q->held.empty()) << name;
        EXPECT_NEAR(q->held[0].value.value, 1000, 1e-9) << name;
    }
}

TEST(GridStudy, WhatIsOnlyRoundingIsNoUncertaintyAndNoPrice) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 10, 2);
    add_family(records, "fvm", 2800, 10, 2);
    std::vector<GridStudyRun> runs;
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    for (std::size_t k = 0; k < runs.size(); ++k)
        for (Quantity& q : runs[k].quantities)
            if (q.name == "wetted_length") {
                q.values[0].value = (runs[k].method == "sph" ? 2.35 : 2.36) + 1e-12 * std::exp2(k % 4);
                q.values[0].half_width = 0;
            }
    const GridStudy grid_study = build_grid_study(runs);
    const auto q = std::ranges::find(grid_study.quantities, "wetted_length", &GridStudyQuantity::name);
    EXPECT_FALSE(q->values[0].cost.known());
    EXPECT_EQ(crossover_sentence(grid_study, *q), "");
    EXPECT_EQ(q->verdict, Verdict::not_converged) << "no uncertainty is no proof of a difference";
    for (const std::string& out : {grid_study_text(grid_study), grid_study_html(grid_study)}) {
        for (const char* digits : {"e-11", "e-12", "e-13"}) EXPECT_EQ(out.find(digits), std::string::npos) << digits;
        EXPECT_NE(out.find("no discretisation error is seen"), std::string::npos);
    }
}

TEST(GridStudy, NoSentenceHasAHoleForANumber) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, 1);
    add_family(records, "fvm", 2800, 5, 2);
    for (RunRecord& r : records) r.phases.clear();  // no cost is known
    const std::string text = grid_study_text(grid_study_of(records));
    for (const char* hole : {"about – ", "about - ", "about 0 s", "instead of 0 s", "about nan", "about inf"})
        EXPECT_EQ(text.find(hole), std::string::npos) << hole;
}

TEST(GridStudy, ChecksThatARunDoesNotMeetAreListedWithItsSize) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    records[2].validity_checks = {{"compression", "%", 17.8, 5, 0.31}};
    const GridStudy grid_study = grid_study_of(records);
    for (const std::string& out :
         {grid_study_summary(grid_study), grid_study_text(grid_study), grid_study_html(grid_study)}) {
        EXPECT_NE(out.find("17.8"), std::string::npos);
        EXPECT_NE(out.find("SPH at 0.08 m"), std::string::npos);
    }
}

TEST(GridStudy, MethodsWithOtherHullsAreRefused) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    add_family(records, "fvm", 2800, 30, 2);
    for (RunRecord& r : records)
        if (r.attributes["method"] == "fvm") r.attributes["hull_hash"] = "hull-2";
    EXPECT_THROW(grid_study_of(records), InputError);
}

TEST(GridStudy, TheUncertaintyOfAMeasurementWidensItsInterval) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 10, 2);
    RunRecord measured = synthetic_run({.method = "basin", .frames = false});
    const auto add_probe = [](RunRecord& r, double value) {
        r.attributes["motion"] = "none", r.numbers["speed"] = 0;
        Table& t = r.table("pressure");
        for (double time = 0; time <= r.numbers["duration"]; time += 0.1) {
            t.time.push_back(time);
            t.column("P1", "Pa").values.push_back(value);
        }
    };
    for (RunRecord& r : records) add_probe(r, 1000);
    add_probe(measured, 1020);
    std::vector<GridStudyRun> runs;
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    const auto width = [&] {
        for (const GridStudyQuantity& q : build_grid_study(runs, {}, 0.05, {measured}).quantities)
            if (q.name == "pressure_mean:P1") return q.held.at(0).value.half_width;
        return -1.0;
    };
    EXPECT_EQ(width(), 0);
    measured.numbers["uncertainty:pressure:P1"] = 30;
    EXPECT_EQ(width(), 30);
}

TEST(GridStudy, RefusesWhatIsNoGridStudy) {
    EXPECT_THROW(grid_study_of({}), InputError);
    std::vector<RunRecord> twice;
    add_family(twice, "sph", 2800, 30, 2, 1);
    add_family(twice, "sph", 2800, 30, 2, 1);
    EXPECT_THROW(grid_study_of(twice), InputError);
    twice[0].numbers.erase("near_hull");
    EXPECT_THROW(grid_study_of(twice), InputError);
}

TEST(GridStudy, ItsTableIsReadByTheUncertaintyCommandAndItsTextIsSafe) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    for (RunRecord& r : records) r.attributes["title"] = "a\x1b[31mred";
    const GridStudy grid_study = grid_study_of(records);
    const RefinementTable table = parse_refinement_table(grid_study_csv(grid_study, 0), "ladder.csv");
    ASSERT_EQ(table.spacing.size(), 4u);
    bool has_lift = false;
    for (const auto& column : table.columns) has_lift |= column.name == "lift [N]";
    EXPECT_TRUE(has_lift);
    EXPECT_EQ(grid_study_text(grid_study).find('\x1b'), std::string::npos);
    EXPECT_EQ(grid_study_html(grid_study).find('\x1b'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(grid_study_json(grid_study))["sides"][0]["method"], "sph");
}

}  // namespace grid_study_test
}  // namespace tw
