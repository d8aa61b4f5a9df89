#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "compare/compare.h"
#include "compare/reference/planing.h"
#include "tests/data_table.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace savitsky_test {

// Columns: Cv, deadrise [deg], trim [deg], lambda, beam [m], U [m/s], CL0, CLbeta, lift [N], Cf, friction, drag [N],
// D/L, keel wetted, chine wetted, centre of pressure [m]; water of 15 degrees, standard gravity.
TEST(SavitskyFormula, EqualsTheIndependentTable) {
    const std::vector<std::vector<double>> rows = number_rows("savitsky_prismatic_fixed_trim.csv");
    for (std::size_t k = 0; k < rows.size(); ++k) {
        SCOPED_TRACE(k);
        const std::vector<double>& row = rows[k];
        const PlaningState state{.beam = row[4],
                                 .deadrise = row[1] * degree,
                                 .trim = row[2] * degree,
                                 .speed = row[5],
                                 .density = 1000,
                                 .kinematic_viscosity = 1.139e-6,
                                 .gravity = 9.80665};
        const Savitsky s = savitsky(state, row[3]);
        EXPECT_NEAR(s.lift / row[8], 1, 2e-6);
        EXPECT_NEAR(s.friction_drag / row[10], 1, 2e-6);
        EXPECT_NEAR(s.drag / row[11], 1, 2e-6);
        EXPECT_NEAR(s.keel_wetted_length, row[13], 2e-6);
        EXPECT_NEAR(s.chine_wetted_length, row[14], 2e-6);
        EXPECT_NEAR(s.pressure_centre, row[15], 2e-6);
    }
    EXPECT_GE(rows.size(), 90u);
}

TEST(SavitskyFormula, HandCaseAtFixedDraft) {
    const PlaningState state{.beam = 1, .deadrise = 20 * degree, .trim = 5 * degree, .speed = 8};
    const Savitsky s = savitsky_at_draft(state, 0.2);
    EXPECT_NEAR(s.lift, 2334, 2);
    EXPECT_NEAR(s.pressure_drag, 204, 0.5);
    EXPECT_NEAR(s.friction_drag, 154, 1);
    EXPECT_NEAR(s.keel_wetted_length, 2.295, 1e-3);
    EXPECT_NEAR(s.chine_wetted_length, 0.971, 1e-3);
    EXPECT_TRUE(s.in_range);
    EXPECT_FALSE(savitsky_at_draft(state, 0.05).in_range);  // chines dry
}

// The worked example of Savitsky 1964: 60 000 lb, beam 14 ft, deadrise 10 deg, LCG 29 ft, VCG 2 ft, 40 knots. Its trim
// is 2.3 deg, with a thrust slightly off the centre of gravity and a roughness allowance.
TEST(SavitskyFormula, BalancesWeightAndMomentsOfTheWorkedExample) {
    constexpr double foot = 0.3048, pound = 4.44822;
    const PlaningState state{.beam = 14 * foot,
                             .deadrise = 10 * degree,
                             .speed = 40 * 0.514444,
                             .density = 1026,
                             .kinematic_viscosity = 1.19e-6,
                             .gravity = 9.80665};
    const PlaningMass mass{60000 * pound, 29 * foot, 2 * foot, true};
    const auto found = savitsky_free(state, mass);
    ASSERT_TRUE(found);
    const auto& [running, s] = *found;
    EXPECT_NEAR(running.trim / degree, 2.3, 0.15);
    EXPECT_NEAR(s.lift / mass.weight, 1, 1e-6);
    const double normal = s.lift / std::cos(running.trim), lever = mass.vcg - state.beam / 4 * std::tan(state.deadrise);
    EXPECT_NEAR(normal * (s.pressure_centre - mass.lcg) / (s.friction_drag * lever), 1, 1e-3);
    EXPECT_FALSE(savitsky_free(state, {60000 * pound, 60 * foot, 2 * foot, true})) << "farther ahead than six beams";
}

// What the report says of the formula beside its +-10 %.
TEST(SavitskyFormula, MeasuredLiftsLieAboveItByTheFactorsThatAreTold) {
    double least = HUGE_VAL, most = 0;
    for (const std::vector<double>& row : number_rows("planing_lift_measured.csv")) {
        const PlaningState state{.beam = row[0], .deadrise = row[1] * degree, .trim = row[3] * degree, .speed = row[2]};
        const Savitsky s = row[4] > 0 ? savitsky(state, row[4] / state.beam) : savitsky_at_draft(state, row[5]);
        EXPECT_TRUE(s.in_range) << row[2];
        least = std::min(least, row[6] / s.lift), most = std::max(most, row[6] / s.lift);
    }
    EXPECT_NEAR(least, measured_over_savitsky[0], 0.01);
    EXPECT_NEAR(most, measured_over_savitsky[1], 0.01);
}

