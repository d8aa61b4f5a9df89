#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "compare/sweep/sweep.h"

namespace tw {
namespace sweep_test {

MeanValue mean(double value, double half_width) {
    MeanValue m;
    m.known = true;
    m.value = value, m.half_width = half_width;
    return m;
}

SweepMember member(const std::string& name, double a, double b) {
    Quantity q;
    q.name = "lift", q.label = "Lift", q.unit = "N";
    q.values = {mean(a, 1), mean(b, 2)};
    q.verdict = Verdict::differ;
    SweepMember m;
    m.name = name, m.report = name + "/report.html";
    m.methods = {"sph", "fvm"};
    m.quantities = {q};
    m.discretisation_from = "the coarser runs of one";
    return m;
}

TEST(Sweep, BiasAndScatterAreThoseOfTheLogarithmOfTheRatio) {
    const Sweep s = build_sweep("set", {member("one", 100, 110), member("two", 1000, 1210), member("three", 5, 5)});
    ASSERT_EQ(s.summaries.size(), 1u);
    const double l = std::log(1.1);
    EXPECT_NEAR(s.summaries[0].bias, l, 1e-12);     // (l + 2 l + 0)/3
    EXPECT_NEAR(s.summaries[0].scatter, l, 1e-12);  // of l, 2 l, 0
    EXPECT_NEAR(s.summaries[0].interval, 4.3027 * l / std::sqrt(3), 1e-4 * l);
}

TEST(Sweep, OfThreeMethodsEveryTwoHaveTheirBias) {
    SweepMember three = member("one", 100, 110);
    three.methods.push_back("tank");
    Quantity& lift = three.quantities[0];
    lift.values.push_back(mean(121, 1));
    lift.pairs = {{.a = 0, .b = 1}, {.a = 0, .b = 2}, {.a = 1, .b = 2}};
    const Sweep s = build_sweep("set", {three, member("two", 1, 2)});
    ASSERT_EQ(s.summaries.size(), 3u);
    EXPECT_NEAR(s.summaries[0].bias, std::log(1.1), 1e-12);
    EXPECT_NEAR(s.summaries[1].bias, 2 * std::log(1.1), 1e-12);
    EXPECT_NEAR(s.summaries[2].bias, std::log(1.1), 1e-12);
    EXPECT_FALSE(s.members[1].why_not.empty());  // it lacks the third
    EXPECT_NE(sweep_text(s).find("tank over interFoam"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(sweep_json(s))["quantities"][1]["methods"], nlohmann::json({"sph", "tank"}));
    EXPECT_NE(sweep_csv(s).find(",fvm,tank\n"), std::string::npos);
}

TEST(Sweep, FactorsThatNobodyWouldReadAreBounds) {
    EXPECT_EQ(ratio_text(std::log(1.5)), "+50 %");
    EXPECT_EQ(ratio_text(std::log(20)), "× 20");
    EXPECT_EQ(ratio_text(19), "more than × 1000");
    EXPECT_EQ(ratio_text(-22), "less than × 0.001");
}

TEST(Sweep, TwiceAndHalfCancel) {
    EXPECT_NEAR(build_sweep("set", {member("one", 1, 2), member("two", 2, 1)}).summaries[0].bias, 0, 1e-12);
}

TEST(Sweep, AFailedSceneIsReportedAndTheOthersCount) {
    SweepMember failed;
    failed.name = "holed <b>hull</b>", failed.why_not = "hull.stl: 12 open edges";
    const Sweep s = build_sweep("set", {failed, member("good", 100, 104)});
    EXPECT_EQ(s.summaries[0].points.size(), 1u);
    EXPECT_TRUE(std::isnan(s.summaries[0].scatter));  // one scene has none
    EXPECT_NE(sweep_text(s).find("12 open edges"), std::string::npos);
    EXPECT_NE(sweep_html(s).find("12 open edges"), std::string::npos);
    EXPECT_EQ(sweep_html(s).find("<b>hull"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(sweep_json(s))["scenes"][0]["why_not"], "hull.stl: 12 open edges");
}

TEST(Sweep, ValuesWithoutALogarithmAreLeftOutAndCounted) {
    const Sweep s = build_sweep("set", {member("good", 100, 104), member("against", -3, 5), member("zero", 0, 5)});
    EXPECT_EQ(s.summaries[0].points.size(), 1u);
    EXPECT_EQ(s.summaries[0].left_out, 2u);
    EXPECT_NEAR(build_sweep("set", {member("both", -3, -6)}).summaries[0].bias, std::log(2), 1e-12);
}

TEST(Sweep, OfSeveralSpeedsEveryHullHasItsCurves) {
    const auto at = [](double speed, const std::string& series) {
        SweepMember m = member(fmt::format("{} m/s", speed), 100 * speed, 110 * speed);
        m.speed = {series, speed};
        return m;
    };
    const auto page = [](std::vector<SweepMember> members) {
        return sweep_html(build_sweep("set", std::move(members)));
    };
    EXPECT_EQ(page({at(4, "slow")}).find("Over the speed"), std::string::npos) << "one speed is no curve";
    EXPECT_EQ(page({at(4, "a"), at(5, "b")}).find("Over the speed"), std::string::npos) << "two hulls are no curve";
    const std::string two = page({at(6, "a"), at(4, "a"), at(5, "a"), at(4, "b"), at(5, "b")});
    const auto curves = two.find("Over the speed");
    ASSERT_NE(curves, std::string::npos);
    EXPECT_NE(two.find("Lift, a", curves), std::string::npos);
    EXPECT_NE(two.find("Lift, b", curves), std::string::npos);
    EXPECT_NE(two.find("data-x=\"speed [m/s]\"", curves), std::string::npos);
}

TEST(Sweep, TheTableOverTheSpeedHasMethodsAndFormulasAndNeedsOneMethodOnly) {
    const auto at = [](double speed, bool alone) {
        SweepMember m = member(fmt::format("{} m/s", speed), 100 * speed, 110 * speed);
        m.quantities[0].name = "running_trim", m.quantities[0].label = "Running trim", m.quantities[0].unit = "deg";
        m.speed = {"", speed};
        if (alone) m.methods = {"sph"}, m.quantities[0].values.pop_back();
        if (speed > 4) m.references = {{"running_trim", "deg", "Savitsky 1964", 3, 0.3, ""}};
        return m;
    };
    const std::string both = sweep_text(build_sweep("set", {at(5, false), at(4, false), at(6, false)}));
    const auto row = [](const std::string& text, const std::string& by) {
        const auto begin = text.find("| Running trim | deg  | " + by);
        return begin == text.npos ? text : text.substr(begin, text.find('\n', begin) - begin);
    };
    EXPECT_LT(both.find("4 m/s |"), both.find("5 m/s |")) << both;
    EXPECT_NE(row(both, "SPH").find("400.0 ± 1.0 |"), std::string::npos) << row(both, "SPH");
    EXPECT_NE(row(both, "interFoam").find("660.0 ± 2.0 |"), std::string::npos) << row(both, "interFoam");
    EXPECT_NE(row(both, "Savitsky 1964").find("– | 3.00 ± 0.30 | 3.00 ± 0.30 |"), std::string::npos)
        << row(both, "Savitsky 1964");
    const Sweep alone = build_sweep("set", {at(4, true), at(5, true)});
    EXPECT_NE(row(sweep_text(alone), "SPH").find("400.0 ± 1.0 |"), std::string::npos) << sweep_text(alone);
    const std::string page = sweep_html(alone);
    EXPECT_NE(page.find("<a href=\"4 m/s/report.html\">"), std::string::npos);
    EXPECT_NE(page.find("aria-label=\"Running trim"), std::string::npos);
}

TEST(Sweep, AllFailedIsStillAReport) {
    SweepMember failed;
    failed.name = "one", failed.why_not = "no";
    EXPECT_NE(sweep_html(build_sweep("set", {failed})).find("no comparison"), std::string::npos);
    EXPECT_THROW(build_sweep("set", {}), InputError);
}

TEST(Sweep, ItsTableHasARowForEachSceneAndQuantity) {
    const std::string csv = sweep_csv(build_sweep("set", {member("a,b", 100, 110), member("=1+1", 3, 4)}));
    EXPECT_NE(csv.find("\"a,b\",lift,N,100,110,1,2,differ,the coarser runs of one\n"), std::string::npos) << csv;
    EXPECT_EQ(csv.find("\n=1"), std::string::npos);
}

TEST(Sweep, EverySceneSaysWhereItsDiscretisationErrorIsFrom) {
    SweepMember bare = member("bare", 100, 110);
    bare.discretisation_from.clear();
    bare.quantities[0].verdict = Verdict::not_estimated;
    SweepMember wide = member("wide", 100, 104);
    wide.quantities[0].values[0].discretisation = 8, wide.quantities[0].values[0].uncertainty = 9;
    wide.quantities[0].interval = 9.5;
    const Sweep s = build_sweep("set", {wide, bare});
    EXPECT_EQ(s.summaries[0].points[0].Ua, 9);  // all of it
    EXPECT_EQ(s.summaries[0].points[1].Ua, 1);  // the scatter is all that is known
    for (const std::string& out : {sweep_text(s), sweep_html(s)}) {
        EXPECT_NE(out.find("the coarser runs of one"), std::string::npos);
        EXPECT_NE(out.find("not estimated"), std::string::npos);
        EXPECT_NE(out.find("+4.0 ± 9.5 %"), std::string::npos) << out;
    }
}

TEST(Sweep, OfSeveralWaveLengthsResponsesHaveCurvesWithWhatWasMeasured) {
    const auto in_waves = [](double length, double measured) {
        SweepMember m = member(fmt::format("waves of {} m", length), length, 2 * length);
        m.quantities[0].name = "heave_response:hull",
        m.quantities[0].label = "Heave of the hull over the wave's height", m.quantities[0].unit = "-";
        m.wave_length = {"", length}, m.speed = {m.name, 4};
        Reference tank{"heave_response:hull", "-", "the measured value (Fridsma 1969)", measured, 0, ""};
        tank.measured = true;
        m.references = {tank};
        return m;
    };
    const Sweep sweep = build_sweep("set", {in_waves(4, 1.23), in_waves(2, 0.84), in_waves(3, 1.18)});
    const std::string text = sweep_text(sweep);
    ASSERT_NE(text.find("Over the wave length"), std::string::npos) << text;
    EXPECT_EQ(text.find("Over the speed"), std::string::npos) << "they differ in the wave alone";
    EXPECT_LT(text.find("2 m |"), text.find("3 m |")) << text;
    EXPECT_NE(text.find("|    0.8400 |     1.180 |     1.230 |"), std::string::npos) << text;
    EXPECT_NE(text.find("| 4.0 ± 2.0 | 6.0 ± 2.0 | 8.0 ± 2.0 |"), std::string::npos) << text;
    EXPECT_NE(sweep_html(sweep).find("data-x=\"wave length [m]\""), std::string::npos);
}

}  // namespace sweep_test
}  // namespace tw
