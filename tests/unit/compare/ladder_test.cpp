#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "compare/ladder/ladder.h"
#include "compare/ladder/ladder_report.h"
#include "compare/uncertainty/refinement_table.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace ladder_test {

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

Ladder ladder_of(const std::vector<RunRecord>& records) {
    std::vector<LadderRun> runs;
    for (const RunRecord& record : records) runs.push_back(ladder_run(record));
    return build_ladder(std::move(runs));
}

const LadderQuantity& lift_of(const Ladder& ladder) {
    for (const LadderQuantity& q : ladder.quantities)
        if (q.name == "lift") return q;
    throw std::runtime_error("no lift");
}

TEST(Ladder, MethodsThatConvergeToOneValueAgreeThoughTheirFinestValuesDiffer) {
    std::vector<RunRecord> records;
    add_family(records, "fvm", 2800, 2, 2);  // coarsest and finest mixed up on purpose: any order is accepted
    add_family(records, "sph", 2800, 24, 2);
    const Ladder ladder = ladder_of(records);
    ASSERT_EQ(ladder.sides.size(), 2u);
    EXPECT_EQ(ladder.sides[0].method, "sph");
    const LadderQuantity& lift = lift_of(ladder);
    EXPECT_EQ(lift.values[0].levels.size(), 4u);
    EXPECT_NEAR(lift.values[0].estimate.order, 2, 0.3);
    EXPECT_NEAR(lift.difference, -22, 3);
    EXPECT_LT(std::hypot(lift.values[0].statistical, lift.values[1].statistical), 10);  // by these alone they differ
    EXPECT_GT(lift.interval, 24);
    EXPECT_EQ(lift.verdict, Verdict::agree) << lift.reason;
}

TEST(Ladder, MethodsThatConvergeToTwoValuesDiffer) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 3200, 10, 2);
    add_family(records, "fvm", 2800, 10, 2);
    const LadderQuantity lift = lift_of(ladder_of(records));
    EXPECT_EQ(lift.verdict, Verdict::differ);
    EXPECT_NEAR(lift.difference, -400, 5);
}

TEST(Ladder, ThreeSourcesHaveAVerdictForEveryTwoOfThem) {
    std::vector<RunRecord> records;
    add_family(records, "other code", 3200, 10, 2);
    add_family(records, "fvm", 2800, 2, 2);
    add_family(records, "sph", 2800, 24, 2);
    const Ladder ladder = ladder_of(records);
    ASSERT_EQ(ladder.sides.size(), 3u);
    EXPECT_EQ(ladder.sides[0].method, "sph");
    EXPECT_EQ(ladder.sides[2].method, "other code");  // what is no method of twinwake stands behind
    const LadderQuantity& lift = lift_of(ladder);
    ASSERT_EQ(lift.pairs.size(), 3u);
    std::vector<RunRecord> two;
    add_family(two, "sph", 2800, 24, 2);
    add_family(two, "fvm", 2800, 2, 2);
    const LadderQuantity without = lift_of(ladder_of(two));  // a third source changes nothing of the other two
    EXPECT_DOUBLE_EQ(lift.pairs[0].difference, without.difference);
    EXPECT_DOUBLE_EQ(lift.pairs[0].interval, without.interval);
    EXPECT_EQ(lift.pairs[0].verdict, Verdict::agree) << lift.pairs[0].reason;
    EXPECT_EQ(lift.pairs[1].verdict, Verdict::differ);
    EXPECT_EQ(lift.pairs[2].verdict, Verdict::differ);
    EXPECT_NEAR(lift.pairs[1].difference, 3210 - 2824, 5);
    EXPECT_NEAR(lift.pairs[2].difference, 3210 - 2802, 5);
    EXPECT_EQ(lift.verdict, Verdict::differ);
    EXPECT_EQ(lift.b, 2u);

    const std::string text = ladder_text(ladder);
    for (const char* said : {"Lift: SPH ", " above interFoam, ", " below other code, ", "| interFoam − SPH",
                             "| other code − SPH", "| other code − interFoam"})
        EXPECT_NE(text.find(said), std::string::npos) << said << "\n" << text;
    const auto json = nlohmann::json::parse(ladder_json(ladder));
    for (const auto& q : json["quantities"])
        if (q["name"] == "lift") {
            ASSERT_EQ(q["pairs"].size(), 3u);
            EXPECT_EQ(q["pairs"][2]["methods"], nlohmann::json({"fvm", "other code"}));
            EXPECT_EQ(q["pairs"][0]["verdict"], "agree");
        }
}

