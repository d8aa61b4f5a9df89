#include "spray/flight/reach.h"

#include <gtest/gtest.h>

#include <numbers>

namespace tw::spray {
namespace reach_test {

const Vec3 gravity(0, 0, -9.81);

/// Height at which a throw at that speed passes the distance x, at its best elevation.
double highest_pass(double speed, double x) {
    double best = -1e300;
    for (int i = 1; i < 20000; ++i) {
        const double a = std::numbers::pi / 2 * i / 20000;
        const double t = x / (speed * std::cos(a));
        best = std::max(best, speed * std::sin(a) * t - 0.5 * 9.81 * t * t);
    }
    return best;
}

TEST(Reach, TheLeastSpeedJustPassesThePlace) {
    const Vec3 from(0.1, -0.2, 0.05);
    for (const double height : {0.3, 0.0, -0.5}) {
        const Vec3 to = from + Vec3(0.12, 0.16, height);  // 0.2 m aside
        const double v = least_speed(from, to, gravity);
        EXPECT_NEAR(highest_pass(v, 0.2), height, 1e-6);
        EXPECT_LT(highest_pass(0.99 * v, 0.2), height - 1e-3);
    }
    EXPECT_NEAR(least_speed(from, from + Vec3(0, 0, 0.4), gravity), std::sqrt(2 * 9.81 * 0.4), 1e-12);
    EXPECT_NEAR(least_speed(from, from - Vec3(0, 0, 0.4), gravity), 0, 1e-12);  // it falls there
}

TEST(Reach, CountsDropletsThatAreFastEnough) {
    const Vec3 to(0, 0, 1);  // 4.43 m/s from the origin
    const std::vector<Droplet> droplets{{{0, 0, 0}, {4, 0, 0}, 1e-3, 0},
                                        {{0, 0, 0}, {0, 5, 0}, 2e-3, 0},
                                        {{0, 0, 0.5}, {0, 0, 3.5}, 1e-3, 0}};  // 3.13 m/s from there
    const Reach r = reach(droplets, to, gravity);
    EXPECT_EQ(r.enough, 2u);
    EXPECT_NEAR(r.volume, sphere_volume(1e-3) + sphere_volume(2e-3), 1e-18);
    EXPECT_NEAR(r.least, std::sqrt(9.81), 1e-12);
    EXPECT_EQ(r.fastest, 5);
    EXPECT_NEAR(r.mean, (4 + 8 * 5 + 3.5) / 10, 1e-12);
    EXPECT_EQ(reach({}, to, gravity).least, 0);
}

}  // namespace reach_test
}  // namespace tw::spray
