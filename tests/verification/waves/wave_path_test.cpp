// Where water goes under a wave, and where the water behind it is: how particles that enter with a wave are placed.
#include "waves/wave_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "waves/regular_wave.h"

namespace tw {
namespace wave_path_test {

constexpr double U = 1.9;
const RegularWave& wave() {
    static const RegularWave w =
        regular_wave({.height = 0.06, .length = 1, .depth = 0.4, .closed = false, .stream = U});
    return w;
}

struct Place {
    double x, z;
};
Place behind(Place at, double t, double way) {
    go_behind(in_stream(wave()), {t, 1, U}, way, at.x, at.z);
    return at;
}
Place later(Place at, double t, double time) {
    constexpr int steps = 40;
    const double dt = time / steps;
    for (int i = 0; i < steps; ++i, t += dt)
        go_with_water(in_stream(wave()), {t, 1, U}, {t + dt / 2, 1, U}, {t + dt, 1, U}, at.x, at.z);
    return at;
}
double surface(double x, double t) { return wave_surface(wave().sum, x, t); }

TEST(WavePath, OfTheSurfaceStaysThereAndOfTheFloorToo) {
    const Place top = behind({0.2, surface(0.2, 0.1)}, 0.1, 0.15), floor = behind({0.2, -0.4}, 0.1, 0.15),
                moved = later({0.2, surface(0.2, 0.1)}, 0.1, 0.12);
    EXPECT_NEAR(top.z, surface(top.x, 0.1), 1e-7);
    EXPECT_NEAR(floor.z, -0.4, 1e-12);
    EXPECT_NEAR(moved.z, surface(moved.x, 0.22), 1e-7);
    EXPECT_LT(top.x, 0.08);
}

// Water that is behind other water comes to where that was, as the crests have gone on in the meantime: both are on one
// streamline, and it does not matter which of the two is done first.
TEST(WavePath, BehindAndLaterIsLaterAndBehind) {
    const Place start{0.33, -0.05}, one = later(behind(start, 0.07, 0.1), 0.07, 0.09),
                                    other = behind(later(start, 0.07, 0.09), 0.16, 0.1);
    EXPECT_NEAR(one.x, other.x, 1e-8);
    EXPECT_NEAR(one.z, other.z, 1e-8);
}

// Between a line of water from the floor to the surface and the line behind it is as much water as without the wave.
TEST(WavePath, TheWaterBetweenTwoLinesIsThatOfTheirWay) {
    constexpr double way = 0.12, t = 0.05;
    constexpr int rows = 400;
    for (const double x : {0.0, 0.21, 0.5, 0.8}) {
        std::vector<Place> line, back;
        for (int i = 0; i <= rows; ++i) {
            line.push_back({x, -0.4 + (0.4 + surface(x, t)) * i / rows});
            back.push_back(behind(line.back(), t, way));
        }
        double area = 0;  // of the polygon by its corners: up `line`, along the surface, down `back`, along the floor
        std::vector<Place> all = line;
        for (int i = 1; i < 40; ++i) all.push_back(behind(line.back(), t, way * i / 40));
        for (int i = rows; i >= 0; --i) all.push_back(back[static_cast<std::size_t>(i)]);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Place &a = all[i], &b = all[(i + 1) % all.size()];
            area += (a.x * b.z - b.x * a.z) / 2;
        }
        EXPECT_NEAR(std::abs(area) / (way * 0.4), 1, 2e-5) << x;
        // a lattice that takes no notice of the wave would be short or over by the level
        if (x == 0) { EXPECT_GT(way * (0.4 + surface(x, t)) / (way * 0.4), 1.03); }
    }
}

}  // namespace wave_path_test
}  // namespace tw
