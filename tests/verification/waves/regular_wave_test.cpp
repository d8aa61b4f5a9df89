// A regular wave as both methods take it: speeds and surface from plain numbers.
#include "waves/regular_wave.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <vector>

#include "test_paths.h"
#include "waves/dispersion.h"
#include "waves/steepness.h"

namespace tw {
namespace regular_wave_test {

using std::numbers::pi;
using Theory = RegularWave::Theory;

WaveOrder order(double kd, double steepness) {
    const double length = 2;
    return {.height = steepness * length, .length = length, .depth = kd * length / (2 * pi)};
}

TEST(WaveSum, HasItsOwnExponentialAndCircle) {
    for (const double x : {-600.0, -30.0, -1.0, -1e-9, 0.0, 0.3, 1.0, 17.0, 300.0})
        EXPECT_NEAR(wave_exp(x) / std::exp(x), 1, 1e-13 * (1 + std::abs(x)));
    for (double turns = -3.1; turns < 3.2; turns += 0.0371) {
        double c, s;
        wave_circle(turns, c, s);
        EXPECT_NEAR(c, std::cos(2 * pi * turns), 2e-14);
        EXPECT_NEAR(s, std::sin(2 * pi * turns), 2e-14);
    }
}

TEST(RegularWave, SurfaceIsAStreamlineWithoutPressure) {
    for (const double direction : {1.0, -1.0})
        for (const double kd : {0.5, 1.0, 30.0}) {
            WaveOrder of = order(kd, kd < 1 ? 0.03 : 0.06);
            of.direction = direction;
            const RegularWave w = regular_wave(of);
            ASSERT_EQ(w.theory, Theory::stream_function);
            for (double x = 0; x < w.length; x += 0.0613) {
                const double t = 0.37, eta = wave_surface(w.sum, x, t), dx = 1e-5,
                             slope = (wave_surface(w.sum, x + dx, t) - wave_surface(w.sum, x - dx, t)) / (2 * dx),
                             rise = (wave_surface(w.sum, x, t + dx) - wave_surface(w.sum, x, t - dx)) / (2 * dx);
                double u, v;
                wave_velocity(w.sum, x, eta, t, u, v);
                EXPECT_NEAR(w.pressure_over_density(x, eta, t), 0, 1e-8 * w.bernoulli);
                EXPECT_NEAR(rise + u * slope, v, 1e-6 * w.speed_in_water);  // kinematic condition, in the scene's axes
            }
            EXPECT_NEAR(wave_surface(w.sum, 0, 0), w.crest, 1e-9);
            const double half = w.encounter_period() / 2;
            EXPECT_NEAR(wave_surface(w.sum, 0, half), w.trough, 1e-9);
            EXPECT_NEAR(wave_surface(w.sum, direction * w.sum.speed * half, half), w.crest, 1e-9);
        }
}

TEST(RegularWave, FlowHasNeitherSourcesNorRotationAndNoneThroughTheFloor) {
    const RegularWave w = regular_wave(order(1.3, 0.05));
    const double d = 1e-5, t = 0.2;
    const auto at = [&](double x, double z) {
        std::pair<double, double> v;
        wave_velocity(w.sum, x, z, t, v.first, v.second);
        return v;
    };
    for (double x = 0.1; x < 2; x += 0.3)
        for (double z = -0.35; z < 0; z += 0.1) {
            const auto right = at(x + d, z), left = at(x - d, z), up = at(x, z + d), down = at(x, z - d);
            EXPECT_NEAR((right.first - left.first + up.second - down.second) / (2 * d), 0, 1e-7);
            EXPECT_NEAR((right.second - left.second - up.first + down.first) / (2 * d), 0, 1e-7);
        }
    EXPECT_NEAR(at(0.3, -w.depth).second, 0, 1e-12);
}

/// Volume that goes through a section between floor and surface, mean over a wave [m2/s].
double mean_flux(const RegularWave& w) {
    double flux = 0;
    const int columns = 200, rows = 400;
    for (int i = 0; i < columns; ++i) {
        const double x = w.length * i / columns, eta = wave_surface(w.sum, x, 0);
        for (int k = 0; k < rows; ++k) {
            double u, v;
            wave_velocity(w.sum, x, -w.depth + (k + 0.5) / rows * (eta + w.depth), 0, u, v);
            flux += u * (eta + w.depth) / rows / columns;
        }
    }
    return flux;
}

TEST(RegularWave, AClosedTankHasNoNetTransport) {
    const RegularWave w = regular_wave(order(1, 0.06));
    EXPECT_NEAR(mean_flux(w), 0, 2e-5 * w.transport);
    EXPECT_LT(w.sum.current, 0);
    WaveOrder linear = order(1, 0.01);
    linear.theory = Theory::linear;
    const RegularWave low = regular_wave(linear);
    EXPECT_NEAR(mean_flux(low), 0, 2e-3 * low.transport) << "to second order";
    EXPECT_LT(low.sum.current, 0);
}

/// Particles of the surface go on as the table of drift says (tests/data/fenton_drift.csv), from travel times there.
TEST(RegularWave, CarriesParticlesOnAsTheTableSays) {
    std::ifstream file(TWINWAKE_TEST_DATA "/fenton_drift.csv");
    std::string line;
    std::getline(file, line);
    int compared = 0;
    while (std::getline(file, line)) {
        std::vector<std::string> cell;
        std::stringstream cells(line);
        for (std::string c; std::getline(cells, c, ',');) cell.push_back(c);
        if (cell[2] != "0" || (cell[0] != "1" && cell[0] != "2")) continue;
        WaveOrder of = order(std::stod(cell[0]), std::stod(cell[1]));
        of.closed = false;
        of.theory = Theory::stream_function;
        const RegularWave w = regular_wave(of);
        // from crest to crest: Heun's steps until the crest has come by again
        double x = 0, z = w.crest, t = 0;
        const double dt = w.encounter_period() / 4000;
        while (w.sum.speed * t - x < w.length) {
            double u, v, u2, v2;
            wave_velocity(w.sum, x, z, t, u, v);
            wave_velocity(w.sum, x + u * dt, z + v * dt, t + dt, u2, v2);
            x += (u + u2) / 2 * dt, z += (v + v2) / 2 * dt, t += dt;
        }
        EXPECT_NEAR(x / t / w.sum.speed / std::stod(cell[4]), 1, 4e-3) << line;
        ++compared;
    }
    EXPECT_GE(compared, 8);
}

TEST(RegularWave, PeriodAndLengthBelongTogether) {
    for (const double direction : {1.0, -1.0})
        for (const bool closed : {true, false}) {
            WaveOrder of = order(1.2, 0.05);
            of.direction = direction;
            of.closed = closed;
            of.stream = closed ? 0 : 0.4;
            const RegularWave first = regular_wave(of);
            of.length.reset();
            of.period = closed ? first.encounter_period() : first.period_in_water();
            const RegularWave second = regular_wave(of);
            EXPECT_NEAR(second.length, first.length, 1e-8);
            // in a stream the crests pass faster or slower by as much as it runs: omega_e = omega +- k U
            const double carried = closed ? 0 : direction * second.k() * 0.4;
            EXPECT_NEAR(second.encounter_frequency(), 2 * pi / *of.period + carried, 1e-8);
        }
}

TEST(RegularWave, OfSmallHeightIsLinear) {
    const RegularWave w = regular_wave(order(1.5, 0.0005));
    EXPECT_EQ(w.theory, Theory::linear);
    EXPECT_NEAR(w.speed_in_water * w.k(), wave_frequency(w.k(), 9.81, w.depth), 1e-12);
    WaveOrder of = order(1.5, 0.0005);
    of.theory = Theory::stream_function;
    const RegularWave full = regular_wave(of);
    double u, v, uf, vf;
    wave_velocity(w.sum, 0.2, -0.1, 0.3, u, v);
    wave_velocity(full.sum, 0.2, -0.1, 0.3, uf, vf);
    EXPECT_NEAR(u, uf, 0.01 * std::abs(uf));
    EXPECT_NEAR(v, vf, 0.01 * std::abs(vf));
}

TEST(Steepness, KnowsItsLimits) {
    EXPECT_NEAR(highest_wave(1, 1e6), 0.1411, 1e-3);  // deep
    EXPECT_NEAR(highest_wave(1e5, 1), 0.8332, 2e-3);  // solitary
    EXPECT_EQ(wave_regime(0.001, 1, 1), "linear");
    EXPECT_EQ(wave_regime(0.06, 1, 1), "Stokes, second order");
    EXPECT_EQ(wave_regime(0.2, 1, 1), "breaking");
    EXPECT_EQ(wave_regime(0.2, 20, 1), "cnoidal");
    EXPECT_EQ(depth_regime(1, 0.6), "deep");
    EXPECT_EQ(depth_regime(30, 1), "shallow");
    EXPECT_NEAR(group_speed_ratio(400), 0.5, 1e-12);
    EXPECT_NEAR(group_speed_ratio(1e-3), 1, 1e-5);
}

}  // namespace regular_wave_test
}  // namespace tw
