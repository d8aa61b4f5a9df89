// Where water goes under a sum of waves in a stream, and how the particles that enter with it stay in order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "waves/regular_wave.h"
#include "waves/sea.h"

namespace tw {
namespace sea_path_test {

using std::numbers::pi;
constexpr double U = 2.5, depth = 0.5;

Sea two_waves(double height, double second) {
    return make_sea({.kind = Sea::Kind::bichromatic,
                     .depth = depth,
                     .stream = U,
                     .heights = {height, second},
                     .periods = {0.8, 0.65}});
}
Sea spectrum() { return make_sea({.depth = depth, .stream = U, .height = 0.05, .peak_period = 0.8, .components = 24}); }

TEST(SeaPath, HasTheVelocitiesAndThePressureOfTheSea) {
    const Sea sea = spectrum();
    const SeaInStream s = sea_in_stream(sea.waves);
    for (const double t : {0.0, 41.7})
        for (const double x : {-0.3, 0.0, 12.4})
            for (const double z : {0.0, -0.07, -0.3, -depth}) {
                double u, w, along, up;
                wave_velocity(wave_moment(sea.waves, t), x, z, u, w);
                added_velocity(s, x, z, t, along, up);
                EXPECT_NEAR(U + along, u, 1e-9);
                EXPECT_NEAR(up, w, 1e-9);
                EXPECT_NEAR(added_pressure(s, x, z, t), sea.pressure_over_density(x, z, t), 1e-8);
            }
}

TEST(SeaPath, MakesNoVolumeAboveStillWaterEither) {
    const SeaInStream s = sea_in_stream(spectrum().waves);
    constexpr double h = 1e-5;
    double largest = 0;
    for (double x = -0.2; x < 1.5; x += 0.13)
        for (const double z : {-0.2, -0.03, 0.01, 0.04}) {
            double u[4], w[4];
            added_velocity(s, x - h, z, 0.3, u[0], w[0]), added_velocity(s, x + h, z, 0.3, u[1], w[1]);
            added_velocity(s, x, z - h, 0.3, u[2], w[2]), added_velocity(s, x, z + h, 0.3, u[3], w[3]);
            const double along = (u[1] - u[0]) / (2 * h);
            largest = std::max(largest, std::abs(along));
            EXPECT_NEAR(along + (w[3] - w[2]) / (2 * h), 0, 1e-6) << x << " " << z;
            double lift[4], slope[2], per_z[2];  // psi_n/C_n, whose derivatives are u_n/C_n and -w_n/C_n
            sea_lift(s, x - h, z, 0.3, lift[0], slope[0]), sea_lift(s, x + h, z, 0.3, lift[1], slope[0]);
            sea_lift(s, x, z - h, 0.3, lift[2], slope[0]), sea_lift(s, x, z + h, 0.3, lift[3], slope[0]);
            sea_lift(s, x, z, 0.3, slope[1], slope[0]);
            sea_sums<-1>(s, x, z, 0.3, per_z[0], per_z[1]);
            EXPECT_NEAR(slope[0], per_z[0], 1e-9);
            EXPECT_NEAR((lift[3] - lift[2]) / (2 * h), per_z[0], 1e-6);
            EXPECT_NEAR((lift[1] - lift[0]) / (2 * h), -per_z[1], 1e-6);
        }
    EXPECT_GT(largest, 0.3);  // [1/s]: with the velocities of still water above it so much would be made
}

// Of one linear wave the lines are its streamlines: what a regular wave's particles follow.
TEST(SeaPath, OfOneWaveIsThatOfARegularOne) {
    const Sea sea = two_waves(0.02, 1e-9);
    const SeaInStream one = sea_in_stream(sea.waves);
    const RegularWave wave = regular_wave({.height = 0.02,
                                           .length = sea.length(0),
                                           .depth = depth,
                                           .closed = false,
                                           .stream = U,
                                           .theory = RegularWave::Theory::linear});
    RegularInStream regular = in_stream(wave);
    regular.carried = one.carried * wave.speed_in_water;  // by Stokes' drift, which is of second order
    for (const double t : {0.0, 0.1})
        for (double x = 0; x < sea.length(0); x += 0.11)
            for (const double z : {-0.02, -0.1, -0.4}) {
                double x1 = x, z1 = z, x2 = x, z2 = z, lifted, per_z;
                sea_lift(one, x, z, t, lifted, per_z);
                const WaveInStream now{t, 1, U};
                go_behind(one, now, 0.3, (z + depth - lifted) * (1 + one.carried) - depth, x1, z1);
                go_behind(regular, now, 0.3, x2, z2);
                EXPECT_NEAR(x1, x2, 1e-5) << x << " " << z;
                EXPECT_NEAR(z1, z2, 1e-5) << x << " " << z;
                EXPECT_GT(std::abs(x1 - (x - 0.3)) + std::abs(z1 - z), 1e-4);  // ten times that from calm water
            }
}

struct Particle {
    double x, z;
};
/// The inlet's particles without a solver: rows that enter through x = 0 over a time, with new ones behind them.
struct Inlet {
    static constexpr double dp = 0.025, buffer = 6 * dp;
    static constexpr std::size_t rows = 20;
    std::vector<std::vector<Particle>> row = std::vector<std::vector<Particle>>(rows);  ///< the foremost first
    std::vector<long> entered = std::vector<long>(rows, 0);
    double smallest_area = 9, largest_area = 0;        ///< of a particle, over dp^2
    double smallest_spacing = 9, largest_spacing = 0;  ///< along rows, over dp
    double level = 0;                                  ///< mean of the top over the wave's surface [m]

