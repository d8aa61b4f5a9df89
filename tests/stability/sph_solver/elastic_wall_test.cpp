// A dam break that strikes a wall of rubber, which bends and throws it against the far side of the tank.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "sph_solver/scene_setup.h"
#include "test_paths.h"

namespace tw {
namespace elastic_wall_test {

struct Worst {
    double mach = 0, compression = 0;
};
/// Of the study at 6 mm, until the sheet has struck the far side, with so many times the default sound speed.
Worst worst_of_study(double sound_speed) {
    SceneOverrides coarse;
    coarse.near_hull = 0.006;
    coarse.sound_speed_factor = sound_speed;
    const Scene scene = read_scene(std::filesystem::path(TWINWAKE_SOURCE) / "studies/elastic_wall.toml", coarse);
    SphSetup setup = sph_setup(scene, 1);
    Simulation run(setup.simulation, setup.fluid);
    Worst worst;
    while (run.time() < 0.36) {
        run.step();
        worst.mach = std::max(worst.mach, run.extremes().speed / scene.sph.c0);
        worst.compression = std::max(worst.compression, run.extremes().density_deviation_high / run.setup().rho0);
    }
    std::printf("%.3g times the default sound speed: Mach number %.3f, compression %.1f %%\n", sound_speed, worst.mach,
                100 * worst.compression);
    return worst;
}

TEST(ElasticWall, KeepsTheValidityCheckssLimitsWithTheDefaultSoundSpeed) {
    const Worst with_default = worst_of_study(1), with_ten_falls = worst_of_study(0.25);
    EXPECT_LT(with_default.mach, trusted_mach);
    EXPECT_LT(with_default.compression, trusted_compression);
    EXPECT_GT(with_ten_falls.mach, trusted_mach) << "or the default need not be so large";
    EXPECT_GT(with_ten_falls.compression, trusted_compression);
}

}  // namespace elastic_wall_test
}  // namespace tw
