#include "compare/verdict/left_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/report/comparison_tables.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace left_out_test {

EffectChoice effect(const std::string& name, bool on, const std::string& influence) {
    return {.name = name, .on = on, .forced = false, .reason = {}, .influence = influence};
}

/// A planing hull's plan.
RunRecord run(bool friction_line) {
    RunRecord r;
    r.effects = {effect("viscosity", false, "drag: about 120 N of friction (ITTC 1957), left out; lift: below 1 %"),
                 effect("no_slip", false, "drag: all of the friction; lift: below 1 %"),
                 effect("friction", friction_line, "drag: about 120 N, left out; lift: none"),
                 effect("turbulence", false, "drag: 4 % of the pressure drag (measured); lift: 0.7 % (measured)"),
                 effect("air", false, "drag: 10 % (dry topsides); lift: 3 to 5 % (the same); splash: drops are slowed"),
                 effect("surface_tension", false, "drag: 4.9e-05 %; lift: 4.9e-05 %; splash: holds small drops"),
                 effect("gravity", true, "drag: 35 %; lift: 35 %"),
                 effect("ventilation", false, "drag: 60 % and more on round bodies; lift: the same"),
                 effect("tension_control", false, "drag: not measured; lift: not measured")};
    return r;
}

Quantity quantity(const std::string& name, double value, double interval) {
    Quantity q;
    q.name = name, q.label = name, q.unit = "N";
    MeanValue m;
    m.known = true, m.value = value, m.half_width = m.uncertainty = interval;
    q.values = {m};
    return q;
}

std::string names(const std::vector<LeftOut>& all) {
    std::string text;
    for (const LeftOut& l : all) text += l.name + (std::isfinite(l.bound) ? "" : "?") + " ";
    return text;
}

TEST(LeftOut, IsWhatIsOffAndMattersToTheQuantity) {
    const auto of = [](const std::string& name, bool friction_line) {
        const Quantity q = quantity(name, 400, 30);
        return names(left_out_of(q, q.values[0], run(friction_line)));
    };
    EXPECT_EQ(of("total_drag", true), "turbulence air ventilation? ");
    EXPECT_EQ(of("total_drag", false), "viscosity turbulence air ventilation? ");
    EXPECT_EQ(of("lift", true), "turbulence air ventilation? ");
    EXPECT_EQ(of("splash_sheet_height", true), "air? surface tension? ");
    EXPECT_EQ(of("wetted_length", true), "");
    EXPECT_EQ(names(left_out_of(quantity("lift", 400, 30), MeanValue(), run(true))), "") << "of no value";
    RunRecord section = run(true);
    section.effects.clear();
    section.numbers["dimensions"] = 2;
    const Quantity q = quantity("lift", 400, 30);
    EXPECT_EQ(names(left_out_of(q, q.values[0], section)), "the third dimension? ");
}

TEST(LeftOut, WithABoundIsInTheOuterInterval) {
    const Quantity drag = quantity("total_drag", 400, 30), lift = quantity("lift", -1000, 30);
    EXPECT_NEAR(outer_half_width(drag, drag.values[0], run(true)), std::sqrt(30 * 30 + 16 * 16 + 40 * 40), 1e-9);
    EXPECT_NEAR(outer_half_width(drag, drag.values[0], run(false)), std::sqrt(30 * 30 + 120 * 120 + 16 * 16 + 40 * 40),
                1e-9);
    EXPECT_NEAR(outer_half_width(lift, lift.values[0], run(true)), std::sqrt(30 * 30 + 7 * 7 + 50 * 50), 1e-9);
    Quantity none = drag;
    none.values[0].uncertainty = nan, none.values[0].no_uncertainty = "not converged";
    EXPECT_TRUE(std::isnan(outer_half_width(none, none.values[0], run(true))));
    const RunRecord all_solved;
    EXPECT_TRUE(std::isnan(outer_half_width(drag, drag.values[0], all_solved)));
}