TEST(Ladder, CoarseRunsAreUndecidedAndTheLargestTermIsNamed) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, 1);
    add_family(records, "fvm", 2800, 5, 2);
    const LadderQuantity lift = lift_of(ladder_of(records));
    EXPECT_EQ(lift.verdict, Verdict::undecided);
    EXPECT_NE(lift.reason.find("SPH's discretisation error"), std::string::npos) << lift.reason;
}

/// The error of the other method is no term that stays as it is: finer runs make both smaller.
TEST(Ladder, TheRemedyOfADiscretisationErrorIsThatOfBothMethods) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, 1);
    add_family(records, "fvm", 2800, 300, 1);
    const LadderQuantity lift = lift_of(ladder_of(records));
    ASSERT_EQ(lift.verdict, Verdict::undecided);
    ASSERT_TRUE(std::isfinite(lift.seconds_to_target));
    EXPECT_NE(lift.reason.find("; finer runs of "), std::string::npos) << lift.reason;
    EXPECT_EQ(lift.reason.find("already above"), std::string::npos) << lift.reason;
}

TEST(Ladder, AChoiceThatShouldNotMatterAddsToTheInterval) {
    std::vector<RunRecord> records, varied;
    add_family(records, "sph", 2800, 10, 2);
    add_family(records, "fvm", 2800, 10, 2);
    std::vector<LadderRun> runs;
    for (const RunRecord& r : records) runs.push_back(ladder_run(r));
    const double without = lift_of(build_ladder(runs)).values[0].uncertainty;
    add_family(varied, "sph", 2900, 10, 2);
    const LadderVariation faster{"sound speed x 1.5", 1.8, ladder_run(varied[2])};  // at 0.08 m: 100 N more
    const Ladder ladder = build_ladder(runs, {faster});
    const LadderValue& sph = lift_of(ladder).values[0];
    ASSERT_EQ(sph.sensitivities.size(), 1u);
    EXPECT_NEAR(sph.sensitivities[0].uncertainty, 180, 8);
    EXPECT_NEAR(sph.uncertainty, std::hypot(without, sph.sensitivities[0].uncertainty), 1e-6);
    EXPECT_EQ(lift_of(ladder).values[1].sensitivities.size(), 0u);
    EXPECT_NE(ladder_text(ladder).find("sound speed x 1.5"), std::string::npos);

    LadderVariation same = faster;
    same.run = runs[2];
    EXPECT_TRUE(lift_of(build_ladder(runs, {same})).values[0].sensitivities[0].idle());
    LadderVariation lone = faster;
    lone.run.spacing = 0.05;
    EXPECT_THROW(build_ladder(runs, {lone}), InputError);
}

TEST(Ladder, ThePriceOfADigitFollowsFromOrderAndCost) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 100, 2);  // error with h^2 at a cost with h^-4
    const Ladder ladder = ladder_of(records);
    const CostOfAccuracy& cost = lift_of(ladder).values[0].cost;
    ASSERT_TRUE(cost.known()) << cost.why_not;
    EXPECT_GT(cost.price_of_halving(), 3.4);  // 4, and more for the noise that is allowed for at every size
    EXPECT_LT(cost.price_of_halving(), 9);
    const std::string page = ladder_html(ladder);
    EXPECT_NE(page.find("What accuracy costs"), std::string::npos);
    EXPECT_NE(page.find("<svg"), std::string::npos);
}

TEST(Ladder, WhatIsUndecidedSaysWhatItWouldCostToDecide) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, 1);
    add_family(records, "fvm", 2800, 5, 2);
    EXPECT_NE(lift_of(ladder_of(records)).reason.find("would suffice"), std::string::npos);
}

TEST(Ladder, AMeasuredValueIsHeldAgainstEachMethodAndTakesNoPartInTheVerdictBetweenThem) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 10, 2);
    add_family(records, "fvm", 3000, 10, 2);
    std::vector<LadderRun> runs;
    for (const RunRecord& r : records) runs.push_back(ladder_run(r));
    SyntheticRun tank;
    tank.method = "towing tank", tank.lift = 2805, tank.noise = 2, tank.frames = false;
    const RunRecord measured = synthetic_run(tank);
    const Ladder ladder = build_ladder(runs, {}, 0.05, {measured});
    const LadderQuantity& lift = lift_of(ladder);
    EXPECT_EQ(lift.verdict, lift_of(build_ladder(runs)).verdict);
    const Held& tank_says = lift.held.back();
    EXPECT_EQ(tank_says.source, "towing tank");
    EXPECT_EQ(tank_says.validations[0].verdict, Verdict::agree);
    EXPECT_NEAR(tank_says.validations[0].E, 5, 2);
    EXPECT_EQ(tank_says.validations[1].verdict, Verdict::differ);
    EXPECT_TRUE(lift.held.front().source.starts_with("Savitsky 1964 (")) << lift.held.front().source;  // a prism
    EXPECT_NEAR(lift.held.front().value.half_width, 0.1 * lift.held.front().value.value, 1e-9);
    EXPECT_NE(ladder_text(ladder).find("| towing tank  "), std::string::npos);
    EXPECT_NE(ladder_html(ladder).find("Compared with measurements"), std::string::npos);
    RunRecord other = measured;
    other.attributes["hull_hash"] = "another";
    EXPECT_THROW(build_ladder(runs, {}, 0.05, {other}), InputError);
}

