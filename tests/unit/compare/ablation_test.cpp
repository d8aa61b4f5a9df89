#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "compare/ablate/ablation.h"
#include "compare/verdict/left_out.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace ablation_test {

using Seen = AblationChange::Seen;

Quantity quantity(const std::string& name, double value, double half_width) {
    Quantity q;
    q.name = name, q.label = "the " + name, q.unit = "N";
    MeanValue m;
    m.known = std::isfinite(value);
    m.value = value, m.half_width = half_width;
    if (!m.known) m.why_not = "record too short";
    q.values = {m};
    return q;
}

std::vector<EffectChoice> plan(bool tension, bool viscosity = false) {
    EffectChoice t, v;
    t.name = "surface_tension", t.on = tension, t.cost = 0.2;
    t.influence = "drag: 1e-05 %; lift: 2e-05 %; splash: drops below 1 mm; a remark";
    v.name = "viscosity", v.on = viscosity, v.cost = 0.25;
    v.influence = "drag: about 3 N of friction; lift: below 1 %; splash: below 1 %";
    return {v, t};
}

AblationSide side(double drag, double half_width, double processor, std::vector<EffectChoice> effects) {
    AblationSide s;
    s.method = "sph";
    s.quantities = {quantity("drag", drag, half_width)};
    s.processor = processor, s.steps = 1000;
    s.effects = std::move(effects);
    return s;
}

AblationRun run(const std::string& effect, AblationSide s, std::size_t against = 0) {
    AblationRun r{effect.empty() ? "base" : effect + " on", effect, against};
    r.sides = {std::move(s)};
    return r;
}

Ablation ablation_of(double before, double U_before, double after, double U_after) {
    return build_ablation("prism", {run("", side(before, U_before, 50, plan(false))),
                                    run("surface_tension", side(after, U_after, 55, plan(true)))});
}
const AblationChange& only(const Ablation& a) { return a.methods.at(0).rows.at(0).changes.at(0); }

TEST(Ablation, AChangeIsInPerCentOfTheValueBeforeWithBothIntervalsCombined) {
    const Ablation a = ablation_of(200, 3, 210, 4);
    const AblationChange& c = only(a);
    EXPECT_DOUBLE_EQ(c.difference, 10);
    EXPECT_DOUBLE_EQ(c.interval, 5);  // sqrt(3^2 + 4^2)
    EXPECT_DOUBLE_EQ(c.per_cent, 5);
    EXPECT_DOUBLE_EQ(c.per_cent_interval, 2.5);
    EXPECT_EQ(c.seen, Seen::seen);
    EXPECT_EQ(change_text(c), "+5.0 ± 2.5 %");
}

TEST(Ablation, WithinTheIntervalsNothingIsSeenWhateverTheSign) {
    EXPECT_EQ(only(ablation_of(200, 3, 204.9, 4)).seen, Seen::nothing);
    EXPECT_EQ(only(ablation_of(200, 3, 195.1, 4)).seen, Seen::nothing);
    EXPECT_EQ(only(ablation_of(200, 3, 194.9, 4)).seen, Seen::seen);
    EXPECT_EQ(only(ablation_of(-200, 3, -210, 4)).per_cent, 5);  // more of a negative value
    EXPECT_EQ(only(ablation_of(-200, 3, -210, 4)).difference, -10);
}

TEST(Ablation, WithoutAnIntervalNothingIsClaimed) {
    EXPECT_EQ(only(ablation_of(200, 0, 240, 4)).seen, Seen::no_interval);
    EXPECT_EQ(change_text(only(ablation_of(200, 0, 240, 0))), "+20 %");
    EXPECT_EQ(only(ablation_of(200, 0, 200, 0)).seen, Seen::unchanged);
    const AblationChange unknown = only(ablation_of(200, 3, std::nan(""), 4));
    EXPECT_EQ(unknown.seen, Seen::not_known);
    EXPECT_EQ(unknown.remark, "after: record too short");
    EXPECT_EQ(change_text(unknown), "–");
}

TEST(Ablation, AValueNearZeroIsMeasuredByItsScale) {
    std::vector<AblationRun> runs{run("", side(0.5, 1, 50, plan(false))),
                                  run("surface_tension", side(1.5, 1, 50, plan(true)))};
    runs[0].sides[0].quantities[0].scale = 100;
    EXPECT_DOUBLE_EQ(only(build_ablation("prism", runs)).per_cent, 1);
}

