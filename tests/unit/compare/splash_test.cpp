#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/compare.h"
#include "compare/metrics/elevation.h"
#include "compare/metrics/raster_columns.h"
#include "compare/metrics/splash.h"
#include "meshes/generate.h"
#include "record/raster.h"
#include "record/solid_at_rest.h"

namespace tw {
namespace splash_test {

constexpr double edge = 0.1;

/// A channel of still water, 4 x 2 m, voxels of 0.1 m, up to z = 0, with whatever is poured on top.
struct Channel {
    RasterSpec spec{{0, 0, -0.5}, edge, {40, 20, 20}};
    Raster raster{spec};
    Channel() { fill({0, 0, -0.5}, {4, 2, 0}); }
    /// A block of whole voxels.
    void fill(const Vec3& low, const Vec3& high) {
        for (double x = low.x() + edge / 2; x < high.x(); x += edge)
            for (double y = low.y() + edge / 2; y < high.y(); y += edge)
                for (double z = low.z() + edge / 2; z < high.z(); z += edge)
                    raster.pour({x, y, z}, edge, edge * edge * edge);
    }
    RunRecord record() const {
        RunRecord r;
        r.attributes["motion"] = "stream";
        r.numbers = {{"density", 1000}, {"gravity", 9.81}, {"speed", 8}};
        r.raster = spec;
        r.frames.push_back(raster.frame(1.0));
        return r;
    }
};
double at(const Table& t, const std::string& column) { return t.find(column)->values.at(0); }

TEST(Splash, StillWaterHasNone) {
    const Table t = splash_series(Channel().record(), 0);
    EXPECT_NEAR(at(t, "sheet_height"), 0, 1e-6);
    EXPECT_EQ(at(t, "airborne_volume"), 0);
    EXPECT_TRUE(std::isnan(at(t, "p95")));
}

TEST(Splash, AnAttachedSheetCountsToItsTop) {
    Channel c;
    c.fill({2, 1, 0}, {2.1, 1.5, 0.8});  // a wall of water 0.8 m high, one voxel thick, half a metre long
    const Table t = splash_series(c.record(), 0);
    EXPECT_NEAR(at(t, "sheet_height"), 0.8, 1e-5);
    // Airborne: above one voxel, 0.1 x 0.5 x 0.7 m3; evenly spread from 0.1 to 0.8 m.
    EXPECT_NEAR(at(t, "airborne_volume"), 0.035, 1e-9);
    EXPECT_NEAR(at(t, "p95"), 0.1 + 0.95 * 0.7, 1e-6);
    EXPECT_NEAR(at(t, "p99"), 0.1 + 0.99 * 0.7, 1e-6);
    EXPECT_NEAR(at(t, "airborne_energy"), 1000 * 9.81 * 0.035 * 0.45, 1e-4);
}

TEST(Splash, ADropIsNoSheetHoweverHigh) {
    Channel c;
    c.fill({1, 1, 1.0}, {1.1, 1.1, 1.1});
    const Table t = splash_series(c.record(), 0);
    EXPECT_NEAR(at(t, "sheet_height"), 0, 1e-6);
    EXPECT_NEAR(at(t, "raw_height"), 1.1, 1e-6);
    EXPECT_NEAR(at(t, "airborne_volume"), 1e-3, 1e-9);
    // A thread of half-full voxels down to the water makes the same drop part of a sheet.
    for (double z = 0.05; z < 1; z += edge) c.raster.pour({1.05, 1.05, z}, edge, 0.6 * edge * edge * edge);
    EXPECT_NEAR(at(splash_series(c.record(), 0), "sheet_height"), 1.1, 1e-5);
}

TEST(Splash, OfWaterThatReachesTheTopNoHeightIsGiven) {
    const auto sheet = [](double height) {
        Channel c;
        c.fill({2, 1, 0}, {2.1, 1.5, height});  // the raster ends at 1.5 m
        RunRecord r = c.record();
        r.attributes["motion"] = "none";
        r.attributes["method"] = "sph", r.attributes["scene_hash"] = "tank";
        r.attributes["symmetry_factor"] = "1";
        return compare_records({r});
    };
    const Comparison below = sheet(1.3), at_the_top = sheet(1.5);
    for (const char* name : {"splash_sheet_height", "splash_envelope"}) {
        const MeanValue lower = below.find(name)->values.front(), cut = at_the_top.find(name)->values.front();
        EXPECT_TRUE(lower.known) << name;
        EXPECT_NEAR(lower.value, 1.3, 0.05) << name;
        EXPECT_FALSE(cut.known) << name;
        EXPECT_NE(cut.why_not.find("water reaches the top, 1.49 m"), std::string::npos) << cut.why_not;
    }
}

TEST(Splash, OfATankIsTheLargestFromMeanFromOn) {
    Channel early, late;
    early.fill({2, 1, 0}, {2.1, 1.5, 1.2});
    late.fill({2, 1, 0}, {2.1, 1.5, 0.7});
    RunRecord r = early.record();
    r.frames.push_back(late.raster.frame(2.0));
    r.attributes["motion"] = "none";
    r.attributes["method"] = "sph", r.attributes["scene_hash"] = "tank", r.attributes["symmetry_factor"] = "1";
    const auto height = [](const RunRecord& record) {
        return compare_records({record}).find("splash_sheet_height")->values.front().value;
    };
    EXPECT_NEAR(height(r), 1.2, 0.05);
    r.numbers["mean_from"] = 1.5;
    EXPECT_NEAR(height(r), 0.7, 0.05);
}

TEST(Splash, WhatAMeshSmearsUpAHullIsNoWater) {
    const auto smeared = [](int share) {
        RunRecord r = Channel().record();
        for (const std::size_t column : {410u, 411u, 412u})  // voxels 1 m above still water
            r.frames[0].water[15u * 800u + column] = static_cast<std::uint8_t>(share);
        return splash_series(r, 0);
    };
    EXPECT_EQ(at(smeared(2), "airborne_volume"), 0);
    EXPECT_TRUE(std::isnan(at(smeared(2), "p95")));
    EXPECT_NEAR(at(smeared(3), "airborne_volume"), 3 * 3 / 255.0 * 1e-3, 1e-9) << "a hundredth of a voxel is water";
}

TEST(Splash, DiagonalNeighboursHangTogether) {
    for (const double dx : {-edge, edge})
        for (const double dy :
             {-edge, edge}) {  // a staircase of voxels that touch at corners only, in all four directions
            Channel c;
            for (int k = 0; k < 5; ++k)
                c.raster.pour({2.05 + k * dx, 1.05 + k * dy, (k + 0.5) * edge}, edge, edge * edge * edge);
            EXPECT_NEAR(at(splash_series(c.record(), 0), "sheet_height"), 0.5, 1e-5) << dx << " " << dy;
        }
}

/// Pours water up to `height(x, y)` above z = 0, in voxels that are part-filled at their bottom.
void pour_surface(Channel& c, auto&& height) {
    for (double x = edge / 2; x < 4; x += edge)
        for (double y = edge / 2; y < 2; y += edge)
            for (double z = edge / 2; z < 1.5; z += edge) {
                const double share = std::clamp((height(x, y) - (z - edge / 2)) / edge, 0.0, 1.0);
                if (share > 0) c.raster.pour({x, y, z}, edge, share * edge * edge * edge);
            }
}

TEST(Splash, AWaveIsNoneHoweverHigh) {
    // 0.4 m high and 4 m long, slope up to 17 degrees; then the same along the diagonal.
    for (const double across : {0.0, 1.0}) {
        Channel c;
        pour_surface(
            c, [&](double x, double y) { return 0.2 + 0.2 * std::cos(2 * std::numbers::pi / 4 * (x + across * y)); });
        const Table t = splash_series(c.record(), 0);
        EXPECT_EQ(at(t, "airborne_volume"), 0) << across;
        EXPECT_EQ(at(t, "sheet_height"), 0) << across;
        EXPECT_NEAR(at(t, "raw_height"), 0.4, 0.01) << "it is there";
    }
}

TEST(Splash, ASheetOnAWaveIsCountedFromTheWave) {
    Channel c;
    const auto wave = [](double x, double) { return 0.2 + 0.2 * std::cos(2 * std::numbers::pi / 4 * (x - 2)); };
    pour_surface(c, wave);
    c.fill({2, 1, 0.4}, {2.1, 1.5, 1.0});  // on the crest, 0.4 m
    const Table t = splash_series(c.record(), 0);
    EXPECT_NEAR(at(t, "sheet_height"), 1.0, 1e-5);
    EXPECT_NEAR(at(t, "airborne_volume"), 0.1 * 0.5 * (1.0 - 0.4 - edge), 5e-4);
}

TEST(Splash, WhatAMeshSmearsOverItsSurfaceCellIsNone) {
    Channel c;  // cells of three voxels' height, a third full over all of it
    for (double x = edge / 2; x < 4; x += edge)
        for (double y = edge / 2; y < 2; y += edge)
            for (double z = edge / 2; z < 0.3; z += edge) c.raster.pour({x, y, z}, edge, 0.33 * edge * edge * edge);
    RunRecord r = c.record();
    // The lowest of the three layers is the wave, what the voxel above holds belongs to it, and the third is counted.
    EXPECT_NEAR(at(splash_series(r, 0), "airborne_volume"), 4 * 2 * 0.33 * 0.1, 0.005) << "or this test sees nothing";
    r.numbers["spacing"] = 0.3;
    r.attributes["surface_cells"] = "none";
    EXPECT_EQ(at(splash_series(r, 0), "airborne_volume"), 0);
    r.attributes["surface_cells"] = "0.05 0 2 0 2";  // finer in one half: there it counts
    EXPECT_NEAR(at(splash_series(r, 0), "airborne_volume"), 2 * 2 * 0.33 * 0.1, 0.005);
}

TEST(Splash, AHullsSideInStillWaterMakesNone) {
    Channel full;
    RunRecord r = full.record();
    r.hull = make_hull("box", {{"length", 1.05}, {"beam", 0.45}, {"height", 0.4}});
    for (Vec3& p : r.hull.points) p += Vec3(2, 1, -0.2);
    pour_surface(full, [](double x, double) { return 0.15 * std::exp(-std::pow((x - 1.3) / 0.5, 2)); });  // a bow wave
    r.frames = {full.raster.frame(1.0)};
    const RasterGrid grid(r.raster);
    const auto covered = under_hull(grid, r.hull);
    for (int k = 3; k < grid.nz; ++k)  // the hull displaces the water from 0.2 m below still water up
        for (std::size_t column = 0; column < grid.columns(); ++column)
            if (covered[column]) r.frames[0].water[static_cast<std::size_t>(k) * grid.columns() + column] = 0;
    const Table t = splash_series(r, 0);
    EXPECT_EQ(at(t, "airborne_volume"), 0);
    EXPECT_EQ(at(t, "sheet_height"), 0);
}

TEST(Splash, HalfModelsReportTheWholeHullsVolume) {
    Channel c;
    c.fill({2, 1, 0}, {2.1, 1.5, 0.8});
    RunRecord r = c.record();
    r.attributes["symmetry_factor"] = "2";
    EXPECT_NEAR(at(splash_series(r, 0), "airborne_volume"), 0.07, 1e-9);
    EXPECT_NEAR(at(splash_series(r, 0), "sheet_height"), 0.8, 1e-5);
}

TEST(Splash, TheSameWaterOnAFinerParticleSpacingGivesTheSameNumbers) {
    Channel coarse, fine;
    coarse.fill({2, 1, 0}, {2.1, 1.5, 0.8});
    const double d = edge / 4;
    for (double x = 2 + d / 2; x < 2.1; x += d)
        for (double y = 1 + d / 2; y < 1.5; y += d)
            for (double z = d / 2; z < 0.8; z += d) fine.raster.pour({x, y, z}, d, d * d * d);
    const Table a = splash_series(coarse.record(), 0), b = splash_series(fine.record(), 0);
    for (const char* c : {"sheet_height", "p95", "p99", "p99_9", "airborne_volume", "airborne_energy"})
        EXPECT_NEAR(at(a, c), at(b, c), 1e-3 * at(a, c)) << c;
}

TEST(Splash, WaterRaisedBehindAHullIsAnIntegralPerMetreOfWay) {
    Channel c;
    RunRecord r = c.record();
    EXPECT_TRUE(std::isnan(at(splash_series(r, 0), "raised_area"))) << "no hull to be behind of";
    r.hull = make_hull("box", {{"length", 1.0}, {"beam", 0.4}, {"height", 0.4}});
    for (Vec3& p : r.hull.points) p += Vec3(0.98, 1, -0.1);  // its stern at 1.48 m: 25 columns of the raster behind it
    EXPECT_EQ(at(splash_series(r, 0), "raised_area"), 0);
    c.fill({0.3, 0, 0}, {0.5, 2, 0.3});   // ahead of it, where it does not count
    c.fill({2, 1, 0}, {2.1, 1.5, 0.8});   // a wall of water, 0.1 x 0.5 x 0.8 m3
    c.fill({3, 1, -0.2}, {3.1, 1.5, 0});  // below still water: there already
    for (double y = 0.05; y < 1; y += edge) c.raster.pour({3.55, y, 0.05}, edge, 0.3 * edge * edge * edge);
    r.frames = {c.raster.frame(1.0)};
    const Table t = splash_series(r, 0);
    const double wall = 0.1 * 0.5 * 0.8, skin = 0.1 * 1.0 * 0.03;  // the skin lies lower than the wall's lower half
    EXPECT_NEAR(at(t, "raised_area"), (wall + skin) / 2.5, 1e-4);
    EXPECT_NEAR(at(t, "raised_mean"), (wall * 0.4 + skin * 0.05) / (wall + skin), 1e-3);
    EXPECT_NEAR(at(t, "raised_p90"), 0.8 * (1 - 0.1 * (wall + skin) / wall), 1e-3);
    r.attributes["symmetry_factor"] = "2";
    EXPECT_NEAR(at(splash_series(r, 0), "raised_area"), 2 * (wall + skin) / 2.5, 2e-4);
    r.numbers["dimensions"] = 2;
    EXPECT_TRUE(std::isnan(at(splash_series(r, 0), "raised_area")));
}

TEST(Elevation, FlatWaterIsFlatAndABumpIsItsHeight) {
    Channel c;
    c.fill({1, 0, 0}, {2, 2, 0.3});
    for (double x = 3.05; x < 4; x += edge)  // a part-filled layer: water at 0.03 m
        for (double y = 0.05; y < 2; y += edge) c.raster.pour({x, y, 0.05}, edge, 0.3 * edge * edge * edge);
    RunRecord r = c.record();
    r.numbers["cut_y_0"] = 1.03;
    const auto cuts = elevation_cuts(r, mean_elevation(r, 0));
    ASSERT_EQ(cuts.size(), 1u);
    EXPECT_NEAR(cuts[0].elevation[5], 0, 1e-6);
    EXPECT_NEAR(cuts[0].elevation[15], 0.3, 1e-6);
    EXPECT_NEAR(cuts[0].elevation[35], 0.03, 5e-4);  // shares are stored in steps of 1/255
    EXPECT_NEAR(crest(cuts[0]).value, 0.3, 1e-6);
    EXPECT_NEAR(trough(cuts[0]).value, 0, 1e-6);
    EXPECT_NEAR(rms_difference(cuts[0], cuts[0]), 0, 1e-12);
}

TEST(Elevation, UnderTheHullThereIsNoFreeSurface) {
    Channel c;
    RunRecord r = c.record();
    r.hull = make_hull("box", {{"length", 1.0}, {"beam", 0.4}});
    for (Vec3& p : r.hull.points) p += Vec3(2, 1, 0);
    r.numbers["cut_y_0"] = 1.0;
    const auto cut = elevation_cuts(r, mean_elevation(r, 0)).at(0);
    EXPECT_TRUE(std::isnan(cut.elevation[20]));  // x = 2.05
    EXPECT_FALSE(std::isnan(cut.elevation[5]));
    EXPECT_FALSE(std::isnan(cut.elevation[35]));
}

TEST(WakeWidth, TwoWallsBehindTheHullAreAsFarApartAsTheyStand) {
    Channel c;
    c.fill({1, 0.4, 0}, {4, 0.5, 0.4});
    c.fill({1, 1.5, 0}, {4, 1.6, 0.4});
    RunRecord r = c.record();
    r.hull.points = {{0, 1, 0}, {1, 1, 0}};
    EXPECT_NEAR(wake_width(r, splash_envelope(r, 0), 0).mean, 1.2, 1e-9);
    r.attributes["symmetry_factor"] = "2";  // the half beyond y = 0 mirrored
    EXPECT_NEAR(wake_width(r, splash_envelope(r, 0), 0).mean, 3.2, 1e-9);
    EXPECT_EQ(wake_width(r, splash_envelope(r, 0), 0).clipped, 0);
    EXPECT_TRUE(std::isnan(wake_width(Channel().record(), {}, 0).mean));
}

/// A tank of still water up to z = 0 with a solid at rest, out of whose voxels the water is taken.
RunRecord with_solid(const Surface& surface) {
    RunRecord r = Channel().record();
    r.attributes["motion"] = "none";
    r.bodies.push_back({obstacle_table("bar"), surface, Vec3::Zero()});
    const SolidVoxels solid = solid_voxels(r);
    std::vector<std::uint8_t>& water = r.frames.front().water;
    for (std::size_t v = 0; v < water.size(); ++v)
        water[v] = static_cast<std::uint8_t>(std::min<int>(water[v], 255 - solid[v]));
    return r;
}
Surface box(const Vec3& low, const Vec3& high) {
    Surface s = make_hull("box", {{"length", 1.0}, {"beam", 1.0}});
    const Box b = s.bounds();
    for (Vec3& p : s.points) p = low.array() + (p - b.min).array() / b.size().array() * (high - low).array();
    return s;
}

TEST(Solids, TakeTheirShareOfVoxels) {
    RunRecord r = with_solid(box({1, 0.5, -0.33}, {1.5, 1.5, -0.1}));
    const SolidVoxels solid = solid_voxels(r);
    double volume = 0;
    for (const std::uint8_t s : solid) volume += s / 255.0 * edge * edge * edge;
    EXPECT_NEAR(volume, 0.5 * 1 * 0.23, 0.01 * 0.115);
    EXPECT_TRUE(solid_voxels(Channel().record()).empty());
}

TEST(Solids, ABarInStillWaterLeavesItsSurfaceWhereItIs) {
    for (const Surface& bar : {box({1, 0, -0.3}, {2, 2, -0.1}),      // under water
                               box({1, 0, -0.5}, {2, 2, -0.25})}) {  // on the bed
        RunRecord r = with_solid(bar);
        EXPECT_NEAR(still_level(r), 0, 1e-6);
        EXPECT_EQ(at(splash_series(r, still_level(r)), "sheet_height"), 0);
        for (const float z : mean_elevation(r, 0).mean) EXPECT_NEAR(z, 0, 1e-6);
        r.bodies.clear();  // or this test sees nothing
        EXPECT_LT(still_level(r), -0.04);
        const std::vector<float> hollow = mean_elevation(r, 0).mean;
        EXPECT_LT(std::ranges::min(hollow), -0.15);
    }
}

TEST(Solids, UnderOneThatLiesOnTheWaterThereIsNoFreeSurface) {
    const auto mean = mean_elevation(with_solid(box({1, 0, -0.2}, {2, 2, 0.3})), 0).mean;
    EXPECT_TRUE(std::isnan(mean[15]));
    EXPECT_NEAR(mean[5], 0, 1e-6);
}

TEST(Solids, ARoundTankHalfFullIsAtRest) {
    // what a round tank leaves of its box: here a wedge along one side
    Surface wedge = box({0, 0, -0.5}, {4, 1, 0.5});
    for (Vec3& p : wedge.points)
        if (p.z() > 0) p.y() = std::min(p.y(), 0.01);
    const RunRecord r = with_solid(wedge);
    EXPECT_NEAR(still_level(r), 0, 0.004);
    EXPECT_EQ(at(splash_series(r, still_level(r)), "sheet_height"), 0);
}

TEST(StillLevel, OfATankIsThatOfItsWaterSpreadOut) {
    RunRecord r = Channel().record();
    EXPECT_EQ(still_level(r), 0);
    r.attributes["motion"] = "none";
    EXPECT_NEAR(still_level(r), 0, 1e-9);
    Channel c;
    c.fill({0, 0, 0}, {2, 2, 0.4});  // half the tank 0.4 m higher
    r = c.record();
    r.attributes["motion"] = "none";
    EXPECT_NEAR(still_level(r), 0.2, 1e-9);
}

}  // namespace splash_test
}  // namespace tw
