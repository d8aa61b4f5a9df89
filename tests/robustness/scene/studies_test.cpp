// The scenes that come with the program.
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "scene/scene.h"
#include "test_paths.h"

namespace tw {
namespace studies_test {

TEST(Studies, EveryReadySceneIsSound) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TWINWAKE_SOURCE) / "studies")) {
        if (entry.path().extension() != ".toml") continue;
        names.insert(entry.path().stem().string());
        EXPECT_NO_THROW({
            const Scene s = read_scene(entry.path());
            EXPECT_GT(predict(s, {{"sph", predict_particles}}).particles, 500) << entry.path();
            EXPECT_GT(s.run.duration, s.sampling.mean_from) << entry.path();
        }) << entry.path();
    }
    for (const char* name :
         {"demo", "planing_prism", "planing_plate", "planing_plate_thin", "seaplane_30", "seaplane_80",
          "seaplane_80_paper", "still_tank", "empty_channel", "dam_break_2d", "cup", "spheric02"})
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Studies, TheSeaplanesDifferInSpeedOnly) {
    const auto study = [](const std::string& name) {
        return read_scene(std::filesystem::path(TWINWAKE_SOURCE) / "studies" / name);
    };
    const Scene slow = study("seaplane_30.toml"), fast = study("seaplane_80.toml");
    EXPECT_EQ(slow.hull->hash, fast.hull->hash);
    EXPECT_EQ(slow.resolution.near_hull, fast.resolution.near_hull);
    EXPECT_EQ(slow.motion.speed, 30);
    EXPECT_EQ(fast.motion.speed, 80);
    EXPECT_NEAR(slow.hull->length, 36.9, 0.1);
}

}  // namespace studies_test
}  // namespace tw