TEST(Ablation, CostStandsBesideWhatThePlanSaid) {
    const AblationRow row = ablation_of(200, 3, 210, 4).methods[0].rows[0];
    EXPECT_NEAR(row.cost, 10, 1e-9);  // 50 to 55
    EXPECT_NEAR(row.predicted_cost, 20, 1e-9);
    EXPECT_NEAR(row.steps, 0, 1e-9);
    EXPECT_NEAR(predicted_cost_change(plan(true, true), plan(false, true)), 100 * (1 / 1.2 - 1), 1e-9);
    EXPECT_NEAR(predicted_cost_change(plan(true, true), plan(false, false)), 100 * (1 / 1.5 - 1), 1e-9);
    std::vector<AblationRun> mesh{run("", side(200, 3, 50, plan(false))),
                                  run("surface_tension", side(210, 4, 55, plan(true)))};
    for (AblationRun& r : mesh) r.sides[0].method = "fvm";
    EXPECT_TRUE(std::isnan(build_ablation("prism", mesh).methods[0].rows[0].predicted_cost));  // particles only
}

TEST(Ablation, ThePlansSentenceIsTakenApart) {
    const std::string said = plan(false)[1].influence;
    EXPECT_EQ(influence_on("drag", said), "1e-05 %");
    EXPECT_EQ(influence_on("lift", said), "2e-05 %");
    EXPECT_EQ(influence_on("splash_p95", said), "drops below 1 mm");
    EXPECT_EQ(influence_on("wetted_length", said), "");
    EXPECT_EQ(influence_on("drag", "no word of it"), "");
    EXPECT_EQ(influence_on("drag", ""), "");
    EXPECT_EQ(influence_on("lift", "lift: last"), "last");
    EXPECT_EQ(only(ablation_of(200, 3, 210, 4)).predicted, "1e-05 %");
}

TEST(Ablation, AnEffectThatNeedsAnotherIsHeldAgainstTheRunThatHasIt) {
    std::vector<AblationRun> runs{run("", side(200, 1, 50, plan(false))),
                                  run("viscosity", side(300, 1, 60, plan(false, true))),
                                  run("no_slip", side(270, 1, 60, plan(false, true)), 1)};
    const Ablation a = build_ablation("prism", runs);
    ASSERT_EQ(a.methods[0].rows.size(), 2u);
    EXPECT_DOUBLE_EQ(a.methods[0].rows[1].changes[0].per_cent, -10);  // of 300, not of 200
    EXPECT_NE(ablation_text(a).find("no_slip on, compared with viscosity on"), std::string::npos) << ablation_text(a);
    runs[1].sides.clear(), runs[1].why_not = "blew up";
    const Ablation without = build_ablation("prism", runs);
    EXPECT_TRUE(without.methods[0].rows.empty());
    EXPECT_EQ(without.runs[2].why_not, "there is no run \"viscosity on\" to compare it with");
    runs[1].against = 2;
    EXPECT_THROW(build_ablation("prism", runs), InputError);
}

