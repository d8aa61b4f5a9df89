// A hull in a stream, free in heave and pitch, through whole runs of the particle method.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/hull_motion.h"
#include "sph_solver/run_sph.h"
#include "test_paths.h"

namespace tw {
namespace free_hull_test {

std::filesystem::path folder_of(const std::string& name) {
    const auto folder = std::filesystem::temp_directory_path() / "twinwake_free_hull" / name;
    std::filesystem::create_directories(folder);
    return folder;
}
RunRecord run(const std::string& name, const Scene& scene, int threads) {
    RunOptions options;
    options.folder = folder_of(name) / fmt::format("{}_threads", threads);
    options.overwrite = true;
    options.threads = threads;
    return run_sph(scene, options);
}
RunRecord run(const std::string& name, const std::string& text, int threads) {
    write_text_atomically(folder_of(name) / "scene.toml", text);
    return run(name, read_scene(folder_of(name) / "scene.toml"), threads);
}

const std::vector<double>& column(const RunRecord& r, const char* name) {
    return r.tables.at(hull_motion_table).find(name)->values;
}
double mean_between(const RunRecord& r, const char* name, double from, double to) {
    const Table& t = r.tables.at(hull_motion_table);
    double sum = 0, time = 0;
    for (std::size_t i = 1; i < t.time.size(); ++i)
        if (t.time[i] >= from && t.time[i] < to) {
            const double dt = t.time[i] - t.time[i - 1];
            sum += dt * t.find(name)->values[i];
            time += dt;
        }
    return sum / time;
}

double mean_from(const RunRecord& r, const char* name, double from) { return mean_between(r, name, from, 1e300); }

/// What a column swings round: its mean between two times under a bell, sin^2, over two swings or more. In a plain mean
/// a swing that the window cuts off counts as much as a whole one.
double swings_round(const RunRecord& r, const char* name, double from, double to) {
    const Table& t = r.tables.at(hull_motion_table);
    double sum = 0, weight = 0;
    for (std::size_t i = 1; i < t.time.size(); ++i) {
        if (t.time[i] < from || t.time[i] > to) continue;
        const double bell = std::pow(std::sin(std::numbers::pi * (t.time[i] - from) / (to - from)), 2);
        sum += bell * (t.time[i] - t.time[i - 1]) * t.find(name)->values[i];
        weight += bell * (t.time[i] - t.time[i - 1]);
    }
    return sum / weight;
}

/// A box 0.4 m long and 0.2 m high as heavy as 0.1 m of draft, its mass 8 mm aft of its middle: it floats with its bow
/// up by 2 degrees. It starts level, and the stream is so slow that its dynamic pressure is below a hundredth of the
/// draft.
std::string box_in_a_slow_stream(const std::string& spacing, double mass, double duration) {
    return fmt::format(R"(
[hull]
shape  = "box"
length = "0.4 m"
beam   = "0.3 m"
height = "0.2 m"
draft  = "0.1 m"
free   = ["heave", "pitch"]
mass   = {}
lcg    = "0.192 m"
vcg    = "0.08 m"
pitch_gyradius = "0.12 m"
[motion]
kind  = "stream"
speed = "0.1 m/s"
ramp  = "0.2 s"
[domain]
dimensions = 2
x = ["-0.6 m", "1 m"]
z = ["-0.5 m", "0.4 m"]
[resolution]
near_hull = "0.0125 m"
{}
[run]
duration = {}
methods  = ["sph"]
[sampling]
mean_from = {}
)",
                       mass, spacing, duration, 0.3 * duration);
}

TEST(FreeHull, InASlowStreamSwingsRoundArchimedesDraftAndTrim) {
    const RunRecord r = run("archimedes", box_in_a_slow_stream("", 40, 3), 1);
    ASSERT_EQ(r.state, "finished") << r.reason;
    ASSERT_GT(r.numbers.at("rest_trim_deg"), 1.5);
    const auto middle = [&](const char* name) { return swings_round(r, name, 1, 3); };
    // Found with five variants of the pair loops: trim -2.9 % with a standard deviation of 0.4 % (at 0.02 m/s +0.8 %:
    // the stream's own pressure takes it down), z +0.6 +- 0.05 % of the draft, draft at the transom -1.1 +- 0.06 %.
    EXPECT_NEAR(middle("trim") / r.numbers.at("rest_trim_deg"), 1, 0.06);
    EXPECT_NEAR(middle("z"), r.numbers.at("rest_z"), 0.015 * 0.1);
    EXPECT_NEAR(middle("transom_draft"), r.numbers.at("rest_transom_draft"), 0.02 * 0.1);
    EXPECT_EQ(column(r, "trim").front(), 0) << "held until the stream has its speed";
}

/// Half as heavy again as it stands, it falls further than the particles reached that were set round it: they go with
/// it, and it moves as among particles of one size, with any number of threads.
TEST(FreeHull, TakesItsFineParticlesAlong) {
    const std::string two = box_in_a_slow_stream("spacing = 0.025\n[sph]\nzone = 8\n", 60, 0.8);
    const RunRecord one = run("one_size", box_in_a_slow_stream("", 60, 0.8), 1), levels = run("two_sizes", two, 1),
                    threads = run("two_sizes", two, 3);
    ASSERT_EQ(one.state, "finished") << one.reason;
    ASSERT_EQ(levels.state, "finished") << levels.reason;
    EXPECT_EQ(levels.tables.count("level_1"), 1u);
    const auto [lowest, highest] = std::ranges::minmax(column(one, "z"));
    EXPECT_GT(highest - lowest, 2 * 0.0125) << "or zones that stand would do";
    for (const char* name : {"z", "trim"}) {
        const auto [low, high] = std::ranges::minmax(column(one, name));
        double apart = 0;
        for (double t = 0.1; t < 0.8; t += 0.1)
            apart =
                std::max(apart, std::abs(mean_between(levels, name, t - 0.1, t) - mean_between(one, name, t - 0.1, t)));
        std::printf("%s: moves over %.4g, two sizes %.2g of that away\n", name, high - low, apart / (high - low));
        EXPECT_LT(apart, 0.1 * (high - low)) << name;
        EXPECT_EQ(column(levels, name), column(threads, name)) << name;
    }
}

std::string planing(const std::string& half) {
    return R"(
[hull]
shape    = "prismatic"
length   = "2 m"
beam     = "0.5 m"
deadrise = "20 deg"
trim     = "5 deg"
draft    = "0.1 m"
half     = )" +
           half + R"(
free     = ["heave", "pitch"]
mass     = "40 kg"
lcg      = "0.7 m"
vcg      = "0.15 m"
release  = "0.1 s"
[motion]
kind  = "stream"
speed = "5 m/s"
[domain]
ahead  = "0.4 m"
behind = "0.4 m"
side   = "0.5 m"
below  = "0.4 m"
[resolution]
near_hull = "0.05 m"
[run]
duration = "0.35 s"
methods  = ["sph"]
)";
}