TEST(SavitskyFormula, AtTheKeelsOfTheDraftIsThatOfTheDraft) {
    const PlaningState state{.beam = 1, .deadrise = 20 * degree, .trim = 5 * degree, .speed = 8};
    EXPECT_DOUBLE_EQ(savitsky_at_keel(state, 0.2 / std::sin(state.trim)).lift, savitsky_at_draft(state, 0.2).lift);
    EXPECT_NEAR(savitsky_at_keel(state, 2.41).lift, 2496, 1);
    EXPECT_GT(savitsky_at_keel(state, 2.48).lift, savitsky_at_keel(state, 2.36).lift);
}

TEST(PrismaticHull, DeadriseAndBeamAreReadOffTheSurface) {
    const auto hull = prismatic_hull(synthetic_run({.duration = 0.1, .frames = false}));
    ASSERT_TRUE(hull);
    EXPECT_NEAR(hull->state.deadrise / degree, 20, 1e-6);
    EXPECT_NEAR(hull->state.beam, 1, 1e-9);
    EXPECT_NEAR(savitsky_at_draft(hull->state, hull->draft).lift, 2334, 2);
}

/// The same surface of triangles cut in four, five times over, as fine as those of a run record.
Surface cut_finely(Surface surface) {
    for (int times = 0; times < 5; ++times) {
        Surface finer;
        const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
            const int first = static_cast<int>(finer.points.size());
            finer.points.insert(finer.points.end(), {a, b, c});
            finer.triangles.push_back({first, first + 1, first + 2});
        };
        for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
            const Vec3 a = surface.corner(t, 0), b = surface.corner(t, 1), c = surface.corner(t, 2);
            const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
            add(a, ab, ca), add(ab, b, bc), add(ca, bc, c), add(ab, bc, ca);
        }
        surface = std::move(finer);
    }
    return surface;
}

TEST(PrismaticHull, OneWhoseDeadriseGrowsForwardGetsNoFormulaHoweverSmallItsTriangles) {
    RunRecord r = synthetic_run({.duration = 0.1, .frames = false});
    r.hull = cut_finely(r.hull);
    ASSERT_TRUE(prismatic_hull(r));
    const Box bounds = r.hull.bounds();
    for (Vec3& x : r.hull.points)
        x.z() += 0.2 * std::abs(x.y()) * (bounds.max.x() - x.x()) / bounds.size().x();  // up to 11 degrees more
    EXPECT_FALSE(prismatic_hull(r));
}

/// Fridsma's hull A at an attitude.
RunRecord fridsma(double draft) {
    RunRecord r = synthetic_run({.duration = 0.1, .frames = false});
    r.hull = posed(make_hull("fridsma", {}), {.trim = 4 * degree, .draft = draft});
    r.numbers["speed"] = 3.985, r.numbers["trim"] = 4 * degree, r.numbers["draft"] = draft;
    r.numbers["length"] = 1.143, r.numbers["beam"] = 0.2286;
    return r;
}

// At its measured attitude the bow just dips in; what is wet behind it is a prism, and the formula gives 63.3 N
// (tests/data/planing_lift_measured.csv).
TEST(PrismaticHull, ABowThatDipsInLeavesThePrismBehindIt) {
    const auto hull = prismatic_hull(fridsma(0.0727));
    ASSERT_TRUE(hull);
    EXPECT_NEAR(hull->state.deadrise / degree, 20, 1e-6);
    EXPECT_NEAR(hull->state.beam, 0.2286, 1e-9);
    EXPECT_NEAR(savitsky_at_draft(hull->state, hull->draft).lift, 63.3, 0.1);
    EXPECT_GT(hull->bow, 0.002);
    EXPECT_LT(hull->bow, 0.015);
    EXPECT_FALSE(prismatic_hull(fridsma(0.1))) << "its bow is as deep as the prism";
    const Comparison c = compare_records({fridsma(0.078)});
    const auto lift = std::ranges::find(c.references, "lift", &Reference::quantity);
    ASSERT_NE(lift, c.references.end());
    EXPECT_NE(lift->remark.find("a bow of another shape is "), std::string::npos) << lift->remark;
    for (const ValidityCheck& check : c.checks)
        EXPECT_NE(check.name, "drag against lift times tan trim") << "its sections are not equal";
}

TEST(PrismaticHull, OtherShapesGetNoFormula) {
    RunRecord r = synthetic_run({.duration = 0.1, .frames = false});
    r.hull = posed(make_hull("wigley", {}), {.trim = 5 * degree, .draft = 0.2});
    EXPECT_FALSE(prismatic_hull(r));
    r = synthetic_run({.duration = 0.1, .frames = false});
    r.numbers["speed"] = 0;
    EXPECT_FALSE(prismatic_hull(r));
    r.hull = {};
    EXPECT_FALSE(prismatic_hull(r));
}

}  // namespace savitsky_test
}  // namespace tw