/// Two methods of the same limit, SPH's lifts moved up and down from size to size by `scatter` [N].
LadderQuantity lift_with_scatter(double scatter, double fvm_limit) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 10, 2);
    add_family(records, "fvm", fvm_limit, 10, 2);
    std::vector<LadderRun> runs;
    for (const RunRecord& r : records) runs.push_back(ladder_run(r));
    double sign = 1;
    for (LadderRun& run : runs)
        if (run.method == "sph")
            for (Quantity& q : run.quantities)
                if (q.name == "lift") q.values[0].value += scatter * (sign = -sign);
    return lift_of(build_ladder(runs));
}

TEST(Ladder, AScatterWiderThanTheTargetIsUndecidedAndItsRemedySaid) {
    const LadderQuantity lift = lift_with_scatter(100, 2800);
    EXPECT_EQ(lift.values[0].estimate.convergence, Convergence::scattered);
    EXPECT_EQ(lift.verdict, Verdict::undecided);
    EXPECT_NE(lift.reason.find("sizes between these narrow the interval"), std::string::npos) << lift.reason;
    EXPECT_EQ(lift.held.front().validations[0].verdict, Verdict::undecided);
    EXPECT_TRUE(std::isfinite(lift.interval));
}

TEST(Ladder, ValuesThatScatterAgreeOrDifferLikeAnyOthers) {
    EXPECT_EQ(lift_with_scatter(10, 2800).verdict, Verdict::agree) << lift_with_scatter(10, 2800).reason;
    EXPECT_EQ(lift_with_scatter(10, 4500).verdict, Verdict::differ);
}

TEST(Ladder, ValuesThatRunAwayAreNotConverged) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, -1);
    add_family(records, "fvm", 2800, 10, 2);
    const LadderQuantity lift = lift_of(ladder_of(records));
    EXPECT_EQ(lift.verdict, Verdict::not_converged);
    EXPECT_NE(lift.reason.find("do not decrease"), std::string::npos) << lift.reason;
}

TEST(Ladder, TheReportNamesTheMethodOfEachUncertaintyAndTheOthersBesideIt) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 100, 2);
    add_family(records, "fvm", 2800, 10, 2, 2);
    Ladder ladder = ladder_of(records);
    ladder.left_out = {"SPH at 0.02 m: beyond the budget"};
    const std::string text = ladder_text(ladder), page = ladder_html(ladder);
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
    EXPECT_GT(lift_of(ladder).values[0].estimate.celik_gci.uncertainty, 0);
}

TEST(Ladder, OneSizeAloneIsNotConverged) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2, 1);
    add_family(records, "fvm", 2800, 30, 2);
    EXPECT_EQ(lift_of(ladder_of(records)).verdict, Verdict::not_converged);
}

TEST(Ladder, OneMethodAloneHasItsUncertaintyAndNoVerdict) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    const LadderQuantity lift = lift_of(ladder_of(records));
    EXPECT_EQ(lift.verdict, Verdict::not_comparable);
    EXPECT_GT(lift.values[0].uncertainty, 0);
}

TEST(Ladder, ARunOfAnotherHullIsNoMemberOfTheFamily) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    EXPECT_TRUE(ladder_of(records).sides[0].similar);
    records[1].attributes["hull_hash"] = "hull-2";
    const Ladder ladder = ladder_of(records);
    EXPECT_FALSE(ladder.sides[0].similar);
    EXPECT_NE(ladder_text(ladder).find("do not form a family"), std::string::npos);
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
        ladder_of(records);
    } catch (const InputError& e) { return e.what(); }
    return "not refused";
}

