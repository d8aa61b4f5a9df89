#pragma once
#include <cmath>
#include <filesystem>
#include <limits>

#include "record/run_record.h"

namespace tw {

/// A record in which every field holds something, odd values included.
inline RunRecord example_record() {
    RunRecord r;
    r.attributes = {{"method", "sph"}, {"title", "a \"title\" with <script>, é and /"}, {"empty", ""}};
    r.numbers = {{"speed", 8.0}, {"third", 1.0 / 3.0}, {"tiny", 4.9e-324}};
    r.scene_text = std::string("title = \"x\"\n") + std::string(100000, '#');
    Table& forces = r.table("forces");
    for (int i = 0; i < 1000; ++i) forces.time.push_back(1e-3 * i + 1e-17);
    for (const char* name : {"fz", "fx", "a/b", ".", "a_b", "time"}) {
        Column& c = forces.column(name, "N");
        for (int i = 0; i < 1000; ++i) c.values.push_back(std::sin(0.1 * i) * 1e3);
    }
    forces.columns[0].values[7] = std::numeric_limits<double>::quiet_NaN();
    forces.columns[0].values[8] = -0.0;
    forces.columns[0].values[9] = std::numeric_limits<double>::infinity();
    forces.columns[0].values[10] = 4.9e-324;
    r.table("empty");
    r.raster = {{-1.5, 0.0, -0.25}, 0.1, {5, 4, 3}};
    for (int f = 0; f < 3; ++f) {
        RasterFrame frame{0.5 * f, {}};
        for (int i = 0; i < 60; ++i) frame.water.push_back(static_cast<std::uint8_t>((i * 37 + f) % 256));
        r.frames.push_back(frame);
    }
    r.hull.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.0 / 3.0}};
    r.hull.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    r.hull_pressure = {1.5f, -2.25f, 1e5f, std::numeric_limits<float>::quiet_NaN()};
    r.hull_wet = {0, 1, 0.5f, 0.25f};
    r.bodies = {{"body_torpedo", r.hull, {0.25, 1.0 / 3.0, 0}}, {"body_buoy", r.hull, {0, 0, -1}}};
    r.bodies[1].surface.points[3].z() = 0.1;
    r.phases = {{"set-up", 0.1, 0.2}, {"solving", 100.5, 199.75}};
    r.peak_memory = 1.5e9;
    r.elements = 123456;
    r.steps = 7890;
    r.effects = {{"air",
                  false,
                  true,
                  "because \"so\"",
                  "3 % of lift",
                  0.4,
                  {{"arrival", 0, 0.14, "-", "measured", ""}, {"peak", 0.01, 0.02, "Pa", "Ma^2", "particles"}}},
                 {"viscosity", true, false, "", "", 0}};
    r.validity_checks = {{"Mach number", "-", 0.31, 1, 0.25, {1, 2, -0.5}}, {"particles lost", "-", 0, 0, 0.5}};
    r.resolution = {{0.4, {{-1.5, 0, -0.25}, {2, 1, 0.5}}}, {0.2, {{-1, 0, -0.25}, {1.0 / 3.0, 0.5, 0.5}}}};
    r.state = "stopped";
    r.reason = "the user asked";
    return r;
}

/// An own empty folder under the system's temporary folder, removed with its content.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "twinwake_test_XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~ScratchFolder() { std::filesystem::remove_all(path_); }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace tw
