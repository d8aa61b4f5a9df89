// Where the water is, by particles of two sizes: an edge between them is to be seen by nobody who looks at the water.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/numbers.h"
#include "sph_solver/measure/water_raster.h"

namespace tw {
namespace water_raster_test {

constexpr double coarse = 0.02, voxel = 0.04;
const RasterSpec spec{{0, -voxel / 2, 0}, voxel, {30, 1, 10}};

/// A stream of 1 m/s, to the right through a zone of half the size, in two dimensions and without gravity. It is longer
/// than the raster and `depth` [m] deep.
Simulation stream(double depth) {
    SimulationSetup s;
    s.dimensions = 2;
    s.gravity = Vec3::Zero();
    s.dp = coarse / 2;  // the finest
    s.state_equation.c0 = 10;
    s.domain = {Vec3(-voxel, -1, 0), Vec3(31 * voxel, 1, 10 * voxel)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, true}}};
    s.mirrors.periodic = {true, false, false};
    s.zones = {Zone({Box{Vec3(0.3, -infinite, 0.12), Vec3(0.7, infinite, 0.4)}})};
    Box water = s.domain;
    water.max.z() = depth;
    std::vector<Fluid> fluids = fill_levels(s, {water});
    for (Fluid& fluid : fluids) fluid.depth.assign(fluid.depth.size(), 0);
    Simulation simulation(s, fluids);
    for (const auto& level : simulation.levels()) std::ranges::fill(level->fields_to_set().u, 1.0f);
    return simulation;
}

// Particles that count leave a gap to those of the other size, or overlap them, by up to half a coarse spacing, a
// quarter of a voxel here, as the stream carries them over the edge.
TEST(WaterRaster, IsFullAcrossAnEdgeThatWaterCrosses) {
    Simulation simulation = stream(0.4);
    double next = 0;
    while (next < 3 * coarse) {
        while (simulation.time() < next) simulation.step();
        next += 0.23 * coarse;
        const RasterFrame f = water_raster(simulation, spec, voxel).frame(0);
        const auto least = std::ranges::min_element(f.water);
        const auto v = least - f.water.begin();
        EXPECT_GE(int{*least}, 253) << "column " << v % 30 << ", row " << v / 30 << " at " << simulation.time() << " s";
    }
}

TEST(WaterRaster, EndsAtTheSurfaceInBothSizes) {
    Simulation simulation = stream(0.28);
    const RasterFrame f = water_raster(simulation, spec, voxel).frame(0);
    for (std::size_t v = 0; v < f.water.size(); ++v)
        EXPECT_NEAR(f.water[v], v / 30 < 7 ? 255 : 0, 2) << v % 30 << ' ' << v / 30;
}

// A fine drop that has flown out of its zone over dry ground is nobody else's.
TEST(WaterRaster, ShowsFineSprayBeyondItsZone) {
    Simulation simulation = stream(0.28);
    Level& fine = *simulation.levels()[1];
    const FieldsToSet p = fine.fields_to_set();
    const auto drop = static_cast<std::size_t>(std::ranges::find(p.kind, Kind::fluid) - p.kind.begin());
    ASSERT_LT(drop, p.size());
    p.x[drop] = 1.02, p.z[drop] = 0.34;
    const RasterFrame f = water_raster(simulation, spec, voxel).frame(0);
    EXPECT_NEAR(f.water[8 * 30 + 25], 255 / 16.0, 1);
}

}  // namespace water_raster_test
}  // namespace tw