TEST(Ablation, AMissingRunIsReportedAndTheOthersCount) {
    AblationRun failed{"air", "air"};
    failed.why_not = "cannot be switched: <script>alert(1)</script>";
    const Ablation a = build_ablation("prism <b>& co</b>", {run("", side(200, 3, 50, plan(false))), failed,
                                                            run("surface_tension", side(210, 4, 55, plan(true)))});
    EXPECT_EQ(a.methods[0].rows.size(), 1u);
    EXPECT_NE(ablation_text(a).find("| air      | cannot be switched"), std::string::npos) << ablation_text(a);
    const std::string page = ablation_html(a);
    EXPECT_NE(page.find("cannot be switched: &lt;script&gt;"), std::string::npos);
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(page.find("<b>&"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(ablation_json(a))["runs"][1]["why_not"], failed.why_not);
    AblationRun base = failed;
    EXPECT_THROW(build_ablation("prism", {base}), InputError);
    EXPECT_THROW(build_ablation("prism", {}), InputError);
}

TEST(Ablation, NothingFromOutsideBecomesMarkup) {
    std::vector<AblationRun> runs{run("", side(200, 3, 50, plan(false))),
                                  run("surface_tension", side(210, 4, 55, plan(true)))};
    for (AblationRun& r : runs) {
        r.name += " <i>x</i>";
        r.sides[0].method = "<i>sph</i>";
        r.sides[0].quantities[0].label = "<i>drag</i>";
        r.sides[0].quantities[0].unit = "<i>N</i>";
        r.sides[0].effects[1].influence = "drag: <i>much</i>; lift: none; splash: none";
    }
    const Ablation a = build_ablation("<i>prism</i>", runs);
    EXPECT_EQ(ablation_html(a).find("<i>"), std::string::npos);
    EXPECT_NE(ablation_html(a).find("&lt;i&gt;much"), std::string::npos);
    runs[1].name = "a | b\nc\x1b[2J";
    const std::string text = ablation_text(build_ablation("prism", runs));
    EXPECT_NE(text.find("| a \\| b c?[2J | base"), std::string::npos) << text;
}

TEST(Ablation, ItsTableHasARowForEachQuantityAndTheCost) {
    const std::string csv = ablation_csv(ablation_of(200, 3, 210, 4));
    EXPECT_NE(csv.find("surface_tension on,base,sph,drag,N,200,3,210,4,5,2.5,seen,1e-05 %\n"), std::string::npos)
        << csv;
    EXPECT_NE(csv.find("surface_tension on,base,sph,cost,s/s,50,,55,,10,,,20\n"), std::string::npos) << csv;
}

TEST(Ablation, TheOverviewHoldsForcesOrTheProbesOfATank) {
    EXPECT_EQ(headline_of(ablation_of(200, 3, 210, 4).methods[0]), std::vector<std::string>{"drag"});
    std::vector<AblationRun> tank{run("", side(200, 3, 50, plan(false))),
                                  run("surface_tension", side(210, 4, 55, plan(true)))};
    for (AblationRun& r : tank) {
        r.sides[0].quantities = {quantity("pressure:floor", r.effect.empty() ? 1000 : 900, 0)};
        r.sides[0].quantities[0].judged = false;  // a highest value is shown, not judged
    }
    const Ablation a = build_ablation("tank", tank);
    EXPECT_EQ(headline_of(a.methods[0]), std::vector<std::string>{"pressure:floor"});
    EXPECT_EQ(change_text(only(a)), "−10 %");
}

TEST(Ablation, ARecordsValuesAndItsCostPerSimulatedSecond) {
    RunRecord r = synthetic_run({.frames = false});
    r.numbers["duration"] = 2;
    r.phases = {{"particles", 9, 9}, {"solving", 30, 50}, {"output", 9, 9}};
    r.steps = 3000;
    r.effects = plan(true);
    const AblationSide s = ablation_side(r);
    EXPECT_EQ(s.method, "sph");
    EXPECT_DOUBLE_EQ(s.processor, 25);
    EXPECT_DOUBLE_EQ(s.steps, 1500);
    EXPECT_EQ(s.effects.size(), 2u);
    const auto lift = std::ranges::find(s.quantities, "lift", &Quantity::name);
    ASSERT_NE(lift, s.quantities.end());
    EXPECT_NEAR(lift->values.at(0).value, 2800, 30);
    // Twenty per cent more lift is seen through the record's noise, another seed of the same flow is not.
    const auto changed = [&](const SyntheticRun& o) {
        RunRecord after = synthetic_run(o);
        after.effects = plan(false);
        const Ablation a = build_ablation("prism", {run("", s), run("surface_tension", ablation_side(after))});
        const auto& changes = a.methods[0].rows[0].changes;
        return *std::ranges::find(changes, "lift", &AblationChange::name);
    };
    EXPECT_EQ(changed({.lift = 3360, .seed = 2, .frames = false}).seen, Seen::seen);
    EXPECT_NEAR(changed({.lift = 3360, .seed = 2, .frames = false}).per_cent, 20, 2);
    EXPECT_EQ(changed({.seed = 2, .frames = false}).seen, Seen::nothing);
}

}  // namespace ablation_test
}  // namespace tw