/// A half model moves as the whole hull does. Its samples go with it: left at the start attitude they would lie in the
/// water or in the hull by half a spacing and more.
TEST(FreeHull, AHalfModelMovesAsTheWholeHullDoesAndItsSamplesGoWithIt) {
    const RunRecord half = run("half", planing("true"), 1), whole = run("whole", planing("false"), 1);
    ASSERT_EQ(half.state, "finished") << half.reason;
    ASSERT_EQ(whole.state, "finished") << whole.reason;
    const double lifted = column(whole, "z").back() - column(whole, "z").front(),
                 trimmed = column(whole, "trim").back() - column(whole, "trim").front();
    EXPECT_GT(std::abs(lifted), 0.005);
    EXPECT_GT(std::abs(trimmed), 0.2);
    EXPECT_NEAR((column(half, "z").back() - column(half, "z").front()) / lifted, 1, 0.1);
    EXPECT_NEAR((column(half, "trim").back() - column(half, "trim").front()) / trimmed, 1, 0.1);

    const Table &f = half.tables.at("forces"), &s = half.tables.at("samples");
    double of_pairs = 0, of_surface = 0;
    const std::vector<double>&pairs = f.find("fz")->values, &surface = f.find("fz_surface")->values;
    for (std::size_t i = 0; i < f.time.size(); ++i)
        if (f.time[i] > 0.2 && std::isfinite(surface[i])) of_pairs += pairs[i], of_surface += surface[i];
    EXPECT_NEAR(of_surface / of_pairs, 1, 0.15) << "ten particles across the beam";
    const double keel = column(half, "transom_draft").back() / std::sin(column(half, "trim").back() * M_PI / 180);
    EXPECT_NEAR(s.find("wetted_length")->values.back(), std::min(keel, 2.0), 0.25);
}

/// The study of a model whose measured trim is 4.17 degrees, at beam/8; docs/results/fridsma.md has its numbers.
TEST(FreeHull, ThatIsReleasedPlaningFindsASteadyTrimAndALiftThatCarriesIt) {
    SceneOverrides coarse;
    coarse.scale_resolution = 1.5;
    coarse.duration = 1.6;
    const RunRecord r =
        run("planing", read_scene(std::filesystem::path(TWINWAKE_SOURCE) / "studies/planing_free.toml", coarse), 1);
    ASSERT_EQ(r.state, "finished") << r.reason;
    const std::vector<double>& time = r.tables.at(hull_motion_table).time;
    double low = 90, high = -90, lift = 0, span = 0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (time[i] < 1.2) continue;
        low = std::min(low, column(r, "trim")[i]), high = std::max(high, column(r, "trim")[i]);
        const double dt = time[i] - time[i - 1];
        lift += dt * r.tables.at("forces").find("fz")->values[i];
        span += dt;
    }
    EXPECT_LT(high - low, 0.1) << "it started 0.5 degrees away";
    EXPECT_GT(low, 3);
    EXPECT_LT(high, 4.17);
    EXPECT_NEAR(lift / span / (9.81 * r.numbers.at("hull_mass")), 1, 0.01);
    EXPECT_GT(mean_from(r, "z", 1.2), r.numbers.at("rest_z") + 0.02) << "it has risen";
}

}  // namespace free_hull_test
}  // namespace tw
