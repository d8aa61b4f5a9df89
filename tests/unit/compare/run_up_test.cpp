// Run-up on a slope: the waterline of raster frames, its peaks in waves, and the formulas beside them.
#include "compare/metrics/run_up.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/metrics/wave_peaks.h"
#include "compare/reference/run_up_formulas.h"
#include "compared_peaks.h"
#include "record/raster.h"
#include "record/solid_at_rest.h"

namespace tw::test {
namespace run_up_test {

using std::numbers::pi;

constexpr double T = 2, edge = 0.02;

/// A slope of 1 in 2 from the floor at x = 0, z = -0.4 m to its crest at x = 1.2, z = 0.2 m, and 0.2 m beyond.
Surface slope() {
    Surface s;
    for (const double y : {-1.0, 1.0})
        for (const auto& [x, z] : {std::pair{0.0, -0.4}, {1.2, 0.2}, {1.4, 0.2}, {1.4, -0.4}})
            s.points.emplace_back(x, y, z);
    for (int i = 0; i < 4; ++i) {
        const int n = (i + 1) % 4;
        s.triangles.push_back({i, n, n + 4});
        s.triangles.push_back({i, n + 4, i + 4});
    }
    s.triangles.insert(s.triangles.end(), {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}});
    return s;
}

/// Water up to `level(t)` on the slope, which is mirrored where the waves run towards -x; and a lump in the air above
/// it.
template <class Level>
RunRecord on_slope(int periods, Level level, bool mirrored = false, bool gap = false) {
    RunRecord r;
    r.attributes = {{"method", "fvm"}, {"state", "finished"}};
    r.state = "finished";
    const double sign = mirrored ? -1 : 1;
    r.numbers = {{"wave_period", T},
                 {"wave_length", 4},
                 {"wave_height", 0.05},
                 {"wave_direction", sign},
                 {"gravity", 9.81},
                 {"near_hull", edge},
                 {"slope_crest_dike", 0.2},
                 {"slope_cot_dike", 2},
                 {"slope_depth_dike", 0.4},
                 {"slope_plane_dike", 1},
                 {"obstacle_x_min_dike", mirrored ? -1.4 : 0},
                 {"obstacle_x_max_dike", mirrored ? 0 : 1.4}};
    Surface dike = slope();
    for (Vec3& p : dike.points) p.x() *= sign;
    r.bodies.push_back({obstacle_table("dike"), dike, Vec3::Zero()});
    r.raster = {Vec3(-2, 0, -0.4), edge, {200, 1, 40}};
    for (double t = 0; t <= periods * T + 1e-9; t += T / 20) {
        r.table("height").append(t);
        Raster raster(r.raster);
        for (int i = 0; i < 200; ++i)
            for (int k = 0; k < 40; ++k) {
                const double x = -2 + (i + 0.5) * edge, along = sign * x, low = -0.4 + k * edge;
                const double ground = along < 0 || along > 1.4 ? -0.4 : std::min(-0.4 + along / 2, 0.2);
                const bool behind = along > 1.4;
                const double top = behind ? -0.3 : level(t) + (gap && along > 0.75 ? 0.06 : 0);  // cast over the gap
                double share = std::clamp((std::min(top, low + edge) - std::max(ground, low)) / edge, 0.0, 1.0);
                if (gap && along > 0.7 && along < 0.75) share = 0;
                if (along > 1 && along < 1.1 && low > 0.3) share = 1;  // thrown up
                raster.pour(Vec3(x, edge / 2, low + edge / 2), edge, share * edge * edge * edge);
            }
        r.frames.push_back(raster.frame(t));
    }
    return r;
}
double wave(double t) { return 0.01 - 0.11 * std::cos(2 * pi * t / T); }

TEST(RunUp, IsTheHighestWaterlineInEachPeriodFromEitherSide) {
    for (const bool mirrored : {false, true}) {
        const Comparison c = compared(on_slope(7, wave, mirrored));
        const Quantity* q = c.find("run_up:dike");
        ASSERT_TRUE(q && q->values[0].known);
        EXPECT_NEAR(q->values[0].value, 0.12, edge / 2);
        EXPECT_EQ(q->values[0].reading_above, edge / 2);
        ASSERT_TRUE(c.find("peak_median:run_up:dike"));
        EXPECT_FALSE(c.find("peak_p90:run_up:dike"));
    }
}

TEST(RunUp, DoesNotCountWaterThatIsNotOfTheSea) {
    const Comparison c = compared(on_slope(7, wave, false, true));
    EXPECT_NEAR(c.find("run_up:dike")->values[0].value, 0.12, edge)
        << "what was thrown beyond the gap stands 60 mm higher";
    const PeakHistory h =
        waterline_on(on_slope(1, [](double) { return -0.1; }), "dike", {.from = 0, .period = T, .count = 1});
    ASSERT_FALSE(h.x.empty());
    EXPECT_NEAR(h.x[0], -0.1, edge / 2);
}

TEST(RunUp, EndsAtTheCrest) {
    const Comparison c = compared(on_slope(7, [](double t) { return 0.1 - 0.15 * std::cos(2 * pi * t / T); }));
    EXPECT_NEAR(c.find("run_up:dike")->values[0].value, 0.25, edge / 2)
        << "what stands on the crest, not what is behind it";
    RunRecord r = on_slope(7, wave);
    r.numbers.erase("slope_crest_dike");
    EXPECT_FALSE(compared(r).find("run_up:dike"));
}

TEST(RunUp, HasTheFormulasBesideIt) {
    const Comparison c = compared(on_slope(7, wave));
    std::vector<std::string> sources;
    for (const Reference& r : c.references)
        if (r.quantity == "run_up:dike") sources.push_back(r.source);
    EXPECT_EQ(sources, (std::vector<std::string>{"Ahrens & Titus 1985", "Keller & Keller 1964"}));
    RunRecord bent = on_slope(7, wave);
    bent.numbers["slope_plane_dike"] = 0;
    EXPECT_EQ(std::ranges::count(compared(bent).references, std::string("Keller & Keller 1964"), &Reference::source),
              0);
}

TEST(RunUpFormulas, OfLongWavesFindTheStandingWaveAtAWallAndBesselsFunctionsOnASlope) {
    WavesOnSlope w{.height = 0.04, .period = 4, .length = 6.2, .depth = 0.25, .cot_slope = 0, .gravity = 9.81};
    EXPECT_NEAR(long_wave_run_up(w)->height, 0.04, 1e-12);  // twice the amplitude
    w.cot_slope = 2;  // s = 1.0030: J0 = 0.7639, J1 = 0.4410 (Abramowitz & Stegun, table 9.1, interpolated)
    EXPECT_NEAR(long_wave_run_up(w)->height / 0.04, 1 / std::hypot(0.7639, 0.4410), 1e-3);
    EXPECT_TRUE(long_wave_run_up(w)->in_range);
    w.cot_slope = 10;
    EXPECT_FALSE(long_wave_run_up(w)->in_range) << "it breaks";
}

TEST(RunUpFormulas, OfMeasurementsAreContinuousAndKnowHuntsFormula) {
    WavesOnSlope w{.height = 0.1, .period = 2, .length = 4, .depth = 0.5, .cot_slope = 4, .gravity = 9.81};
    const auto at = [&](double xi) {
        w.cot_slope = std::sqrt(9.81 * 4 / (2 * pi) / 0.1) / xi;
        EXPECT_NEAR(breaker_parameter(w), xi, 1e-12);
        return ahrens_titus_run_up(w)->height / 0.1;
    };
    EXPECT_NEAR(at(1), 1.002, 1e-9);
    for (const double xi : {2.0, 3.5}) EXPECT_NEAR(at(xi * (1 - 1e-9)), at(xi * (1 + 1e-9)), 1e-6);
    // on 45 degrees 1.087 sqrt(2) and Goda's 0.1/4 / tanh^3(pi/4)
    at(7.9);
    w.cot_slope = 1;
    EXPECT_NEAR(ahrens_titus_run_up(w)->height / 0.1,
                1.087 * std::sqrt(2) + 0.775 * 0.025 / std::pow(std::tanh(pi / 4), 3), 1e-9);
    w.cot_slope = 0;
    EXPECT_FALSE(ahrens_titus_run_up(w));
    WavesOnSlope sea{.height = 0.1, .period = 1, .depth = 0.5, .cot_slope = 4, .gravity = 9.81};
    const double xi = 0.25 / std::sqrt(0.1 * 2 * pi / 9.81);  // 0.988: breaking
    EXPECT_NEAR(eurotop_run_up(sea)->height / 0.1, 1.65 * xi, 1e-9);
    EXPECT_NEAR(eurotop_run_up(sea)->half_width / eurotop_run_up(sea)->height, 1.96 * 0.10 / 1.65, 1e-9);
    sea.cot_slope = 2, sea.period = 2;
    EXPECT_NEAR(eurotop_run_up(sea)->height / 0.1, 4 - 1.5 / std::sqrt(4 * xi), 1e-9);
    sea.cot_slope = 1.5;
    EXPECT_FALSE(eurotop_run_up(sea));
}

}  // namespace run_up_test
}  // namespace tw::test
