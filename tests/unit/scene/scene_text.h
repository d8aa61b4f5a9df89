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

/// Of both methods, as on the machine of the throughput table.
inline Prediction predict(const Scene& scene) {
    return tw::predict(scene, {{"sph", predict_particles}, {"fvm", predict_cells}});
}

/// Particles of one size, whatever the scene would have without it.
inline const std::string one_size = "\n[sph]\nlevels = 1\n";

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

/// A sheet of 0.4 m by `breadth` about the origin in Abaqus's format, 4 by 2 elements; its short ends are the set ENDS.
inline std::string sheet_mesh(double breadth) {
    std::string nodes = "*NODE\n", elements = "*ELEMENT, TYPE=S4\n", ends = "*NSET, NSET=ENDS\n";
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 5; ++i) {
            const int n = 1 + i + 5 * j;
            nodes += std::to_string(n) + ", " + std::to_string(0.1 * i - 0.2) + ", " +
                     std::to_string(breadth * (j - 1) / 2) + ", 0\n";
            if (i == 0 || i == 4) ends += std::to_string(n) + "\n";
            if (i < 4 && j < 2)
                elements += std::to_string(100 + n) + ", " + std::to_string(n) + ", " + std::to_string(n + 1) + ", " +
                            std::to_string(n + 6) + ", " + std::to_string(n + 5) + "\n";
        }
    return nodes + elements + ends;
}

inline const std::string tyre_scene = R"(title = "tyre"
[tank]
min = [-0.3, -0.3, -0.02]
max = [0.3, 0.3, 0.4]
[[water_block]]
min = [-0.1, -0.1, -0.02]
max = [0.1, 0.1, 0]
[[body]]
name = "tyre"
elastic = "tyre"
mass = "10 kg"
draft = "-4 mm"
cells = [16, 8]
[[gauge]]
name = "crown"
position = [0, 0, "4 mm"]
[motion]
kind = "none"
[resolution]
near_hull = "4 mm"
[run]
duration = 0.03
methods = ["sph"]
)";

/// A laminate in a frame that falls, with a strain gauge.
inline const std::string dropped = R"(title = "dropped plate"
[tank]
min = [-1, -1, -1]
max = [1, 1, 1]
[[ply]]
name = "C"
thickness = "1 mm"
E1 = "60 GPa"
E2 = "10 GPa"
nu12 = 0.25
G12 = "4 GPa"
density = "1500 kg/m3"
[[body]]
name = "laminate"
elastic = "plate"
plate = ["0.4 m", "0.2 m"]
cells = [8, 4]
middle = [0, 0, "0.5 m"]
layup = "[0 C/90 C]s"
carried = ["x_min", "x_max", "y_min", "y_max"]
mass = "5 kg"
velocity = [0, 0, "-2 m/s"]
[[gauge]]
name = "strain"
position = ["30 mm", 0, "0.5 m"]
direction = [1, 0, 0]
[motion]
kind = "none"
[resolution]
near_hull = "20 mm"
[run]
duration = 1
methods = ["sph"]
)";

}  // namespace tw::test
