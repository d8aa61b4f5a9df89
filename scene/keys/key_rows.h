#pragma once
#include "scene/scene_key.h"

namespace tw {

// The rows of each section (scene/keys/keys.h), without its name: those of what stands in the water, and those of the
// water and of the run.

std::vector<SceneKey> hull_keys();
std::vector<SceneKey> tank_keys();
std::vector<SceneKey> obstacle_keys();
std::vector<SceneKey> body_keys();
std::vector<SceneKey> ply_keys();
std::vector<SceneKey> gauge_keys();

std::vector<SceneKey> water_keys();
std::vector<SceneKey> motion_keys();
std::vector<SceneKey> wave_keys();
std::vector<SceneKey> resolution_keys();
std::vector<SceneKey> domain_keys();
std::vector<SceneKey> run_keys();
std::vector<SceneKey> sampling_keys();
std::vector<SceneKey> probe_keys();
std::vector<SceneKey> volume_keys();
std::vector<SceneKey> measured_keys();
std::vector<SceneKey> water_block_keys();
std::vector<SceneKey> refine_keys();
std::vector<SceneKey> sph_keys();
std::vector<SceneKey> fvm_keys();

}  // namespace tw
