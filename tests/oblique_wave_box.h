#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "compare/metrics/regular_wave.h"
#include "scene/scene.h"

namespace tw {

/// An empty box in a stream of 0.4 m/s that waves of 1 m cross at 60 degrees, 40 sizes long and four high, with gauges on a
/// cross. So that a run takes a minute zones are `width` wide [m] in place of the 1.5 m that a scene's own have, and the
/// kernel is narrower: how well a scene's zones make a wave is in docs/results/wave_in_stream.md.
inline Scene oblique_wave_box(const std::filesystem::path& folder, double duration, double width) {
    std::filesystem::create_directories(folder);
    std::ofstream text(folder / "scene.toml");
    text << "[motion]\nkind = \"stream\"\nspeed = 0.4\n[domain]\nx = [-0.15, 0.15]\ny = [-0.15, 0.15]\nz = [-0.25, "
            "0.1]\n[water]\ndepth = 0.25\n[resolution]\nnear_hull = 0.025\n[wave]\nheight = 0.1\nlength = "
            "1\ndirection = \"60 deg\"\n[sph]\nh_over_dp = 1.5\nc0 = 7\n[fvm]\nmax_courant = 0.4\nmax_alpha_courant = "
            "0.4\n[sampling]\ninterval = 0.02\n[run]\nduration = "
         << duration << "\n";
    for (const auto& [name, place] : std::map<std::string, std::string>{{"middle", "[0, 0]"},
                                                                        {"x_low", "[-0.1, 0]"},
                                                                        {"x_high", "[0.1, 0]"},
                                                                        {"y_low", "[0, -0.1]"},
                                                                        {"y_high", "[0, 0.1]"}})
        text << "[[probe]]\nname = \"" << name << "\"\nheight = " << place << "\n";
    text.close();
    Scene scene = read_scene(folder / "scene.toml");
    for (int axis = 0; axis < 2; ++axis) {
        scene.domain.box.min[axis] = scene.domain.undamped.min[axis] - width;
        scene.domain.box.max[axis] = scene.domain.undamped.max[axis] + width;
    }
    return scene;
}

/// Of the last whole period, by first harmonics at the gauges: height over that of theory within 0.15 of `height`, phase
/// behind it within 0.3 of `late` [rad], direction within 8 degrees.
inline void expect_the_oblique_wave(const Scene& scene, const RunRecord& record, double height, double late) {
    ASSERT_EQ(record.state, "finished") << record.reason;
    const RegularWave& wave = *scene.wave;
    const double omega = wave.encounter_frequency(), k = wave.k();
    const Table& table = record.tables.at("height");
    std::map<std::string, std::complex<double>> found;
    for (const HeightProbe& gauge : scene.sampling.height) {
        const std::vector<double>& levels = table.find(gauge.name)->values;
        std::vector<double> t, x;
        for (std::size_t i = 0; i < table.time.size(); ++i)
            if (table.time[i] > table.time.back() - wave.encounter_period())
                t.push_back(table.time[i]), x.push_back(levels[i]);
        const double way = wave.sum.direction * gauge.x + wave.sum.across * gauge.y;
        found[gauge.name] = first_harmonic(t, x, omega);
        const auto over = found[gauge.name] / (wave.sum.eta[0] * std::polar(1.0, k * way));
        std::printf("%s: height %.3f of that of theory, late by %.1f degrees\n", gauge.name.c_str(), std::abs(over),
                    std::arg(over) * 180 / std::numbers::pi);
        EXPECT_NEAR(std::abs(over), height, 0.15) << gauge.name;
        EXPECT_NEAR(std::arg(over), late, 0.3) << gauge.name;
    }
    const auto turns = [&](const std::string& axis) {  // of the phase along it [rad]
        return std::arg(found[axis + "_high"] / found[axis + "_low"]);
    };
    const double towards = std::atan2(turns("y"), turns("x")) * 180 / std::numbers::pi;
    std::printf("towards %.1f degrees, %.3f of its length\n", towards, 0.2 * k / std::hypot(turns("x"), turns("y")));
    EXPECT_NEAR(towards, 60, 8);
}

}  // namespace tw
