// The first-order force of a regular wave on an upright cylinder, and whether a record's solid is one.
#include "compare/reference/vertical_cylinder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compare/metrics/regular_wave.h"
#include "record/solid_at_rest.h"
#include "record/wave_twin.h"

namespace tw::test {
namespace vertical_cylinder_test {

using std::numbers::pi;

TEST(VerticalCylinder, HasTheForceAndThePhaseOfTheTables) {
    struct Row {
        double ka, force, phase;  // F / (rho g a^2 A tanh k d), 90 degrees less the lead
    };
    // By Bessel's integrals, in another language than this code; of k a = 1 by Abramowitz & Stegun, table 9.1:
    // J1' = 0.325147, Y1' = 0.869470, 4 / |H1'| = 4.30906.
    const Row rows[] = {{0.05, 6.30372, 0.112762}, {0.3, 6.48496, 4.04322}, {0.6, 6.0256, 13.6183},
                        {1, 4.30906, 20.5038},     {2, 1.76191, -6.52249},  {3, 0.966773, -54.2447}};
    for (const Row& row : rows) {
        const double a = 0.08, k = row.ka / a, d = 0.24;
        const CylinderForce f = mac_camy_fuchs({.amplitude = 0.03, .k = k, .depth = d}, a);
        EXPECT_NEAR(f.amplitude / (1000 * 9.81 * a * a * 0.03 * std::tanh(k * d)) / row.force, 1, 1e-5) << row.ka;
        EXPECT_NEAR(90 - f.lead * 180 / pi, row.phase, 1e-3) << row.ka;
    }
}

TEST(VerticalCylinder, OfASlenderOneIsTwiceTheFroudeKrylovForce) {
    const double a = 0.001, k = 3, d = 0.5, A = 0.02;
    // 2 rho pi a^2 times the integral over the depth of the largest du/dt, g A k cosh k(z + d) / cosh k d
    EXPECT_NEAR(mac_camy_fuchs({.amplitude = A, .k = k, .depth = d}, a).amplitude /
                    (2 * 1000 * pi * a * a * 9.81 * A * std::tanh(k * d)),
                1, 1e-4);
}

/// A prism of `sides` corners about the axis at (x, y).
Surface prism(int sides, double x, double y, double low, double high, double across = 1) {
    Surface s;
    for (const double z : {low, high})
        for (int i = 0; i < sides; ++i)
            s.points.emplace_back(x + 0.08 * std::cos(2 * pi * i / sides),
                                  y + 0.08 * across * std::sin(2 * pi * i / sides), z);
    for (int i = 0; i < sides; ++i) s.triangles.push_back({i, (i + 1) % sides, sides + i});
    return s;
}
RunRecord beside(const Surface& solid) {
    RunRecord r;
    r.attributes = {{"method", "fvm"}, {"state", "finished"}};
    r.numbers = {{"wave_period", 0.8},  {"wave_length", 1}, {"wave_height", 0.06},
                 {"wave_direction", 1}, {"depth", 0.24},    {"density", 1000},
                 {"gravity", 9.81},     {"dimensions", 3},  {"mean_from", 0}};
    r.bodies.push_back({obstacle_table("pile"), solid, Vec3::Zero()});
    r.resolution = {{0.016, Box{Vec3(-2, -0.5, -0.24), Vec3(2, 0.5, 0.2)}}};
    Table& forces = r.table("forces");
    for (int i = 0; i <= 4000; ++i) {
        const std::size_t row = forces.append(0.002 * i);
        forces.set(row, "fx", "N", 3 * std::cos(2 * pi / 0.8 * 0.002 * i));
        forces.set(row, "fz", "N", 0);
    }
    return r;
}
std::vector<double> references(const RunRecord& r) {
    Comparison c;
    c.sources = {r};
    c.names = {"fvm"};
    add_regular_wave(c);
    std::vector<double> values;
    for (const Reference& reference : c.references)
        if (reference.source == "MacCamy & Fuchs 1954") values.push_back(reference.value);
    return values;
}

TEST(VerticalCylinder, IsKnownFromARecord) {
    const auto whole = upright_cylinder(beside(prism(64, 0.2, 0.1, -0.3, 0.3)));
    ASSERT_TRUE(whole);
    EXPECT_NEAR(whole->x, 0.2, 1e-9);
    EXPECT_NEAR(whole->y, 0.1, 1e-9);
    EXPECT_NEAR(whole->radius, 0.08 * (1 - std::pow(2 * pi / 64, 2) / 12), 1e-5);  // of the polygon's area
    EXPECT_FALSE(upright_cylinder(beside(prism(4, 0, 0, -0.3, 0.3)))) << "a box";
    EXPECT_FALSE(upright_cylinder(beside(prism(64, 0, 0, -0.3, 0.3, 0.7)))) << "an ellipse";
    RunRecord two = beside(prism(64, 0, 0, -0.3, 0.3));
    two.bodies.push_back(two.bodies.front());
    EXPECT_FALSE(upright_cylinder(two));
}

TEST(VerticalCylinder, HasItsReferenceWhereItStandsFromFloorToAboveTheSurface) {
    const std::vector<double> at_zero = references(beside(prism(64, 0, 0, -0.3, 0.3))),
                              behind = references(beside(prism(64, 0.1, 0, -0.3, 0.3))),
                              half = references(beside(prism(64, 0, 0.5, -0.3, 0.3)));
    ASSERT_EQ(at_zero.size(), 2);
    const CylinderForce theory = mac_camy_fuchs({.amplitude = 0.03, .k = 2 * pi, .depth = 0.24}, 0.08);
    EXPECT_NEAR(at_zero[0] / theory.amplitude, 1, 0.01);
    EXPECT_NEAR(at_zero[1], theory.lead * 180 / pi, 0.5);
    ASSERT_EQ(behind.size(), 2);
    EXPECT_NEAR(behind[1], at_zero[1] - 36, 1e-6) << "a tenth of a wave later";
    ASSERT_EQ(half.size(), 2);
    EXPECT_NEAR(half[0], at_zero[0] / 2, 1e-9);
    RunRecord with_twin = beside(prism(64, 0.1, 0, -0.3, 0.3));
    Table& level = with_twin.table(std::string(empty_twin_table));
    for (int i = 0; i <= 4000; ++i)
        level.set(level.append(0.002 * i), gauge_of_empty_twin("pile"), "m", 0.02 * std::cos(2 * pi / 0.8 * 0.002 * i));
    const std::vector<double> over_wave = references(with_twin);  // force, phase and both over the wave, in this order
    ASSERT_EQ(over_wave.size(), 4);
    EXPECT_NEAR(over_wave[2], over_wave[0] / 0.03, 1e-9);
    EXPECT_NEAR(over_wave[3], at_zero[1], 1e-9) << "over the crest at the axis, wherever that is";
    EXPECT_TRUE(references(beside(prism(64, 0, 0, -0.3, -0.1))).empty()) << "water runs over it";
    EXPECT_TRUE(references(beside(prism(64, 0, 0, -0.1, 0.3))).empty()) << "and under it";
    RunRecord back = beside(prism(64, 0, 0, -0.3, 0.3));
    back.numbers["wave_direction"] = -1;
    EXPECT_NEAR(std::abs(std::remainder(references(back)[1] - at_zero[1], 360)), 180, 1e-6);
}

}  // namespace vertical_cylinder_test
}  // namespace tw::test
