// The water in a box, counted from the particles.
#include "sph_solver/measure/water_volumes.h"

#include <gtest/gtest.h>

#include "base/numbers.h"
#include "tests/run_of.h"
#include "tests/still_block_scene.h"

namespace tw {
namespace water_volumes_test {

TEST(WaterVolumes, AreThoseOfABlockThatTheBoxCutsThroughParticles) {
    constexpr double dp = 0.02;
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.state_equation.c0 = 10;
    s.domain = {Vec3(0, -1, 0), Vec3(0.8, 1, 0.4)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    Scene scene;
    scene.domain.dimensions = 2;
    scene.sampling.volumes = {{"all", {Vec3(-1, -infinite, -1), Vec3(2, infinite, 1)}},
                              {"cut", {Vec3(0.105, -infinite, 0.053), Vec3(0.32, infinite, 0.35)}},
                              {"dry", {Vec3(0.4, -infinite, 0), Vec3(0.8, infinite, 0.4)}}};
    Box water = s.domain;
    water.max.x() = 0.4, water.max.z() = 0.2;
    Simulation simulation(s, fill_levels(s, {water}));
    RunRecord record;
    record_volumes(simulation, scene, record);
    const auto volume = [&](const char* box) { return record.series(volume_table, box)->values.at(0); };
    EXPECT_EQ(record.series(volume_table, "all")->unit, "m3/m");
    EXPECT_NEAR(volume("all"), 0.4 * 0.2, 1e-12);
    EXPECT_NEAR(volume("cut"), (0.32 - 0.105) * (0.2 - 0.053), 1e-9);
    EXPECT_EQ(volume("dry"), 0);
}

TEST(WaterVolumes, OfARunAreNotTakenAwayByTheWeightThatCompressesParticles) {
    const RunRecord record = run_of(still_block_scene, "water_volumes_test");
    expect_volumes_of_still_block(record, 2e-4);  // half a particle's width along one face is 1.5e-3
}

}  // namespace water_volumes_test
}  // namespace tw
