// A wave that strikes a block standing on the floor, by particles of two sizes whose finer level is dry at first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sph_solver/scene_setup.h"
#include "test_paths.h"

namespace tw {
namespace obstacle_test {

// Water crept in between the floor and the block's face on it, and was pressed there to 1.4 times its density, because
// no dummies stood beyond the floor.
TEST(BlockOnTheFloor, LetsNoWaterUnderIt) {
    SceneOverrides sizes;
    sizes.near_hull = 0.025;
    sizes.spacing = 0.05;
    const Scene scene = read_scene(std::filesystem::path(TWINWAKE_SOURCE) / "studies/spheric02.toml", sizes);
    ASSERT_EQ(scene.sph.levels, 2);
    SphSetup setup = sph_setup(scene, 1);
    Simulation run(setup.simulation, setup.fluid);
    const Box block = scene.obstacles[0].surface.bounds();
    const double dp = scene.resolution.near_hull;
    std::size_t impulses = 0;
    while (run.time() < 0.65) {
        run.step();
        const Particles& p = run.finest().fields().particles();
        impulses = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!is_active(p.kind[i])) continue;
            const Vec3 x(p.x[i], p.y[i], std::abs(p.z[i]));
            const Vec3 inside = (x - block.min).cwiseMin(block.max - x);
            const double depth = std::min({inside.x(), inside.y(), block.max.z() - x.z()});  // the floor is no way in
            ASSERT_LT(depth, 0.5 * dp) << "t = " << run.time() << " s, " << x.transpose();
            impulses += x.x() > block.max.x() && x.x() < block.max.x() + 2 * dp && std::abs(x.y() - 0.5) < 0.2;
        }
    }
    EXPECT_GT(impulses, 50u) << "or the wave has not come";
}

}  // namespace obstacle_test
}  // namespace tw
