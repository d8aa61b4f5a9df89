// The elevation at a height probe, by what stands in its vertical line.
#include <gtest/gtest.h>

#include <cmath>

#include "meshes/generate.h"
#include "record/gauge_level.h"

namespace tw {
namespace gauge_level_test {

constexpr double size = 0.01;  // of cells [m]
const Stretch line{-0.2, 0.1};

/// Parts of half a size, full from `low` to `high` where no solid is.
std::vector<GaugePart> water(std::vector<Stretch> wet) {
    std::vector<GaugePart> parts;
    for (double z = line.low; z < line.high - 1e-9; z += size / 2) {
        const Stretch at{z, z + size / 2};
        double covered = 0;
        for (const Stretch& w : wet) covered += std::max(0.0, std::min(w.high, at.high) - std::max(w.low, at.low));
        parts.push_back({at, covered / at.length()});
    }
    return parts;
}
double level(const std::vector<Stretch>& solid, const std::vector<GaugePart>& parts) {
    return gauge_level(line, solid, parts, size);
}

TEST(GaugeLevel, IsTheWaterOnTheFloor) {
    EXPECT_NEAR(level({}, water({{-0.2, 0.013}})), 0.013, 1e-12);
    EXPECT_NEAR(level({}, water({})), -0.2, 1e-12) << "dry: the floor";
    EXPECT_NEAR(level({}, water({{-0.2, -0.1}, {0, 0.02}})), -0.08, 1e-12) << "thrown over, it counts with its volume";
}

TEST(GaugeLevel, StandsOnWhatIsUnderTheWater) {
    const std::vector<Stretch> bar{{-0.2, -0.1}};
    EXPECT_NEAR(level(bar, water({{-0.1, 0}})), 0, 1e-12);
    EXPECT_NEAR(level(bar, water({})), -0.1, 1e-12) << "a weir or slope that is dry: its top";
    EXPECT_NEAR(level(bar, water({{-0.1, -0.099}})), -0.099, 1e-12) << "a thin tongue is more than its top";
    EXPECT_NEAR(level({{-0.2, -0.103}}, water({{-0.2, 0}})), 0, 1e-12) << "a solid between the parts' limits";
    const std::vector<Stretch> drowned{{-0.15, -0.1}};
    EXPECT_NEAR(level(drowned, water({{-0.2, -0.15}, {-0.1, 0}})), 0, 1e-12);
}

TEST(GaugeLevel, ABinWhoseFloorStandsOffTheTanksShowsItsOwnWater) {
    const std::vector<Stretch> bin{{-0.05, -0.03}};
    EXPECT_NEAR(level(bin, water({{-0.03, 0.02}})), 0.02, 1e-12);
    EXPECT_NEAR(level(bin, water({{-0.2, -0.15}})), -0.15, 1e-12) << "while it is dry, the water under it";
    EXPECT_NEAR(level(bin, water({{-0.2, -0.15}, {-0.03, -0.028}})), -0.15, 1e-12) << "some drops are no water in it";
}

TEST(GaugeLevel, IsNotKnownWhereASolidLiesOnTheWater) {
    const std::vector<Stretch> afloat{{-0.04, 0.05}};
    EXPECT_TRUE(std::isnan(level(afloat, water({{-0.2, -0.04}}))));
    EXPECT_NEAR(level(afloat, water({{-0.2, -0.06}})), -0.06, 1e-12) << "under a deck the surface is free";
    EXPECT_NEAR(level(afloat, water({{-0.2, -0.04}, {0.05, 0.08}})), 0.08, 1e-12) << "green water on a deck";
    EXPECT_TRUE(std::isnan(level({{-0.3, 0.2}}, water({})))) << "a solid from the floor to the top";
    EXPECT_NEAR(level({}, water({line})), 0.1, 1e-12) << "a tank's own lid is no solid in the line";
}

TEST(GaugeLevel, NarrowGapsAreNone) {
    EXPECT_NEAR(level({{-0.196, -0.1}}, water({})), -0.1, 1e-12) << "a weir that stands a hair above the floor";
}

// Cells that a solid or a mesh that moves has taken away.
TEST(GaugeLevel, WhatIsNotKnownIsAsTheNearestKnownOfTheSameGap) {
    std::vector<GaugePart> parts = water({{-0.2, 0}});
    for (std::size_t k = 0; k < 21; ++k) parts[k].water = NAN;  // to -0.095
    for (std::size_t k = 50; k < parts.size(); ++k) parts[k].water = NAN;
    EXPECT_NEAR(level({{-0.2, -0.1}}, parts), 0, 1e-12);
    EXPECT_NEAR(level({}, parts), 0, 1e-12);
    for (GaugePart& p : parts) p.water = NAN;
    EXPECT_NEAR(level({}, parts), -0.2, 1e-12);
}

TEST(SolidColumn, IsWhatSurfacesTakeOfALineThatMeetsTheirEdgesToo) {
    const auto box = [](Vec3 low, Vec3 high) {
        const Vec3 size_of = high - low;
        Surface s = make_hull("box", {{"length", size_of.x()}, {"beam", size_of.y()}, {"height", size_of.z()}});
        const Vec3 shift = low - s.bounds().min;
        for (Vec3& p : s.points) p += shift;
        return s;
    };
    // y = 0 cuts both boxes along the diagonal of a face
    const Surface lower = box({0, -1, -2}, {2, 1, -1}), upper = box({1, -1, -1}, {3, 1, 0}),
                  apart = box({1.5, -1, 4}, {3, 1, 5});
    const auto at = [&](double x) {
        SolidColumn column(x, 0);
        for (const Surface* s : {&apart, &lower, &upper}) column.add(*s);
        return column.stretches();
    };
    EXPECT_TRUE(at(-0.1).empty());
    ASSERT_EQ(at(0.5).size(), 1u);
    EXPECT_NEAR(at(0.5)[0].low, -2, 1e-12);
    EXPECT_NEAR(at(0.5)[0].high, -1, 1e-12);
    const auto both = at(1.75);
    ASSERT_EQ(both.size(), 2u) << "one that stands on the other, and one above";
    EXPECT_NEAR(both[0].high, 0, 1e-12);
    EXPECT_NEAR(both[1].low, 4, 1e-12);
}

TEST(SolidColumn, FollowsASlope) {
    Surface wedge = make_hull("wedge", {{"width", 2}, {"span", 2}, {"deadrise", 0.5}, {"side_height", 0.1}});
    SolidColumn column(0.5, 0.1);
    column.add(wedge);
    const auto solid = column.stretches();
    ASSERT_EQ(solid.size(), 1u);
    const double keel = wedge.bounds().min.z();
    EXPECT_NEAR(solid[0].low, keel + 0.5 * std::tan(0.5), 1e-9);
    EXPECT_NEAR(solid[0].high, wedge.bounds().max.z(), 1e-12);
}

}  // namespace gauge_level_test
}  // namespace tw
