#pragma once
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "sph_solver/run_sph.h"

namespace tw {

/// The whole run of a scene on one thread, in a folder of this name that is removed again.
inline RunRecord run_of(const std::string& scene, const std::string& name) {
    const auto folder = std::filesystem::temp_directory_path() / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "scene.toml") << scene;
    RunOptions options;
    options.folder = folder / "sph";
    options.threads = 1;
    RunRecord record = run_sph(read_scene(folder / "scene.toml"), options);
    std::filesystem::remove_all(folder);
    return record;
}

}  // namespace tw
