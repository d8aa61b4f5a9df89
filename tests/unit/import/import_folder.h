#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/errors.h"
#include "import/import.h"

namespace tw {

/// A folder with a scene, and what a user would put beside it.
class ImportTest : public testing::Test {
protected:
    std::filesystem::path folder =
        std::filesystem::temp_directory_path() /
        ("import_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" +
         std::to_string(::getpid()));

    void SetUp() override {
        std::filesystem::create_directories(folder);
        write("scene.toml", R"(title = "prism"
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
near_hull = "0.125 m"
[run]
duration = "2 s"
[sampling]
mean_from = "0.5 s"
[[probe]]
name = "gauge"
height = ["3 m", "0.5 m"]
[[probe]]
name = "keel"
pressure = ["1 m", 0, "-0.1 m"]
)");
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    /// The record of a mapping with this text behind the lines that every mapping has.
    RunRecord imported(const std::string& kind, const std::string& source, const std::string& rest) const {
        write("map.toml", "kind = \"" + kind + "\"\nname = \"towing tank\"\nsource = \"" + source +
                              "\"\nscene = \"scene.toml\"\n" + rest);
        return import_record(folder / "map.toml");
    }
    /// The same, when it is refused: the message, without the folder's name.
    std::string refusal(const std::string& kind, const std::string& source, const std::string& rest) const {
        try {
            imported(kind, source, rest);
        } catch (const InputError& e) { return without_folder(e.what()); }
        ADD_FAILURE() << "taken as sound: " << rest;
        return {};
    }
    std::string without_folder(std::string text) const {
        const std::string prefix = folder.string() + "/";
        for (std::size_t at = 0; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
        return text;
    }
};

inline bool says(const std::string& message, const std::string& part) {
    return message.find(part) != std::string::npos;
}

}  // namespace tw