    static double calm(std::size_t r) { return -depth + dp * (static_cast<double>(r) + 0.5); }
    /// `keeps_rows`: as particles enter; else whole columns, at the distances of the undisturbed stream.
    Inlet(const Sea& sea, double duration, bool keeps_rows) {
        const SeaInStream s = sea_in_stream(sea.waves);
        for (std::size_t r = 0; r < rows; ++r)
            for (int c = 0; c < 6; ++c) row[r].push_back({-dp * (c + 0.5), calm(r)});
        constexpr double dt = 0.2 * dp / U;
        const double grown = sea.repeat_period, counted_from = 2 * grown;
        const auto at = [&](double t) {
            const double part = std::min(1.0, t / grown);
            return WaveInStream{t, part * part * (3 - 2 * part), U};
        };
        int looked = 0;
        const long steps = std::lround((counted_from + duration) / dt);
        for (long k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) * dt;
            for (std::vector<Particle>& line : row)
                for (Particle& p : line) go_with_water(s, at(t), at(t + dt / 2), at(t + dt), p.x, p.z);
            const WaveInStream now = at(t + dt);
            for (std::size_t r = 0; r < rows; ++r) {
                for (Particle& p : row[r]) {
                    if (p.x < 0) continue;
                    if (t >= counted_from) ++entered[r];
                    if (keeps_rows)
                        go_behind(s, now, buffer, calm(r), p.x, p.z);
                    else
                        p.x -= buffer;
                }
                std::ranges::sort(row[r], [](const Particle& a, const Particle& b) { return a.x > b.x; });
            }
            if (t < counted_from || k % 7 != 0) continue;
            level += look(sea, t + dt);
            ++looked;
        }
        level /= looked;
    }
    /// Areas and spacings in the middle of the buffer; how far the top is above the surface [m].
    double look(const Sea& sea, double t) {
        std::vector<double> height(rows), spacing(rows);
        for (std::size_t r = 0; r < rows; ++r) {
            std::size_t i = 0;
            while (i + 2 < row[r].size() && row[r][i + 1].x > -buffer / 2) ++i;
            const Particle &ahead = row[r][i], &behind = row[r][i + 1];
            spacing[r] = ahead.x - behind.x;
            height[r] = behind.z + (ahead.z - behind.z) * (-buffer / 2 - behind.x) / spacing[r];
            smallest_spacing = std::min(smallest_spacing, spacing[r] / dp);
            largest_spacing = std::max(largest_spacing, spacing[r] / dp);
        }
        for (std::size_t r = 1; r + 1 < rows; ++r) {
            const double area = (height[r + 1] - height[r - 1]) / 2 * spacing[r] / (dp * dp);
            smallest_area = std::min(smallest_area, area), largest_area = std::max(largest_area, area);
        }
        return 1.5 * height[rows - 1] - 0.5 * height[rows - 2] - wave_surface(sea.waves, -buffer / 2, t);
    }
    /// Particles that came in over those of theory, which water carries along by Stokes' drift beside the stream.
    double share_of(const Sea& sea, std::size_t r, double duration) const {
        double drift = 0, over_speed = 0, carried = 0;
        for (int n = 0; n < sea.waves.count; ++n) {
            const double k = sea.waves.k[n], omega = sea.waves.omega[n], a = sea.waves.height[n], d = k * depth,
                         of = a * a * omega * k * std::cosh(2 * k * (calm(r) + depth)) /
                              (2 * std::sinh(d) * std::sinh(d));
            drift += of, over_speed += of * k / omega, carried += a * a * k / (2 * depth * std::tanh(d));
        }
        const double rate = (U + drift) / (dp * (1 + carried) * (1 - over_speed));
        return static_cast<double>(entered[r]) / (rate * duration);
    }
};

// Of two waves 25 and 20 mm high, and of a spectrum 50 mm high: 19 and 12 periods of encounter.
TEST(SeaPath, ParticlesThatEnterFollowOneAnotherInRowsOfTheirOwnArea) {
    constexpr double duration = 4;
    const auto print = [](const char* name, const Sea& sea, const Inlet& of) {
        std::printf("%s: areas %.3f to %.3f, spacings %.3f to %.3f, level %.2f mm, entered over theory", name,
                    of.smallest_area, of.largest_area, of.smallest_spacing, of.largest_spacing, 1e3 * of.level);
        for (std::size_t r = 1; r < Inlet::rows; r += 6) std::printf(" %.4f", of.share_of(sea, r, duration));
        std::printf("\n");
    };
    for (const Sea& sea : {two_waves(0.025, 0.02), spectrum()}) {
        const Inlet inlet(sea, duration, true), columns(sea, duration, false);
        print("rows", sea, inlet), print("columns", sea, columns);
        const bool random = sea.kind == Sea::Kind::jonswap;
        EXPECT_GT(inlet.smallest_area, random ? 0.92 : 0.97);
        EXPECT_LT(inlet.largest_area, random ? 1.08 : 1.03);
        EXPECT_LT(columns.smallest_area, random ? 0.91 : 0.95);
        EXPECT_LT(std::abs(inlet.level), 2e-4);
        for (std::size_t r = 1; r + 1 < Inlet::rows; r += 6)
            EXPECT_NEAR(inlet.share_of(sea, r, duration), 1, 3e-3) << r;
        const std::size_t top = Inlet::rows - 1;
        EXPECT_NEAR(inlet.share_of(sea, top, duration), 1, 0.01);
        EXPECT_LT(columns.share_of(sea, top, duration), 0.99);
    }
}

}  // namespace sea_path_test
}  // namespace tw
