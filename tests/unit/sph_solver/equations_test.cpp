// The terms with Real = float, for one pair, and the plain functions that the host calls.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sph_solver/equations/edge_release.h"
#include "sph_solver/equations/level_pair.h"
#include "sph_solver/equations/renormalisation.h"
#include "sph_solver/equations/shifting.h"
#include "sph_solver/equations/smagorinsky.h"
#include "sph_solver/equations/surface_tension.h"
#include "sph_solver/equations/tension_control.h"
#include "sph_solver/equations/viscosity.h"
#include "sph_solver/equations/wall_completeness.h"
#include "sph_solver/equations/wall_pressure.h"
#include "sph_solver/equations/water_completeness.h"

namespace tw {
namespace equations_test {

TEST(ShiftStep, GoesFromTheCrowdAndNoFurtherThanATwentiethOfTheSpacing) {
    const double dt = 1e-3, h = 0.15, dp = 0.1;
    const ShiftStep step(1, dt, h, dp);
    const auto small = step.of(0.6f, 0, -0.2f);  // neighbours, weighted, lie towards +x and -z
    EXPECT_DOUBLE_EQ(small.x.x, -dt * h * double(0.6f));
    EXPECT_DOUBLE_EQ(small.x.z, dt * h * double(0.2f));
    EXPECT_EQ(small.x.y, 0);
    const auto large = step.of(3e5f, -4e5f, 0);
    EXPECT_NEAR(large.x.x, -0.05 * dp * 0.6, 1e-12);
    EXPECT_NEAR(large.x.y, 0.05 * dp * 0.8, 1e-12);
    EXPECT_NEAR(large.length2, 0.05 * dp * 0.05 * dp, 1e-15);
}

TEST(Shifting, KeepsWhatGoesAlongTheSurface) {
    const V3<float> N{0, 0, 2};
    V3<float> s{1, -2, 3};
    keep_along_surface(N, dot(N, N), s);
    EXPECT_EQ(s.x, 1);
    EXPECT_EQ(s.y, -2);
    EXPECT_EQ(s.z, 0);
    s = {1, -2, 3};
    keep_along_surface(V3<float>{}, 0, s);  // no surface near
    EXPECT_EQ(s.z, 3);
}

TEST(WallCompleteness, CompressionBeginsAtTheTouchSupportAndIsFullAtOne) {
    const WallCompleteness from_0_9{.inv_dp = 3, .inv_void = 10};
    EXPECT_EQ(from_0_9.compression(5.0f, 0.85f), 0);
    EXPECT_NEAR(from_0_9.compression(5.0f, 0.95f), 2.5, 1e-5);
    EXPECT_EQ(from_0_9.compression(5.0f, 1.0f), 5);
    EXPECT_EQ(from_0_9.compression(5.0f, 1.1f), 5);
    EXPECT_EQ(from_0_9.compression(-5.0f, 0.5f), -5);  // a receding wall pulls at once
}

/// T_i / 1 of a particle dp/2 + gap above a wall that is filled with dummies, under `rows` rows of water above its own.
float touch_in_film(int rows, float gap) {
    const float dp = 0.01f;
    const Kernel kernel(1.55 * double(dp), 3);
    const WallCompleteness touch{.inv_dp = kernel.support_length / dp, .inv_void = 10};
    float sum = 0;
    const auto add = [&](float x, float y, float z) {
        const V3<float> r{x * kernel.inv_support, y * kernel.inv_support, z * kernel.inv_support};
        const float t = std::max(0.0f, 1 - std::sqrt(dot(r, r)));
        touch.add(meet(r, t, kernel.G * dp * dp * dp), V3<float>{0, 0, 1}, sum);
    };
    for (int i = -5; i <= 5; ++i)
        for (int j = -5; j <= 5; ++j) {
            for (int k = 0; k <= rows; ++k) add(float(i) * dp, float(j) * dp, float(k) * dp);
            for (int k = 1; k <= 5; ++k) add(float(i) * dp, float(j) * dp, -float(k) * dp - gap);
        }
    return sum * kernel.W_over_G;
}

TEST(WallCompleteness, AFilmIsTouchedAsDeepWaterIsAndAVoidIsSeen) {
    for (const int rows : {0, 1, 5}) EXPECT_NEAR(touch_in_film(rows, 0), 1, 0.01) << rows;
    EXPECT_NEAR(touch_in_film(5, 0.001f), 0.92, 0.02);  // a tenth of a spacing
    EXPECT_LT(touch_in_film(5, 0.005f), 0.7);
}

/// Q_i of a particle with `rows` of water below its own and `above` above it, on a square lattice of spacing `wide` dp.
double filled(int rows, int above, double h_over_dp, int dimensions, double wide = 1) {
    const double dp = 0.01;
    const Kernel kernel(h_over_dp * dp, dimensions);
    const Shifting shifting(kernel, static_cast<float>(1 / kernel.W(dp)));
    const float V = static_cast<float>(std::pow(dp, dimensions));
    float S = 0;
    V3<float> s{};
    const int across = dimensions == 3 ? 5 : 0;
    for (int i = -5; i <= 5; ++i)
        for (int j = -across; j <= across; ++j)
            for (int k = -rows; k <= above; ++k) {
                const float x = kernel.inv_support * static_cast<float>(wide * dp);
                const V3<float> r{x * float(i), x * float(j), x * float(k)};
                const auto pair = meet(r, std::max(0.0f, 1 - std::sqrt(dot(r, r))), kernel.G * V);
                S += pair.V_W();
                shifting.add(pair, s);
            }
    return double(S * kernel.W_over_G) +
           WaterCompleteness::of_plane_surface(kernel, dp, dimensions) * std::sqrt(dot(s, s));
}

TEST(WaterCompleteness, APlaneSurfaceTakesNothingAndAVoidDoes) {
    for (const int dimensions : {2, 3})
        for (const double h_over_dp : {1.3, 1.55, 2.0}) {
            SCOPED_TRACE(h_over_dp);
            EXPECT_NEAR(filled(5, 0, h_over_dp, dimensions), 1, 0.015);
            for (const int above : {1, 2}) EXPECT_NEAR(filled(5, above, h_over_dp, dimensions), 1, 0.06) << above;
            EXPECT_LT(filled(5, 5, h_over_dp, dimensions, 1.1), dimensions == 3 ? 0.78 : 0.85);
        }
}

TEST(WaterCompleteness, OnlyCompressionWaitsForTheVoid) {
    const WaterCompleteness touch{.a = 0};
    EXPECT_EQ(touch.compression(5.0f, 0.75f, 0.0f), 0);
    EXPECT_NEAR(touch.compression(5.0f, 0.85f, 0.0f), 2.5, 1e-5);
    EXPECT_EQ(touch.compression(5.0f, 0.9f, 0.0f), 5);
    EXPECT_EQ(touch.compression(-5.0f, 0.5f, 0.0f), -5);
    EXPECT_EQ((WaterCompleteness{.a = 0.1f}.compression(5.0f, 0.7f, 2.0f)), 5) << "a plane surface";
}

// What a wall does to water at its edge: no push along its way into the open, all else as it was.
TEST(EdgeRelease, TakesThePushAlongTheWayAndNothingElse) {
    const auto released = [](V3<float> a, V3<float> w, float s) {
        EdgeRelease<float>{w, s / std::max(dot(w, w), 1.0f)}.apply(a, 5);
        return std::array{a.x, a.y, a.z};
    };
    EXPECT_EQ(released({3, 0, 4}, {2, 0, 0}, 1), (std::array{0.0f, 0.0f, 4.0f}));
    EXPECT_EQ(released({3, 0, 4}, {2, 0, 0}, 0.5f), (std::array{1.5f, 0.0f, 4.0f}));
    EXPECT_EQ(released({-3, 0, 4}, {2, 0, 0}, 1), (std::array{-3.0f, 0.0f, 4.0f})) << "what comes nearer is stopped";
    EXPECT_EQ(released({3, 0, 4}, {0, 0, 0}, 1), (std::array{3.0f, 0.0f, 4.0f})) << "no edge";
    // before the edge only what a uniform pressure gives: b . w = 4 of a . w = 6
    const auto before = [](float uniform) {
        V3<float> a{3, 0, 4};
        EdgeRelease<float>{{2, 0, 0}, -0.25f}.apply(a, uniform);
        return std::array{a.x, a.y, a.z};
    };
    EXPECT_EQ(before(4), (std::array{1.0f, 0.0f, 4.0f}));
    EXPECT_EQ(before(-4), (std::array{3.0f, 0.0f, 4.0f})) << "the edge is behind";
    EXPECT_EQ(void_beyond(1.01f), 0) << "water all round the edge";
    EXPECT_NEAR(void_beyond(0.99f), 0.5f, 1e-4);
    EXPECT_EQ(void_beyond(0.9f), 1);
    EXPECT_EQ(released_share(0, 1000, 64), 1);
    EXPECT_EQ(released_share(16000, 1000, 64), 0.5f);
    EXPECT_EQ(released_share(40000, 1000, 64), 0) << "deep in the water";
    EXPECT_EQ(released_share(-100, 1000, 64), 1);
}

TEST(FirstMoment, SolvesWhatItWasMadeOfAndLeavesSprayAlone) {
    const FirstMoment<float> m{1.2f, 0.1f, -0.2f, 0.8f, 0.05f, 0.9f};
    const V3<float> x{0.3f, -0.7f, 1.1f};
    const V3<float> b{m.xx * x.x + m.xy * x.y + m.xz * x.z, m.xy * x.x + m.yy * x.y + m.yz * x.z,
                      m.xz * x.x + m.yz * x.y + m.zz * x.z};
    const V3<float> found = m.solve(b);
    EXPECT_NEAR(found.x, x.x, 1e-6);
    EXPECT_NEAR(found.y, x.y, 1e-6);
    EXPECT_NEAR(found.z, x.z, 1e-6);
    const V3<float> of_spray = FirstMoment<float>{0.1f, 0, 0, 0.1f, 0, 0.1f}.solve(b);
    EXPECT_EQ(of_spray.x, 0);
    EXPECT_EQ(of_spray.y, 0);
    EXPECT_EQ(of_spray.z, 0);
}

TEST(StrainRate, OfShearIsTheShear) {
    VectorGradient<float> grad;
    grad.u = {0, 0, 3};  // du/dz
    EXPECT_NEAR(std::sqrt(strain_rate_squared(grad)), 3, 1e-6);
    grad = {};
    grad.v = {2, 0, 0}, grad.u = {0, -2, 0};  // rotation
    EXPECT_EQ(strain_rate_squared(grad), 0);
    EXPECT_DOUBLE_EQ(eddy_viscosity(mixing_length_at_wall(0.1, 1), 3), 0.03);
    EXPECT_DOUBLE_EQ(mixing_length_at_wall(0.1, 0.1), 0.041);
}

TEST(NoSlip, MakesTheMeanOfWaterAndDummyTheWalls) {
    const V3<float> wall{1, 0, 0}, water{3, -1, 0.5f}, dummy = no_slip_velocity(wall, water);
    EXPECT_EQ(dummy.x + water.x, 2);
    EXPECT_EQ(dummy.y + water.y, 0);
    EXPECT_EQ(dummy.z + water.z, 0);
}

/// Across a surface of radius R, kappa = 2/R, the force on a layer of water is the pressure jump 2 sigma / R on its
/// area. Its half of the kernel's width holds half of the rise of C: int |grad C| dx = 1/2.
TEST(SurfaceForce, OverTheLayerIsThePressureJumpOfADrop) {
    const double sigma = 0.072, m = 1e-3, rho = 1000, R = 0.01, width = 0.002;
    const SurfaceForce force(sigma, m);
    const float a =
        force.along_normal(static_cast<float>(m / rho), static_cast<float>(2 / R), static_cast<float>(0.5 / width));
    EXPECT_NEAR(rho * double(a) * width, 2 * sigma / R, 1e-6 * sigma / R);
}

TEST(Contact, OfEqualFluidsIsTheMeanAndOfWaterAndAirIsTheWaters) {
    const Contact equal(1000, 1000);
    EXPECT_EQ(equal.of_own, 1);
    EXPECT_EQ(equal.of_other, 1);
    const Contact air(1, 999);  // the air's particle sees a wall: u* = u_water, p* = p_air
    EXPECT_NEAR(air.of_own, 1.998, 1e-6);
    EXPECT_NEAR(air.of_other, 0.002, 1e-6);
    EXPECT_EQ(harmonic_mean(0, 0), 0);
    EXPECT_EQ(harmonic_mean(2, 2), 2);
}

TEST(TensionControl, TurnsTensionInsideTheWaterOnly) {
    EXPECT_EQ(tension_controlled(-5, 1, 0.95f), 5);
    EXPECT_EQ(tension_controlled(-5, 0.9f, 0.95f), -5);
    EXPECT_EQ(tension_controlled(5, 1, 0.95f), 5);
}

}  // namespace equations_test
}  // namespace tw
