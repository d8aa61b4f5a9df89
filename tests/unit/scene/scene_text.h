#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/errors.h"
#include "scene/scene.h"

namespace tw::test {

/// A fresh folder for the running test.
inline std::filesystem::path scratch() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const auto folder = std::filesystem::temp_directory_path() / "twinwake_scene_tests" /
                        (std::string(info->test_suite_name()) + "." + info->name());
    std::filesystem::create_directories(folder);
    return folder;
}

inline std::filesystem::path written(const std::string& text) {
    const auto file = scratch() / "scene.toml";
    std::ofstream(file) << text;
    return file;
}

inline Scene scene_of(const std::string& text, const SceneOverrides& overrides = {}) {
    return read_scene(written(text), overrides);
}

/// The message that reading `text` ends in, without the folder; empty when it is read without complaint.
inline std::string complaint(const std::string& text, const SceneOverrides& overrides = {}) {
    const auto file = written(text);
    try {
        read_scene(file, overrides);
    } catch (const InputError& e) {
        const std::string message = e.what(), folder = file.parent_path().string() + "/";
        return message.starts_with(folder) ? message.substr(folder.size()) : message;
    }
    return {};
}

/// The reference hull in a 20-line scene, as a user writes it.
inline const std::string planing = R"(title = "planing"
[hull]
shape    = "prismatic"
length   = "4 m"
beam     = "1 m"
deadrise = "20 deg"
trim     = "5 deg"
draft    = "0.2 m"
half     = true

[motion]
kind  = "stream"
speed = "8 m/s"

[resolution]
near_hull = "0.05 m"

[run]
duration = "1.5 s"
methods  = ["sph", "fvm"]
)";

/// `text` with the first `from` replaced by `to`.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the test's scene has no " + from);
    return text.replace(at, from.size(), to);
}

}  // namespace tw::test
