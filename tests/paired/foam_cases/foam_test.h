#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "foam_cases/doctor.h"
#include "foam_cases/run_fvm.h"
#include "test_paths.h"

namespace tw {

/// Puts the environment that a test has changed back.
class EnvironmentGuard {
public:
    ~EnvironmentGuard() {
        for (const auto& [name, value] : saved_)
            value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
    }

private:
    static std::map<std::string, std::optional<std::string>> now() {
        std::map<std::string, std::optional<std::string>> values;
        for (const char* name :
             {"PATH", "HOME", "WM_PROJECT_DIR", "TWINWAKE_OPENFOAM_BIN", "TWINWAKE_OPENFOAM_PLACES"}) {
            const char* value = std::getenv(name);
            values[name] = value == nullptr ? std::nullopt : std::optional<std::string>(value);
        }
        return values;
    }
    std::map<std::string, std::optional<std::string>> saved_ = now();
};

/// Runs with the real OpenFOAM: the mended solvers of the source tree unless the environment names others. Skipped
/// where no OpenFOAM is installed at all (bootstrap.sh --no-openfoam); a faulty one is a failure.
class FoamTest : public testing::Test {
    EnvironmentGuard environment_;

protected:
    std::filesystem::path folder = std::filesystem::temp_directory_path() / ("foam_run_" + std::to_string(::getpid()));
    void SetUp() override {
        ::setenv("TWINWAKE_OPENFOAM_BIN", TWINWAKE_SOURCE "/.openfoam/bin", 0);
        if (find_openfoam().empty()) GTEST_SKIP() << "no OpenFOAM is installed";
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    Scene scene(const std::string& text) const {
        std::ofstream(folder / "scene.toml") << text;
        return read_scene(folder / "scene.toml");
    }
    RunOptions options() const {
        RunOptions o;
        o.folder = folder / "fvm";
        o.threads = 1;
        return o;
    }
};

/// Koshizuka & Oka's column, ten cells wide.
inline std::string dam_break(const std::string& duration, const std::string& interval = "0.02 s") {
    return R"(
title = "dam break"
[tank]
size = ["0.584 m", "14.6 mm", "0.4 m"]
[domain]
dimensions = 2
[[water_block]]
min = [0, 0, 0]
max = ["0.146 m", "14.6 mm", "0.292 m"]
[motion]
kind = "none"
[resolution]
near_hull = "14.6 mm"
[[probe]]
name = "wall"
pressure = [0.0, 0, 0.0]
[[probe]]
name = "column"
height = [0.07, 0]
[sampling]
interval = ")" +
           interval + R"("
[run]
duration = ")" +
           duration + "\"\n";
}

/// A box under water in a small tank: a hull whose mesh takes a second.
inline std::string drowned_box(const std::string& duration, const std::string& interval) {
    return R"(
title = "drowned box"
[hull]
shape  = "box"
length = 0.4
beam   = 0.4
height = 0.4
draft  = 0.7
[tank]
min = [-0.8, -0.8, -1.2]
max = [0.8, 0.8, 0.6]
[motion]
kind = "none"
[resolution]
near_hull = 0.1
[[probe]]
name = "floor"
pressure = [0.6, 0.6, -0.95]
[sampling]
interval = )" +
           interval + "\n[run]\nduration = " + duration + "\n";
}

/// A body in a tank of two dimensions, cells of 20 mm at it; `min` and `max` are the tank's corners.
inline std::string body_in_tank(const std::string& min, const std::string& max, const std::string& body,
                                const std::string& duration) {
    return "[tank]\nmin = " + min + "\nmax = " + max + "\n[domain]\ndimensions = 2\n[[body]]\n" + body + R"(
[motion]
kind = "none"
[resolution]
near_hull = "20 mm"
[run]
duration = ")" +
           duration + "\"\n";
}

inline double mean(const Column& c, std::size_t from) {
    double sum = 0;
    for (std::size_t i = from; i < c.values.size(); ++i) sum += c.values[i];
    return sum / static_cast<double>(c.values.size() - from);
}

}  // namespace tw