TEST(Ladder, RunsOfTwoFamiliesAreRefusedWithWhatDiffers) {
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

TEST(Ladder, RecordsWithoutAFamilyFallBackToTheirMainNumbers) {
    std::vector<RunRecord> records = family_with_hash();
    for (RunRecord& r : records) r.attributes.erase("family_hash");
    records[1].numbers["delta"] = 0.2;  // not among them
    EXPECT_TRUE(ladder_of(records).sides[0].similar);
    records[1].numbers["c0"] = 90;
    EXPECT_FALSE(ladder_of(records).sides[0].similar);
}

TEST(Ladder, ARunWithAGeometricSurfaceIsAVariationOfItsTwinAndCountsInFull) {
    std::vector<RunRecord> records = family_with_hash();
    for (RunRecord& r : records) r.attributes["interface"] = "mules";
    RunRecord geometric = records[2];
    geometric.attributes["family_hash"] = "geometric";
    geometric.attributes["interface"] = "isoadvector";
    std::vector<LadderRun> runs{ladder_run(geometric)};
    for (const RunRecord& r : records) runs.push_back(ladder_run(r));
    const std::vector<LadderVariation> variations = take_variations(runs);
    ASSERT_EQ(variations.size(), 1u);
    EXPECT_EQ(variations[0].name, "geometric surface");
    EXPECT_EQ(variations[0].factor, 1);
    EXPECT_EQ(runs.size(), 4u);
    geometric.numbers["delta"] = 0.2;  // and something else
    runs.push_back(ladder_run(geometric));
    EXPECT_TRUE(take_variations(runs).empty());
}

// Two ends of a draft that change the lift by +30 and -10, and one of a trim that changes it by 40.
TEST(Ladder, UncertainInputIsPartOfAValueAndNotOfTheDifference) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 24, 2);
    add_family(records, "fvm", 2800, 2, 2);
    const Ladder without = ladder_of(records);
    std::vector<LadderRun> runs;
    for (const RunRecord& r : records) runs.push_back(ladder_run(r));
    std::vector<LadderVariation> ends;
    const auto add = [&](const char* input, double change) {
        LadderRun run = runs[3];
        for (Quantity& q : run.quantities)
            if (q.name == "lift") q.values[0].value += change;
        ends.push_back({std::string(input) + " at an end", 1, run});
        ends.back().input = input;
    };
    add("hull.draft", 30), add("hull.draft", -10), add("hull.trim", 40);
    const LadderQuantity alone = lift_of(without), lift = lift_of(build_ladder(runs, ends));
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

TEST(Ladder, ARunWithAnotherSoundSpeedOrTimeStepIsAVariationOfItsTwin) {
    std::vector<LadderRun> runs;
    const std::vector<RunRecord> records = family_with_hash();
    for (const RunRecord& r : records) runs.push_back(ladder_run(r));
    const auto add = [&](const char* number, double value) {
        RunRecord r = records[2];
        r.attributes["family_hash"] = std::string("varied ") + number;
        r.numbers[number] = value;
        runs.insert(runs.begin(), ladder_run(r));
    };
    add("c0", 120);
    add("cfl", 0.6);
    const std::vector<LadderVariation> variations = take_variations(runs);
    ASSERT_EQ(variations.size(), 2u);
    EXPECT_EQ(variations[0].name, "half the time step");
    EXPECT_DOUBLE_EQ(variations[0].factor, 2);
    EXPECT_EQ(variations[1].name, "sound speed x 1.5");
    EXPECT_DOUBLE_EQ(variations[1].factor, 1.8);
    EXPECT_EQ(runs.size(), 4u);
    EXPECT_EQ(build_ladder(runs, variations).sides[0].variations.size(), 2u);
    add("delta", 0.2);  // no choice that should not matter
    EXPECT_TRUE(take_variations(runs).empty());
    EXPECT_THROW(build_ladder(runs), InputError);
}

TEST(Ladder, AMeasuredPeakAfterTheRunsTakesNoPart) {
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
    std::vector<LadderRun> runs;
    for (const RunRecord& r : records) runs.push_back(ladder_run(r));
    const Ladder ladder = build_ladder(runs, {}, 0.05, {measured});
    for (const char* name : {"pressure_peak:P1", "pressure_mean:P1"}) {
        const auto q = std::ranges::find(ladder.quantities, name, &LadderQuantity::name);
        ASSERT_NE(q, ladder.quantities.end()) << name;
        ASSERT_FALSE(q->held.empty()) << name;
        EXPECT_NEAR(q->held[0].value.value, 1000, 1e-9) << name;
    }
}

