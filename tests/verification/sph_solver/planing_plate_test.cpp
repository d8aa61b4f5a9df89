// A hull of a two-dimensional scene: a flat plate in a weightless channel, whose force is known exactly (free
// streamlines, tests/data/planing_plate_channel.csv). The scene's way to the engine is held against the engine fed by
// hand, and the three measures of the force, each of which knows the metre of span in its own way, against one another.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "prism.h"
#include "sph_solver/run_sph.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace planing_plate_test {

constexpr double alpha = std::numbers::pi / 6, z_te = -0.101338, exact = 98723.5;  // [rad], [m], [N/m]

const char* const text = R"(
[hull]
shape = "plate"
length = "4 m"
trim = "30 deg"
draft = "0.101338 m"
position = [-1.7320508075688772, 0]
[water]
depth = "1 m"
[motion]
speed = "10 m/s"
ramp = "0.05 s"
[effects]
gravity = "off"
[resolution]
near_hull = 0.08333333333333333
[domain]
dimensions = 2
x = ["-6 m", "4 m"]
z = ["-1 m", "2.5 m"]
[run]
duration = "3.6 s"
[sampling]
interval = "0.1 s"
)";

/// Force normal to the plate [N/m], mean of [from, to].
double normal_force(const RunRecord& r, const std::string& suffix, double from, double to) {
    const Table& f = r.tables.at("forces");
    const Column &fx = *f.find("fx" + suffix), &fz = *f.find("fz" + suffix);
    double sum = 0, n = 0;
    for (std::size_t i = 0; i < f.time.size(); ++i)
        if (f.time[i] >= from && f.time[i] <= to && std::isfinite(fx.values[i]))
            sum += fz.values[i] * std::cos(alpha) + fx.values[i] * std::sin(alpha), ++n;
    return sum / n;
}

/// The same from an engine set up by hand, mean of the time after `from`.
double by_hand(double from, double to) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 1.0 / 12;
    s.state_equation.c0 = 100;
    s.gravity = Vec3::Zero();
    s.domain = {Vec3(-6, -1, -1), Vec3(4, 1, 2.5)};
    s.mirrors.on = {{{false, false}, {false, false}, {true, false}}};
    s.stream = Stream{10, 0.05, std::ceil(2 * s.h_over_dp + 2) * s.dp};
    s.threads = 1;
    const double L = 4, d = 0.3, c = std::cos(alpha), a = std::sin(alpha);
    s.bodies = {prism_along_y(
        {{-L * c, z_te + L * a}, {0, z_te}, {d * a, z_te + d * c}, {-L * c + d * a, z_te + L * a + d * c}}, 30)};
    Box water = s.domain;
    water.max.z() = 0;
    water.min.x() -= s.stream->buffer;
    water.max.x() += s.stream->buffer;
    Fluid fluid = fill_with_fluid(s, {water});
    for (double& depth : fluid.depth) depth = 0;
    Simulation simulation(s, fluid);
    double sum = 0, n = 0;
    while (simulation.time() < to) {
        simulation.step();
        if (simulation.time() < from) continue;
        const Vec3 force = simulation.load().force;
        sum += force.z() * c + force.x() * a, ++n;
    }
    return sum / n;
}

TEST(PlaningPlate, ASceneGivesTheEnginesForcePerMetreOfSpanByThreeMeasures) {
    const auto folder = std::filesystem::temp_directory_path() / "planing_plate_scene";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "scene.toml") << text;
    RunOptions options;
    options.folder = folder / "sph";
    options.threads = 1;
    const Scene scene = read_scene(folder / "scene.toml");
    const RunRecord record = run_sph(scene, options);
    ASSERT_EQ(record.state, "finished") << record.reason;
    EXPECT_EQ(record.tables.at("forces").find("fz")->unit, "N/m");

    const double early = normal_force(record, "", 0.5, 1.5), hand = by_hand(0.5, 1.5);
    const double N = normal_force(record, "", 2.2, 3.6), surface = normal_force(record, "_surface", 2.2, 3.6),
                 volume = normal_force(record, "_volume", 2.2, 3.6);
    std::printf(
        "N 0.5 to 1.5 s: %.0f N/m, by hand %.0f; 2.2 to 3.6 s: %.0f, surface %.0f, volume %.0f, exact %.0f N/m\n",
        early, hand, N, surface, volume, exact);
    EXPECT_NEAR(early / hand, 1, 0.05);  // found 0.97: the spray of the start is not the same in both
    EXPECT_NEAR(N / exact, 1, 0.1) << "12 spacings in the depth";
    EXPECT_NEAR(surface / N, 1, 0.05);
    EXPECT_NEAR(volume / N, 1, 0.03);  // found 0.998
    EXPECT_NEAR(record.hull.bounds().size().y(), 1, 1e-12);
    const Column& wet = *record.tables.at("samples").find("wetted_length");
    EXPECT_NEAR(wet.values.back(), 4 * std::cos(alpha), 1.2) << "jet and root, along the plate";
    std::filesystem::remove_all(folder);
}

}  // namespace planing_plate_test
}  // namespace tw
