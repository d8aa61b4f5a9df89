// Waves under an angle to x, as both methods take them: the head wave turned, and carried by a stream along x.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "waves/dispersion.h"
#include "waves/regular_wave.h"
#include "waves/sea.h"

namespace tw {
namespace oblique_wave_test {

using std::numbers::pi;

constexpr double degrees[] = {-120, -35, 20, 45, 90, 135};

struct Velocity {
    double u = 0, v = 0, w = 0;
};
template <class Wave>
Velocity velocity(const Wave& wave, double x, double y, double z, double t) {
    Velocity at;
    wave_velocity(wave, x, y, z, t, at.u, at.v, at.w);
    return at;
}
Velocity velocity(const WaveComponents& waves, double x, double y, double z, double t) {
    Velocity at;
    wave_velocity(wave_moment(waves, t), x, y, z, at.u, at.v, at.w);
    return at;
}

RegularWave wave_towards(double angle, double stream) {
    return regular_wave({.height = 0.1,
                         .length = 1.5,
                         .depth = 0.4,
                         .direction = std::cos(angle),
                         .across = std::sin(angle),
                         .closed = false,
                         .stream = stream});
}
/// Two waves on one another.
WaveComponents two_towards(double angle, double stream) {
    Sea sea = make_sea({.kind = Sea::Kind::bichromatic,
                        .depth = 0.4,
                        .stream = stream,
                        .heights = {0.05, 0.03},
                        .periods = {1.1, 0.9}});
    sea.waves.direction = std::cos(angle);
    sea.waves.across = std::sin(angle);
    sea.waves.current = stream;
    sea.waves.phase[1] = 0.7;
    return sea.waves;
}

template <class Make>
void expect_the_head_wave_turned(Make make) {
    const auto head = make(0.0);
    for (const double degree : degrees) {
        const double b = degree * pi / 180, c = std::cos(b), s = std::sin(b);
        const auto turned = make(b);
        for (double x = -1.3; x < 2; x += 0.37)
            for (const double y : {-0.8, 0.1, 1.7}) {
                const double along = x * c + y * s, t = 0.3 + 0.2 * x;
                EXPECT_NEAR(wave_surface(turned, x, y, t), wave_surface(head, along, t), 1e-13);
                const Velocity at = velocity(turned, x, y, -0.1, t), of_head = velocity(head, along, 0, -0.1, t);
                EXPECT_NEAR(at.u * c + at.v * s, of_head.u, 1e-12);
                EXPECT_NEAR(at.v * c - at.u * s, 0, 1e-12);
                EXPECT_NEAR(at.w, of_head.w, 1e-12);
            }
    }
}

TEST(ObliqueWave, IsTheHeadWaveTurned) {
    expect_the_head_wave_turned([](double b) { return wave_towards(b, 0).sum; });
}

TEST(ObliqueWave, OfASumIsThatOfHeadWavesTurned) {
    expect_the_head_wave_turned([](double b) { return two_towards(b, 0); });
}

/// In a stream too: no sources, no rotation, and the surface goes with the water, to first order in a sum of linear waves.
template <class Wave>
void expect_flow(const Wave& wave, bool first_order) {
    const double h = 1e-5, t = 0.4;
    const auto slope = [&](auto of) { return (of(h) - of(-h)) / (2 * h); };
    for (double x = -0.9; x < 1; x += 0.41)
        for (const double y : {-0.6, 0.3, 1.1}) {
            const double z = -0.12;
            const auto at = [&](double dx, double dy, double dz) { return velocity(wave, x + dx, y + dy, z + dz, t); };
            const double ux = slope([&](double d) { return at(d, 0, 0).u; }),
                         uy = slope([&](double d) { return at(0, d, 0).u; }),
                         uz = slope([&](double d) { return at(0, 0, d).u; }),
                         vx = slope([&](double d) { return at(d, 0, 0).v; }),
                         vy = slope([&](double d) { return at(0, d, 0).v; }),
                         vz = slope([&](double d) { return at(0, 0, d).v; }),
                         wx = slope([&](double d) { return at(d, 0, 0).w; }),
                         wy = slope([&](double d) { return at(0, d, 0).w; }),
                         wz = slope([&](double d) { return at(0, 0, d).w; });
            EXPECT_NEAR(ux + vy + wz, 0, 1e-7);
            EXPECT_NEAR(wy - vz, 0, 1e-7);
            EXPECT_NEAR(uz - wx, 0, 1e-7);
            EXPECT_NEAR(vx - uy, 0, 1e-7);
            const double eta = first_order ? 0 : wave_surface(wave, x, y, t);
            const Velocity there = velocity(wave, x, y, eta, t);
            const double rises = slope([&](double d) { return wave_surface(wave, x, y, t + d); }),
                         along_x = slope([&](double d) { return wave_surface(wave, x + d, y, t); }),
                         along_y = slope([&](double d) { return wave_surface(wave, x, y + d, t); }),
                         u = first_order ? wave.current : there.u, v = first_order ? 0 : there.v;
            EXPECT_NEAR(rises + u * along_x + v * along_y, there.w, 1e-6) << x << " " << y;
        }
}

TEST(ObliqueWave, InAStreamHasNoSourcesNoRotationAndASurfaceThatGoesWithTheWater) {
    for (const double degree : degrees) {
        expect_flow(wave_towards(degree * pi / 180, 0.6).sum, false);
        expect_flow(two_towards(degree * pi / 180, 0.6), true);
    }
}

TEST(ObliqueWave, IsMetAsOftenAsTheStreamBringsItsCrests) {
    const double k = 2 * pi / 1.5, U = 0.6;
    for (const double degree : degrees) {
        const double b = degree * pi / 180;
        WaveOrder linear{.height = 0.001, .length = 1.5, .depth = 0.4, .closed = false, .stream = U};
        linear.direction = std::cos(b), linear.across = std::sin(b);
        const RegularWave wave = regular_wave(linear);
        EXPECT_NEAR(wave.encounter_frequency(), wave_frequency(k, 9.81, 0.4) + U * k * std::cos(b), 1e-9);
        EXPECT_NEAR(wave.period_in_water(), 2 * pi / wave_frequency(k, 9.81, 0.4), 1e-9);
        const RegularWave steep = wave_towards(b, U);
        const double T = steep.encounter_period();
        EXPECT_NEAR(wave_surface(steep.sum, 0.3, -0.4, 0.2 + T), wave_surface(steep.sum, 0.3, -0.4, 0.2), 1e-12);
        EXPECT_NEAR(steep.pressure_over_density(0.3, wave_surface(steep.sum, 0.3, 0, 0.2), 0.2), 0,
                    1e-8 * steep.bernoulli);
    }
}

}  // namespace oblique_wave_test
}  // namespace tw