/// A dam break's plan, with numbers.
RunRecord dam_break(const std::string& method) {
    RunRecord r;
    r.attributes["method"] = method;
    r.numbers = {{"released_height", 0.3}, {"gravity", 9.81}, {"dimensions", 3}};
    EffectChoice friction = effect("viscosity", false, "drag: wall friction; lift: none; splash: none"),
                 sound = effect("compressibility", false, "drag: 1 %; lift: 1 %; splash: 1 %");
    friction.bounds = {{.of = "arrival", .above = 0.14},
                       {.of = "pressure", .below = 0.35, .above = 0.43},
                       {.of = "peak", .below = 0.35, .above = 0.43},
                       {.of = "height", .below = 0.23, .above = 0.14},
                       {.of = "impulse", .below = 0.23}};
    for (const char* kind : {"drag", "lift", "pressure", "motion"})
        sound.bounds.push_back({.of = kind, .below = 0.01, .above = 0.01, .elements = "particles"});
    r.effects = {friction, sound, effect("gravity", false, "drag: 50 %; lift: 50 %"),
                 effect("shifting", false, "drag: not measured; lift: -10 %")};
    return r;
}

std::pair<double, double> outer(const std::string& name, double value, double interval, const RunRecord& r,
                                const std::string& unit = "-", double reading = 0) {
    Quantity q = quantity(name, value, interval);
    q.unit = unit;
    q.values[0].reading_below = q.values[0].reading_above = reading, q.values[0].reading_of = "the reading";
    const OuterInterval o = outer_interval(q, q.values[0], r);
    return {o.below, o.above};
}

TEST(LeftOut, EveryKindOfQuantityGetsThePlansNumbersOnTheirSides) {
    const RunRecord mesh = dam_break("fvm");
    const auto near = [](std::pair<double, double> sides, double below, double above, const char* what) {
        EXPECT_NEAR(sides.first, below, 1e-9 + 1e-6 * below) << what;
        EXPECT_NEAR(sides.second, above, 1e-9 + 1e-6 * above) << what;
    };
    near(outer("pressure_mean:S1", 2000, 100, mesh), std::hypot(100, 700), std::hypot(100, 860), "mean pressure");
    near(outer("pressure_peak:S1", 6000, 300, mesh), std::hypot(300, 2100), std::hypot(300, 2580), "peak");
    near(outer("pressure_p99:S1", 6000, 300, mesh), std::hypot(300, 2100), std::hypot(300, 2580), "99 %");
    near(outer("height_peak:H", 0.2, 0.01, mesh), std::hypot(0.01, 0.046), std::hypot(0.01, 0.028), "height");
    near(outer("load_impulse_x", 12, 1, mesh), std::hypot(1, 2.76), 1, "impulse");
    near(outer("load_impulse_x", -12, 1, mesh), 1, std::hypot(1, 2.76), "less of a negative one is above it");
    near(outer("load_peak_x", 30, 1, mesh), std::hypot(1, 10.5), std::hypot(1, 12.9), "largest force");
    near(outer("body_impulse:b", 12, 1, mesh), std::hypot(1, 2.76), 1, "impulse on a body");
    // Friction makes a front late; gate and clock are known to either side.
    const double gate = 0.13 * std::sqrt(0.3 / 9.81);
    for (const char* name : {"pressure_arrival:S1", "height_arrival:H", "body_arrival:b"})
        near(outer(name, 0.4, 0.01, mesh, "s"), std::hypot(0.01, gate), std::sqrt(1e-4 + 0.056 * 0.056 + gate * gate),
             name);
    // Only the particles are charged with their own compressibility.
    near(outer("body_depth:b", 0.3, 0.02, dam_break("sph")), std::hypot(0.02, 0.003), std::hypot(0.02, 0.003),
         "motion");
    EXPECT_TRUE(std::isnan(outer("body_depth:b", 0.3, 0.02, mesh).first)) << "nothing is left out";
    // What reading it leaves open, to both sides.
    near(outer("height_peak:H", 0.2, 0.01, mesh, "m", 0.02), std::sqrt(1e-4 + 0.046 * 0.046 + 4e-4),
         std::sqrt(1e-4 + 0.028 * 0.028 + 4e-4), "half a spacing");
    RunRecord corner = mesh;
    corner.effects[0].bounds.push_back({.of = "pressure:S1", .below = 0.35, .above = 0});
    near(outer("pressure_mean:S1", 2000, 100, corner), std::hypot(100, 700), 100,
         "a gauge of which the plan knows the sign");
    near(outer("pressure_mean:S4", 2000, 100, corner), std::hypot(100, 700), std::hypot(100, 860), "and another");
    EXPECT_TRUE(std::isnan(outer("height_mean:H", 0.2, 0.01, mesh).first)) << "a mean level is that of as much water";
    near(outer("height_mean:H", 0.2, 0.01, mesh, "m", 0.02), std::hypot(0.01, 0.02), std::hypot(0.01, 0.02), "level");
    EXPECT_TRUE(std::isnan(outer("wetted_length", 1, 0.1, dam_break("sph")).first)) << "no plan speaks of it";
}

