// When a run of interFoam is stopped, and what does not stop it: logs and tables with one fault each.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "foam_cases/read/frame_reader.h"
#include "foam_cases/run/body_guard.h"
#include "foam_cases/run/watchdog.h"
#include "meshes/generate.h"
#include "meshes/mass_properties.h"
#include "scenes.h"

namespace tw {
namespace watchdog_test {

/// What the log says of a step; the numbers are those of a jet on a wedge that was sound (8 mm cells).
struct Said {
    double time = 1e-3, step = 1e-3, water = 0.4, least = -7e-8, most = 1.00003, local = 6e-6;
    std::string text() const {
        char line[600];
        std::snprintf(
            line, sizeof line,
            "Courant Number mean: 0.01 max: 1.1\nInterface Courant Number mean: 0.001 max: 0.9\ndeltaT = %.6g\n"
            "Time = %.8g\n\nPhase-1 volume fraction = %.10g  Min(alpha.water) = %.8g  Max(alpha.water) = %.8g\n"
            "time step continuity errors : sum local = %.8g, global = 1e-9, cumulative = 0.08\n"
            "ExecutionTime = 1.5 s  ClockTime = 2 s\n\n",
            step, time, water, least, most, local);
        return line;
    }
};
/// A healthy run, and one more step with what is wrong.
SolverLog log_with(Said last, int healthy = 10, double usual = 1e-3) {
    SolverLog log;
    for (int i = 1; i <= healthy; ++i) log.feed(Said{.time = i * 1e-3, .step = usual}.text());
    last.time = log.steps().empty() ? last.time : log.steps().back().time + last.step;
    log.feed(last.text());
    return log;
}
const Limits tank{.gains_no_water = true, .loses_no_water = true};

void expect_says(const std::optional<std::string>& wrong, const char* part) {
    ASSERT_TRUE(wrong) << part;
    EXPECT_NE(wrong->find(part), std::string::npos) << *wrong;
}

TEST(Watchdog, IsSilentInAHealthyRun) {
    EXPECT_FALSE(trouble(SolverLog(), 12.0, tank));
    const SolverLog log = log_with({}, 500);
    EXPECT_FALSE(trouble(log, 12.0, tank));
    EXPECT_FALSE(trouble(log, std::nan(""), {.air_speed = 100})) << "not known yet is not too fast";
}

TEST(Watchdog, BarksAtATimeStepThatHasCollapsedOrStaysFarBelowTheUsualOne) {
    expect_says(trouble(log_with({.step = 5e-9}), 1, {}), "time step collapsed to 5e-09");
    SolverLog log = log_with({.step = 5e-7}, 400);
    const auto on = [&](int more) {
        for (int i = 0; i < more; ++i) log.feed(Said{.time = log.steps().back().time + 5e-7, .step = 5e-7}.text());
    };
    on(90);
    EXPECT_FALSE(trouble(log, 1, {})) << "short dips are allowed";
    on(20);
    expect_says(trouble(log, 1, {}), "would not end");
}

// Six of eight sound jets were stopped by 101 to 112 m/s in a cell of air, at a tank's upper corner.
TEST(Watchdog, BarksAtAirThatIsFasterThanAnyGapMakesIt) {
    Scene scene = dam_break_scene();
    scene.tank_motion.emplace().law = {.axis = Vec3::UnitZ(), .rate = -10};
    scene.water.gravity = 0;
    const Limits limits = limits_of(plan_case(scene, Flavour{}));
    EXPECT_NEAR(limits.water_speed, 100, 1e-9);
    EXPECT_NEAR(limits.air_speed, 3 * 10 * 0.584 / (2 * 0.0146), 1e-9);
    EXPECT_FALSE(trouble(log_with({}), 112, limits));
    expect_says(trouble(log_with({}), 1.01 * limits.air_speed, limits), "narrowest gap");
    EXPECT_TRUE(trouble(log_with({}), std::numeric_limits<double>::infinity(), limits));
}

TEST(Watchdog, BarksAtWaterThatComesFromNowhereOrGoes) {
    for (const double water : {0.409, 0.391}) EXPECT_TRUE(trouble(log_with({.water = water}), 1, tank)) << water;
    expect_says(trouble(log_with({.water = 0.409}), 1, tank), "2.25 % more");
    EXPECT_FALSE(trouble(log_with({.water = 0.407}), 1, tank));
    const Limits open{.gains_no_water = true};
    EXPECT_FALSE(trouble(log_with({.water = 0.3}), 1, open)) << "it may splash out of a tank without a lid";
    EXPECT_TRUE(trouble(log_with({.water = 0.409}), 1, open));
    EXPECT_FALSE(trouble(log_with({.water = 0.5}), 1, {})) << "a stream brings its own";
    expect_says(trouble(log_with({.water = NAN}), 1, tank), "no number");
}

TEST(Watchdog, BarksAtAStreamWhoseBoxFillsOrEmpties) {
    const Limits stream = limits_of(plan_case(planing_scene(), Flavour{}));
    EXPECT_FALSE(trouble(log_with({.water = 0.56}), 1, stream)) << "a splash";
    expect_says(trouble(log_with({.water = 0.61}), 1, stream), "52.5 % more water than at its start");
    expect_says(trouble(log_with({.water = 0.19}), 1, stream), "less comes in than leaves");
}

TEST(Watchdog, BarksAtCellsThatHoldMoreThanTheyCan) {
    expect_says(trouble(log_with({.most = 1.6}), 1, {}), "fraction reached 1.6");
    expect_says(trouble(log_with({.least = -0.6}), 1, {}), "fraction reached -0.6");
    EXPECT_FALSE(trouble(log_with({.least = -0.1, .most = 1.2}), 1, {}));
}

// What the log sums up is of all correctors of all steps: 0.08 in a dam break that was right.
TEST(Watchdog, BarksAtErrorsOfContinuity) {
    expect_says(trouble(log_with({.local = 2e-3}), 1, {}), "0.002 of the domain's volume");
    EXPECT_FALSE(trouble(log_with({.local = 1e-4}), 1, {}));
}

TEST(Watchdog, KnowsWhereWaterMayComeAndGo) {
    Scene scene = dam_break_scene();
    EXPECT_TRUE(limits_of(plan_case(scene, Flavour{})).gains_no_water);
    EXPECT_FALSE(limits_of(plan_case(scene, Flavour{})).loses_no_water) << "open above";
    scene.domain.z_max = Side::slip_wall;
    EXPECT_TRUE(limits_of(plan_case(scene, Flavour{})).loses_no_water);
    EXPECT_FALSE(limits_of(plan_case(planing_scene(), Flavour{})).gains_no_water);
    EXPECT_LT(limits_of(plan_case(scene, Flavour{})).energy_made, 1);
    scene.tank_motion.emplace();
    EXPECT_EQ(limits_of(plan_case(scene, Flavour{})).energy_made, HUGE_VAL) << "it does work on the water";
}

/// 10 kg/m of water, 0.5 m of it above a floor at -1 m; with so much fast water and kinetic energy at the end.
RunRecord water_with(double fast, double kinetic) {
    RunRecord r;
    r.attributes["motion"] = "none";
    r.numbers = {{"gravity", 9.81}, {"domain_z_min", -1}};
    Table& t = r.table("samples");
    for (int i = 0; i < 3; ++i) {
        const std::size_t row = t.append(0.1 * i);
        t.set(row, "mass", "kg/m", 10);
        t.set(row, "potential_energy", "J/m", -10 * 9.81 * 0.75);
        t.set(row, "kinetic_energy", "J/m", i == 2 ? kinetic : 0);
        t.set(row, fast_water, "-", i == 2 ? fast : 0);
    }
    return r;
}

TEST(Watchdog, BarksAtWaterThatIsTooFastAndNotAtOneCellOfIt) {
    EXPECT_FALSE(water_trouble(RunRecord(), {}));
    EXPECT_FALSE(water_trouble(water_with(0, 0), {}));
    EXPECT_FALSE(water_trouble(water_with(1e-4, 0), {}));
    expect_says(water_trouble(water_with(2e-3, 0), {.water_speed = 100}), "0.2 % of the water is faster than the 100");
}

TEST(Watchdog, BarksAtEnergyThatNothingHasGiven) {
    const double of_height = 10 * 9.81 * 0.25;
    EXPECT_FALSE(water_trouble(water_with(0, 0.1 * of_height), {}));
    expect_says(water_trouble(water_with(0, 0.3 * of_height), {}), "30 % of what its height");
    EXPECT_FALSE(water_trouble(water_with(0, 0.3 * of_height), {.energy_made = HUGE_VAL}));
}

TEST(Watchdog, SeesAFullDisk) {
    EXPECT_FALSE(disk_trouble(std::filesystem::temp_directory_path(), 1));
    expect_says(disk_trouble(std::filesystem::temp_directory_path(), 1e30), "disk is full");
}

/// A rod of 20 mm and 1.2 times the water's density, 0.11 m deep, as it sinks in oil.
struct SinkingRod {
    Scene scene = dam_break_scene();
    SinkingRod() {
        scene.domain.box = {Vec3(-0.05, -0.001, -0.25), Vec3(0.05, 0.001, 0.02)};
        scene.water_blocks.clear();
        scene.run.duration = 0.6;
        MovingBody& rod = scene.bodies.emplace_back();
        rod.name = "rod";
        rod.surface = make_hull("cylinder", {{"diameter", 0.02}, {"span", 1}});
        const Box at = rod.surface.bounds();
        for (Vec3& p : rod.surface.points) p.z() -= 0.1 + at.max.z();
        rod.motion.mass = {1.2 * scene.water.density * mass_properties(rod.surface).volume, Vec3(0, 0, -0.11),
                           1e-4 * Eigen::Matrix3d::Identity()};
        rod.motion.free = {{false, false, true}, {false, false, false}};
    }
    std::optional<std::string> at(double z, double speed) const {
        const CasePlan plan = plan_case(scene, Flavour{});
        char line[300];
        std::snprintf(line, sizeof line,
                      "6-DoF rigid body motion\n    Centre of mass: (0 0 %g)\n    Orientation: (1 0 0 0 1 0 0 0 1)\n"
                      "    Linear velocity: (0 0 %g)\n    Angular velocity: (0 0 0)\n",
                      z, speed);
        SolverLog log;
        log.feed(Said{}.text() + line);
        return body_trouble(plan, log);
    }
};

// It rose at 0.8 m/s and the run was "finished".
TEST(BodyGuard, BarksAtABodyWithMoreEnergyThanWeightAndBuoyancyGiveIt) {
    const SinkingRod rod;
    EXPECT_FALSE(rod.at(-0.12, -0.037));
    EXPECT_FALSE(rod.at(-0.13, -std::sqrt(2 * 9.81 * 0.02))) << "a free fall";
    expect_says(rod.at(-0.1, 0.8), "weight and buoyancy");
    expect_says(rod.at(-0.12, -0.8), "weight and buoyancy");
    SinkingRod light;
    light.scene.bodies[0].motion.mass.mass /= 12;
    EXPECT_FALSE(light.at(-0.1, 0.9)) << "a tenth as heavy as water it may rise so fast";
    SinkingRod waves;
    waves.scene.water_blocks = {{Vec3(-0.05, -0.001, -0.25), Vec3(0, 0.001, 0)}};
    waves.scene.fvm.body_mesh = "morphing";
    EXPECT_FALSE(waves.at(-0.105, 0.8)) << "water that falls may give it";
}

}  // namespace watchdog_test
}  // namespace tw
