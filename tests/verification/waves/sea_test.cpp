// Sums of linear waves: their spectra, their velocities from plain numbers, focused groups and what second order adds.
#include "waves/sea.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "waves/dispersion.h"

namespace tw {
namespace sea_test {

using std::numbers::pi;

SeaOrder order(Sea::Kind kind, double depth = 0.6) {
    return {.kind = kind, .depth = depth, .height = 0.06, .peak_period = 1.2};
}

TEST(Sea, HasTheSpectrumsHeightAndMoments) {
    for (const Sea::Kind kind : {Sea::Kind::jonswap, Sea::Kind::pierson_moskowitz})
        for (const int components : {40, 96}) {
            SeaOrder of = order(kind);
            of.components = components;
            const Sea sea = make_sea(of);
            EXPECT_NEAR(sea.significant_height, 0.06, 1e-14);
            EXPECT_NEAR(4 * std::sqrt(sea.moment(0)), 0.06, 1e-14);
            // whole multiples of one over the repeat period, round the peak
            EXPECT_NEAR(sea.repeat_period, components * 1.2 / 2, 1e-9);
            for (int n = 0; n < components; ++n) {
                const double multiple = sea.frequency(n) * sea.repeat_period;
                EXPECT_NEAR(multiple, std::round(multiple), 1e-9);
                EXPECT_NEAR(
                    sea.waves.omega[n] * sea.waves.omega[n] / (9.81 * sea.waves.k[n] * std::tanh(sea.waves.k[n] * 0.6)),
                    1, 1e-12);
            }
        }
    // of Pierson-Moskowitz m0(f) = exp(-5/4 (fp/f)^4) m0; band of 0.492 to 2.492 fp
    const Sea pm = make_sea(order(Sea::Kind::pierson_moskowitz));
    const double low = 14.5 / 30, high = 74.5 / 30, of_low = std::exp(-1.25 * std::pow(low, -4)),
                 of_high = std::exp(-1.25 * std::pow(high, -4));
    EXPECT_NEAR(pm.beyond, 1 - (of_high - of_low), 1e-5);
    double sum = 0;
    for (int n = 0; n < 60; ++n) {
        sum += pm.energy(n);
        const double exact = (std::exp(-1.25 * std::pow((15.5 + n) / 30, -4)) - of_low) / (of_high - of_low);
        EXPECT_NEAR(sum / pm.moment(0), exact, 1e-6);
    }
    // JONSWAP of 3.3: Tp / T02 = 1.285 of the whole spectrum (Goda 2010, eq. 2.25), less without its tail
    const Sea js = make_sea(order(Sea::Kind::jonswap));
    const double ratio = 1.2 / std::sqrt(js.moment(0) / js.moment(2));
    EXPECT_GT(ratio, 1.15);
    EXPECT_LT(ratio, 1.285);
}

TEST(Sea, HasPhasesOfItsSeedOnEveryMachine) {
    SeaOrder of = order(Sea::Kind::jonswap);
    const Sea one = make_sea(of);
    // splitmix64 from 1: 0x910a2dec89025cc1, 0xbeeb8da1658eec67 (Vigna's splitmix64.c)
    EXPECT_EQ(one.waves.phase[0], 2 * pi * (static_cast<double>(0x910a2dec89025cc1ULL >> 11) * 0x1p-53));
    EXPECT_EQ(one.waves.phase[1], 2 * pi * (static_cast<double>(0xbeeb8da1658eec67ULL >> 11) * 0x1p-53));
    of.seed = 2;
    EXPECT_NE(make_sea(of).waves.phase[0], one.waves.phase[0]);
    EXPECT_EQ(make_sea(of).waves.height[7], one.waves.height[7]);
}

TEST(Sea, RepeatsItselfAfterItsPeriod) {
    const Sea sea = make_sea(order(Sea::Kind::jonswap));
    for (double t = 0; t < 3; t += 0.31)
        EXPECT_NEAR(wave_surface(sea.waves, 1.7, t), wave_surface(sea.waves, 1.7, t + sea.repeat_period), 1e-9);
}

TEST(WaveComponents, HasTheVelocitiesOfItsFormula) {
    for (const double depth : {0.15, 0.6, 40.0})
        for (const double direction : {1.0, -1.0}) {
            SeaOrder of = order(Sea::Kind::jonswap, depth);
            of.direction = direction;
            of.components = 61;  // no whole number of lanes
            const Sea sea = make_sea(of);
            const WaveComponents& all = sea.waves;
            const double t = 3.7;
            const WaveMoment now = wave_moment(all, t);
            for (const double x : {-7.3, 0.0, 0.4, 912.0})
                for (const double z : {-depth, -0.3 * depth, -0.01, 0.0, 0.02}) {
                    double along = all.current, up = 0, most = 0;
                    for (int n = 0; n < all.count; ++n) {
                        const double k = all.k[n], a = all.height[n] * all.omega[n], at = std::min(z, 0.0),
                                     theta = k * direction * x - all.omega[n] * t + all.phase[n], e = std::exp(k * at),
                                     d = std::exp(-k * (at + 2 * depth)), below = 1 - std::exp(-2 * k * depth);
                        along += direction * a * (e + d) / below * std::cos(theta);
                        up += a * (e - d) / below * std::sin(theta);
                        most += a;
                    }
                    double u, w;
                    wave_velocity(now, x, z, u, w);
                    EXPECT_NEAR(u, along, 2e-12 * most * (1 + std::abs(x)));
                    EXPECT_NEAR(w, up, 2e-12 * most * (1 + std::abs(x)));
                }
        }
}

TEST(WaveComponents, HaveNoSourcesNoRotationAndFollowTheSurfaceToFirstOrder) {
    SeaOrder of = order(Sea::Kind::jonswap);
    of.height = 1e-6;
    const Sea sea = make_sea(of);
    const double h = 1e-4;
    for (double x = -1; x < 2; x += 0.37) {
        const double t = 1.9;
        const WaveMoment now = wave_moment(sea.waves, t);
        const auto at = [&](double dx, double dz) {
            double u, w;
            wave_velocity(now, x + dx, -0.2 + dz, u, w);
            return std::pair(u, w);
        };
        const double size = 1e-6 * 30;  // a k omega
        EXPECT_NEAR((at(h, 0).first - at(-h, 0).first + at(0, h).second - at(0, -h).second) / (2 * h), 0, 1e-5 * size);
        EXPECT_NEAR((at(0, h).first - at(0, -h).first - at(h, 0).second + at(-h, 0).second) / (2 * h), 0, 1e-5 * size);
        double u, w;
        wave_velocity(now, x, 0, u, w);
        const double rise = (wave_surface(sea.waves, x, t + h) - wave_surface(sea.waves, x, t - h)) / (2 * h);
        EXPECT_NEAR(w, rise, 1e-6 * size);
        EXPECT_NEAR(sea.pressure_over_density(x, 0, t), 9.81 * wave_surface(sea.waves, x, t), 1e-12 * 9.81);
    }
}

TEST(FocusedWave, HasTheSumOfItsAmplitudesAtItsPlaceAndTime) {
    SeaOrder of = order(Sea::Kind::focused);
    of.focus_place = 0.7, of.focus_time = 9.3;
    const Sea sea = make_sea(of);
    EXPECT_NEAR(wave_surface(sea.waves, 0.7, 9.3), 0.06, 1e-12);
    const Crest crest = highest_crest(sea, 0.7, 7, 12, false);
    EXPECT_NEAR(crest.height, 0.06, 1e-12);
    EXPECT_NEAR(crest.time, 9.3, 1e-6);
    // NewWave: the surface about its crest is the autocorrelation of the sea
    const double lag = 0.4;
    double correlation = 0;
    for (int n = 0; n < sea.waves.count; ++n) correlation += sea.waves.height[n] * std::cos(sea.waves.omega[n] * lag);
    EXPECT_NEAR(wave_surface(sea.waves, 0.7, 9.3 + lag), correlation, 1e-12);
    // second order lifts it: in deep water by 1/2 sum_ij a_i a_j min(k_i, k_j), all phases 0, less the mean level
    of.depth = 60;
    const Sea deep = make_sea(of);
    double lift = 0;
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j) {
            const double a = deep.waves.height[i] * deep.waves.height[j];
            lift += i == j ? 0.5 * a * deep.waves.k[i] : 0.5 * a * std::min(deep.waves.k[i], deep.waves.k[j]);
        }
    EXPECT_NEAR(second_order_surface(deep, 0.7, 9.3) / lift, 1, 1e-6);
    EXPECT_GT(highest_crest(deep, 0.7, 7, 12, true).height, 0.06 + 0.9 * lift);
}

TEST(BoundWavesOfSecondOrder, AreThoseOfStokesAndOfRadiationStress) {
    const double d = 0.7, g = 9.81;
    for (const double k : {0.8, 2.0, 6.0, 40.0}) {
        const double t = std::tanh(k * d), R = k * t;
        // Stokes: eta_22 = a^2 k (3 - t^2) / (4 t^3)
        EXPECT_NEAR(bound_waves(k, R, k, R, d).sum / 4 / (k * (3 - t * t) / (4 * t * t * t)), 1, 1e-9) << k;
        // two close ones: set-down of a group, -g a^2 (2 n - 1/2) / (g d - cg^2) (Longuet-Higgins & Stewart 1962)
        const double other = k * 1.0001, R2 = other * std::tanh(other * d), n = group_speed_ratio(k * d),
                     cg = n * wave_frequency(k, g, d) / k;
        EXPECT_NEAR(bound_waves(k, R, other, R2, d).difference / 2 / (-g * (2 * n - 0.5) / (g * d - cg * cg)), 1, 2e-3)
            << k;
    }
    // deep water: k_i + k_j and -|k_i - k_j|
    const BoundWaves deep = bound_waves(3, 3, 5, 5, 400);
    EXPECT_NEAR(deep.sum, 8, 1e-9);
    EXPECT_NEAR(deep.difference, -2, 1e-9);
}

TEST(Sea, SaysWhatFirstOrderLeavesOut) {
    // of two waves: rms of the bound waves over rms of the two
    SeaOrder of{.kind = Sea::Kind::bichromatic, .depth = 60, .heights = {0.04, 0.03}, .periods = {1.2, 1.0}};
    const Sea sea = make_sea(of);
    EXPECT_NEAR(sea.repeat_period, 6, 1e-9);
    const double a = 0.02, b = 0.015, ka = sea.waves.k[0], kb = sea.waves.k[1];
    EXPECT_GT(kb, ka);
    const double sum = std::pow(a * a * ka / 2, 2) + std::pow(b * b * kb / 2, 2) + std::pow(a * b * (ka + kb) / 2, 2),
                 difference = std::pow(a * b * (kb - ka) / 2, 2), first = a * a + b * b;
    EXPECT_NEAR(left_out_by_first_order(sea).sum, std::sqrt(sum / first), 1e-9);
    EXPECT_NEAR(left_out_by_first_order(sea).difference, std::sqrt(difference / first), 1e-9);
}

}  // namespace sea_test
}  // namespace tw