TEST(LeftOut, GravityThatTheSceneSwitchesOffIsNotCharged) {
    const RunRecord jet = dam_break("sph");
    for (const char* name : {"drag", "lift", "load_impulse_x", "load_peak_z"}) {
        const Quantity q = quantity(name, 100, 1);
        for (const LeftOut& l : left_out_of(q, q.values[0], jet)) EXPECT_NE(l.name, "gravity") << name;
    }
    // The numerics of the particles are no shortcoming of a mesh.
    const Quantity lift = quantity("lift", 100, 1);
    EXPECT_EQ(names(left_out_of(lift, lift.values[0], dam_break("sph"))), "compressibility shifting ");
    EXPECT_EQ(names(left_out_of(lift, lift.values[0], dam_break("fvm"))), "");
}

TEST(LeftOut, TheGateOpensOnlyWhereWaterIsLetGo) {
    RunRecord r = dam_break("fvm");
    r.effects.clear();
    Quantity q = quantity("height_arrival:H", 0.4, 0.01);
    q.unit = "s";
    EXPECT_EQ(names(left_out_of(q, q.values[0], r)), "the gate ");
    EXPECT_NEAR(outer_half_width(q, q.values[0], r), std::hypot(0.01, 0.13 * std::sqrt(0.3 / 9.81)), 1e-9);
    r.numbers.erase("released_height");
    EXPECT_TRUE(std::isnan(outer_half_width(q, q.values[0], r)));
    q.values[0].not_resolved = "sound";
    r.numbers["released_height"] = 0.3;
    EXPECT_TRUE(std::isnan(outer_half_width(q, q.values[0], r))) << "of what is not judged";
}

TEST(LeftOut, StandsInOneLineAndInATableOfTheTerminal) {
    RunRecord a = synthetic_run({.method = "sph", .frames = false}),
              b = synthetic_run({.method = "fvm", .seed = 2, .frames = false});
    EXPECT_EQ(left_out_text(compare_records({a, b})), "");
    a.effects = b.effects = run(true).effects;
    const Comparison c = compare_records({a, b});
    const std::string line = left_out_text(c), text = summary_text(c);
    EXPECT_NE(line.find("turbulence (drag 4 % of the pressure drag, lift 0.7 %)"), std::string::npos) << line;
    EXPECT_NE(line.find("air (drag 10 %, lift 3 to 5 %)"), std::string::npos) << line;
    EXPECT_NE(text.find("Not in these intervals"), std::string::npos) << text;
    EXPECT_NE(text.find("turbulence (0.7 %), air (3 to 5 %), ventilation (the same)"), std::string::npos) << text;
}

TEST(LeftOut, TheTableNamesEachOnceAndWhoAloneLeavesItOut) {
    Comparison c;
    c.names = {"sph", "fvm"};
    c.sources = {run(true), run(true)};
    c.sources[0].attributes["method"] = "sph", c.sources[1].attributes["method"] = "fvm";
    std::ranges::find(c.sources[1].effects, "air", &EffectChoice::name)->on = true;
    Quantity q = quantity("lift", 400, 30);
    q.values.push_back(q.values[0]);
    c.quantities = {q};
    const ReportTable table = left_out_table(c);
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0].cells[2].text, "turbulence (0.7 %), air (3 to 5 %) by SPH alone, ventilation (the same)");
}

}  // namespace left_out_test
}  // namespace tw