TEST(Ladder, WhatIsOnlyRoundingIsNoUncertaintyAndNoPrice) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 10, 2);
    add_family(records, "fvm", 2800, 10, 2);
    std::vector<LadderRun> runs;
    for (const RunRecord& r : records) runs.push_back(ladder_run(r));
    for (std::size_t k = 0; k < runs.size(); ++k)
        for (Quantity& q : runs[k].quantities)
            if (q.name == "wetted_length") {
                q.values[0].value = (runs[k].method == "sph" ? 2.35 : 2.36) + 1e-12 * std::exp2(k % 4);
                q.values[0].half_width = 0;
            }
    const Ladder ladder = build_ladder(runs);
    const auto q = std::ranges::find(ladder.quantities, "wetted_length", &LadderQuantity::name);
    EXPECT_FALSE(q->values[0].cost.known());
    EXPECT_EQ(crossover_sentence(ladder, *q), "");
    EXPECT_EQ(q->verdict, Verdict::not_converged) << "no uncertainty is no proof of a difference";
    for (const std::string& out : {ladder_text(ladder), ladder_html(ladder)}) {
        for (const char* digits : {"e-11", "e-12", "e-13"}) EXPECT_EQ(out.find(digits), std::string::npos) << digits;
        EXPECT_NE(out.find("no discretisation error is seen"), std::string::npos);
    }
}

TEST(Ladder, NoSentenceHasAHoleForANumber) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 300, 1);
    add_family(records, "fvm", 2800, 5, 2);
    for (RunRecord& r : records) r.phases.clear();  // no cost is known
    const std::string text = ladder_text(ladder_of(records));
    for (const char* hole : {"about – ", "about - ", "about 0 s", "instead of 0 s", "about nan", "about inf"})
        EXPECT_EQ(text.find(hole), std::string::npos) << hole;
}

TEST(Ladder, ChecksThatARunDoesNotMeetAreListedWithItsSize) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    records[2].certificate = {{"compression", "%", 17.8, 5, 0.31}};
    const Ladder ladder = ladder_of(records);
    for (const std::string& out : {ladder_summary(ladder), ladder_text(ladder), ladder_html(ladder)}) {
        EXPECT_NE(out.find("17.8"), std::string::npos);
        EXPECT_NE(out.find("SPH at 0.08 m"), std::string::npos);
    }
}

TEST(Ladder, MethodsWithOtherHullsAreRefused) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    add_family(records, "fvm", 2800, 30, 2);
    for (RunRecord& r : records)
        if (r.attributes["method"] == "fvm") r.attributes["hull_hash"] = "hull-2";
    EXPECT_THROW(ladder_of(records), InputError);
}

TEST(Ladder, TheUncertaintyOfAMeasurementWidensItsInterval) {
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
    std::vector<LadderRun> runs;
    for (const RunRecord& r : records) runs.push_back(ladder_run(r));
    const auto width = [&] {
        for (const LadderQuantity& q : build_ladder(runs, {}, 0.05, {measured}).quantities)
            if (q.name == "pressure_mean:P1") return q.held.at(0).value.half_width;
        return -1.0;
    };
    EXPECT_EQ(width(), 0);
    measured.numbers["uncertainty:pressure:P1"] = 30;
    EXPECT_EQ(width(), 30);
}

TEST(Ladder, RefusesWhatIsNoLadder) {
    EXPECT_THROW(ladder_of({}), InputError);
    std::vector<RunRecord> twice;
    add_family(twice, "sph", 2800, 30, 2, 1);
    add_family(twice, "sph", 2800, 30, 2, 1);
    EXPECT_THROW(ladder_of(twice), InputError);
    twice[0].numbers.erase("near_hull");
    EXPECT_THROW(ladder_of(twice), InputError);
}

TEST(Ladder, ItsTableIsReadByTheUncertaintyCommandAndItsTextIsSafe) {
    std::vector<RunRecord> records;
    add_family(records, "sph", 2800, 30, 2);
    for (RunRecord& r : records) r.attributes["title"] = "a\x1b[31mred";
    const Ladder ladder = ladder_of(records);
    const RefinementTable table = parse_refinement_table(ladder_csv(ladder, 0), "ladder.csv");
    ASSERT_EQ(table.spacing.size(), 4u);
    bool has_lift = false;
    for (const auto& column : table.columns) has_lift |= column.name == "lift [N]";
    EXPECT_TRUE(has_lift);
    EXPECT_EQ(ladder_text(ladder).find('\x1b'), std::string::npos);
    EXPECT_EQ(ladder_html(ladder).find('\x1b'), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(ladder_json(ladder))["sides"][0]["method"], "sph");
}

}  // namespace ladder_test
}  // namespace tw
