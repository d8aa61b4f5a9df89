// Bodies that move, through the real interFoam.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/dictionary.h"
#include "foam_cases/plan_case.h"
#include "foam_cases/read/body_rows.h"
#include "foam_cases/run/case_programs.h"
#include "foam_cases/write_case.h"
#include "foam_test.h"
#include "motion/rigid_body.h"

namespace tw {
namespace moving_bodies_test {

using MovingBodies = FoamTest;

double last(const Table& t, const char* column) { return t.find(column)->values.back(); }

/// A box 0.2 m wide and 0.1 m high in a tank of two dimensions, ten cells wide.
std::string box_in_tank(const std::string& body, const std::string& duration, const std::string& more = "") {
    return body_in_tank(R"(["-0.5 m", 0, "-0.4 m"])", R"(["0.5 m", "20 mm", "0.3 m"])",
                        "name = \"box\"\nshape = \"box\"\nlength = \"0.2 m\"\nheight = \"0.1 m\"\n" + body, duration) +
           more;
}

TEST_F(MovingBodies, AFloatingBoxStaysAtArchimedesDraft) {
    // half a period of heave, 2 pi sqrt((m + added) / (rho g B)) = 0.7 s: a force that is off has moved it farthest then
    const RunRecord r = run_fvm(scene(box_in_tank("density = \"500 kg/m3\"\ndraft = \"50 mm\"", "0.35 s")), options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    EXPECT_NE(r.attributes.at("mesh_motion").find("morphed"), std::string::npos) << r.attributes.at("mesh_motion");
    const Table& t = r.tables.at("body_box");
    EXPECT_NEAR(last(t, "lowest"), -0.05, 0.005 * 0.05);
    EXPECT_NEAR(last(t, "fz"), 0.2 * 0.1 * 500 * 9.81, 0.01 * 98.1) << "per metre of span";
}

// From rest, deep under water, a cylinder q times as heavy as water begins to rise with (1 - q) g / (q + C). C = 1.0115:
// images of a doublet in the tank's sides 2.4 m apart, the surface 0.8 m above and the floor as far below. It carries a
// hundred times its own mass of water along.
TEST_F(MovingBodies, ACylinderLetGoUnderWaterCarriesAllOfItsAddedMass) {
    const double q = 0.01;
    const RunRecord r = run_fvm(scene(body_in_tank(R"(["-1.2 m", 0, "-1.6 m"])", R"(["1.2 m", "20 mm", "0.4 m"])",
                                                   "name = \"cylinder\"\nshape = \"cylinder\"\ndiameter = "
                                                   "\"0.2 m\"\ndraft = \"0.9 m\"\nlocked = [\"surge\", "
                                                   "\"pitch\"]\ndensity = " +
                                                       std::to_string(1000 * q),
                                                   "31 ms")),
                                options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    const Table& t = r.tables.at("body_cylinder");
    const auto after = std::ranges::upper_bound(t.time, 0.03);
    const std::size_t i = static_cast<std::size_t>(after - t.time.begin());
    const std::vector<double>& v = t.find("vz")->values;
    const double speed = v[i - 1] + (v[i] - v[i - 1]) * (0.03 - t.time[i - 1]) / (t.time[i] - t.time[i - 1]),
                 exact = (1 - q) * 9.81 / (q + 1.0115) * 0.03;
    std::printf("%.4f m/s after 30 ms, exact %.4f (%+.2f %%), %zu steps\n", speed, exact, 100 * (speed / exact - 1),
                t.time.size());
    EXPECT_NEAR(speed / exact, 1, 0.01);
}

// Between walls W apart a rod of diameter D rises slowly with
//
//   U = (rho - rho_rod) g pi D^2 / 4 (ln(W/D) - 0.9157 + 1.724 (D/W)^2 - 1.730 (D/W)^4) / (4 pi mu)
//
// (Faxen 1946). At nu dt / dx^2 = 15 a step without momentum predictor carries no
// momentum. The rod takes three times its own mass of oil along.
TEST_F(MovingBodies, ARodRisesInOilAsFaxenSays) {
    const double q = 0.3;
    const RunRecord r = run_fvm(scene(R"([tank]
min = ["-50 mm", 0, "-0.25 m"]
max = ["50 mm", "1 mm", "20 mm"]
[domain]
dimensions = 2
[water]
viscosity = "1e-2 m2/s"
[[body]]
name = "rod"
shape = "cylinder"
diameter = "20 mm"
draft = "0.12 m"
locked = ["surge", "pitch"]
density = )" + std::to_string(1000 * q) +
                                      R"(
[motion]
kind = "none"
[resolution]
near_hull = "4 mm"
[run]
duration = "60 ms"
[sampling]
interval = "20 ms"
)"),
                                options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    const double D = 0.02, ratio = D / 0.1,
                 walls = -std::log(ratio) - 0.9157 + 1.724 * ratio * ratio - 1.73 * std::pow(ratio, 4),
                 exact = 1000 * (1 - q) * 9.81 * D * D / 16 * walls / 10;
    const double speed = last(r.tables.at("body_rod"), "vz");
    std::printf("%.3f mm/s, Faxen %.3f\n", 1e3 * speed, 1e3 * exact);
    EXPECT_NEAR(speed / exact, 1, 0.03);
}

TEST_F(MovingBodies, WhatTheWaterGivesAFallingBodyIsItsChangeOfMomentum) {
    // It falls from 20 mm, through half of the tank: the whole mesh goes with it.
    const RunRecord r =
        run_fvm(scene(box_in_tank("density = \"1500 kg/m3\"\ndraft = \"-20 mm\"\nvelocity = [0, 0, -1]\n"
                                  "locked = [\"surge\", \"pitch\"]",
                                  "0.25 s")),
                options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    EXPECT_NE(r.attributes.at("mesh_motion").find("no floor"), std::string::npos) << r.attributes.at("mesh_motion");
    const Table& t = r.tables.at("body_box");
    const auto &v = t.find("vz")->values, &f = t.find("fz")->values;
    const double m = 1500 * 0.2 * 0.1, g = 9.81;
    const std::size_t from = 10, to = t.time.size() - 1;
    double impulse = 0;
    for (std::size_t i = from + 1; i <= to; ++i) impulse += (t.time[i] - t.time[i - 1]) * (f[i] + f[i - 1]) / 2;
    const double gained = m * (v[to] - v[from]) + m * g * (t.time[to] - t.time[from]);
    EXPECT_GT(gained, 0.5 * m) << "the water slows it by half a metre per second at least";
    EXPECT_NEAR(impulse / gained, 1, 0.01);
    EXPECT_EQ(last(t, "x"), 0);
    EXPECT_EQ(last(t, "q0"), 1);
}

// Wide and light: the air between it and the water weighs a tenth of what it weighs, and has been moving for long when it
// is released. Falling on a cushion of air it loses no more than 1 % of its speed before it touches.
TEST_F(MovingBodies, AWideLightBodyThatComesDownThroughTheAirKeepsItsSpeed) {
    const RunRecord r = run_fvm(scene(body_in_tank(R"(["-1.2 m", 0, "-0.6 m"])", R"(["1.2 m", "40 mm", "0.6 m"])",
                                                   "name = \"wedge\"\nshape = \"wedge\"\nwidth = \"1.2 m\"\ndeadrise "
                                                   "= \"25 deg\"\nside_height = \"0.2 m\"\ndraft = \"-20 mm\"\n"
                                                   "mass = \"94 kg\"\nvelocity = [0, 0, -5]\nlocked = [\"surge\", "
                                                   "\"pitch\"]",
                                                   "2.5 ms")),
                                options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    const Table& t = r.tables.at("body_wedge");
    EXPECT_GT(r.numbers.at("release_factor"), 1.01) << "or this tests nothing";
    EXPECT_NEAR(last(t, "vz") / -(5 + 9.81 * t.time.back()), 1, 0.01);
}

TEST_F(MovingBodies, APrescribedBodyIsWhereItsLawHasItAndItsMeshToo) {
    const RunRecord r = run_fvm(scene(box_in_tank("draft = \"50 mm\"\nmotion = \"prescribed\"\nlaw = \"sinusoid\"\n"
                                                  "along = [0, 0, 1]\namplitude = \"5 mm\"\nperiod = 0.8",
                                                  "0.2 s", "[sampling]\ninterval = \"0.1 s\"\n")),
                                options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    const Table& t = r.tables.at("body_box");
    EXPECT_NEAR(last(t, "z"), 0.005 * std::sin(2 * std::numbers::pi * t.time.back() / 0.8), 1e-12);
    // A quarter of a period up: the box displaces a tenth less water, which stays in the tank all the same.
    const auto& mass = r.tables.at("samples").find("mass")->values;
    EXPECT_NEAR(mass.back() / mass.front(), 1, 1e-4);
    const double hydrostatic = 1000 * 9.81 * 0.2 * 0.045, added = last(t, "fz") - hydrostatic;
    EXPECT_GT(added, 0) << "it is slowed on its way up, and the water with it";
    EXPECT_LT(added, 0.5 * hydrostatic);
}

// The case is split for two cores, and with it the condition that moves the body's points.
TEST_F(MovingBodies, APrescribedBodyMovesOnTwoCoresToo) {
    RunOptions two = options();
    two.threads = 2;
    const RunRecord r = run_fvm(scene(box_in_tank("draft = \"50 mm\"\nmotion = \"prescribed\"\nlaw = \"constant\"\n"
                                                  "along = [0, 0, 1]\nrate = 0.1",
                                                  "10 ms")),
                                two);
    ASSERT_EQ(r.state, "finished") << r.reason;
    const Table& t = r.tables.at("body_box");
    EXPECT_NEAR(last(t, "z"), 0.1 * t.time.back(), 1e-12);
}

TEST_F(MovingBodies, ThatReachTheFloorEndTheRunWithAMessage) {
    const Scene s =
        scene(box_in_tank("density = \"4000 kg/m3\"\ndraft = \"200 mm\"\nvelocity = [0, 0, -2]\n"
                          "locked = [\"surge\", \"pitch\"]",
                          "0.5 s"));
    try {
        run_fvm(s, options());
        FAIL();
    } catch (const RunError& e) {
        EXPECT_NE(std::string(e.what()).find("touches a wall or the floor"), std::string::npos) << e.what();
    }
    EXPECT_EQ(read_record(options().folder / "record.h5").state, "failed");
}

TEST_F(MovingBodies, GoOnWhereTheyWereStopped) {
    const std::string text = "density = \"700 kg/m3\"\ndraft = \"40 mm\"\ntrim = \"5 deg\"";
    const auto with_duration = [&](const char* s) {
        return scene(box_in_tank(text, s, "[sampling]\ninterval = 0.02\n"));
    };
    const RunRecord whole = run_fvm(with_duration("0.12 s"), options());
    RunOptions parts = options();
    parts.folder = folder / "parts";
    run_fvm(with_duration("0.06 s"), parts);
    parts.resume = true;
    const RunRecord resumed = run_fvm(with_duration("0.12 s"), parts);
    ASSERT_EQ(resumed.state, "finished") << resumed.reason;
    const Table &a = whole.tables.at("body_box"), &b = resumed.tables.at("body_box");
    EXPECT_TRUE(std::ranges::is_sorted(b.time, std::less_equal<>()));
    EXPECT_LT(b.time.front(), 0.001) << "the rows before the stop are there";
    // the last steps end at different times, so the whole run is carried on to the other's end
    const std::size_t end = a.time.size() - 1;
    const double later = (b.time.back() - a.time[end]) / (a.time[end] - a.time[end - 1]);
    for (const char* column : {"x", "z", "qy"}) {
        const std::vector<double>& v = a.find(column)->values;
        std::printf("%s: whole %.6f, at the same time %.6f, resumed %.6f\n", column, v[end],
                    v[end] + later * (v[end] - v[end - 1]), last(b, column));
        EXPECT_NEAR(v[end] + later * (v[end] - v[end - 1]), last(b, column), 2e-4) << column;
    }
    EXPECT_GT(std::abs(last(a, "qy")), 0.001) << "it turns";
}

/// Two boxes of 0.2 x 0.1 m, 0.4 m to each side of the middle of a tank of two dimensions.
std::string two_boxes(const std::string& left, const std::string& right, const std::string& duration) {
    const auto box = [](const char* name, const char* x, const std::string& more) {
        return std::string("[[body]]\nname = \"") + name +
               "\"\nshape = \"box\"\nlength = \"0.2 m\"\nheight = \"0.1 m\"\nposition = [" + x + ", 0]\n" + more;
    };
    return "[tank]\nmin = [\"-0.8 m\", 0, \"-0.5 m\"]\nmax = [\"0.8 m\", \"20 mm\", \"0.4 m\"]\n[domain]\ndimensions = "
           "2\n" +
           box("port", "\"-0.4 m\"", left) + box("starboard", "\"0.4 m\"", right) +
           "[motion]\nkind = \"none\"\n[resolution]\nnear_hull = \"20 mm\"\n[run]\nduration = \"" + duration + "\"\n";
}

// The one that floats stays but for the other's waves; what the water gives each of them is its change of momentum, so
// neither feels the forces of the other.
TEST_F(MovingBodies, TwoBoxesEachAnswerToTheForcesOnThemselves) {
    const std::string floats = "density = \"500 kg/m3\"\ndraft = \"50 mm\"\n";
    const std::string falls = "density = \"400 kg/m3\"\ndraft = \"0 mm\"\nlocked = [\"surge\", \"pitch\"]\n";
    const RunRecord r = run_fvm(scene(two_boxes(floats, falls, "0.16 s")), options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    const auto gained_and_impulse = [&](const char* table, double m) {
        const Table& t = r.tables.at(table);
        const auto &v = t.find("vz")->values, &f = t.find("fz")->values;
        const std::size_t from = 10, to = t.time.size() - 1;
        double impulse = 0;
        for (std::size_t i = from + 1; i <= to; ++i) impulse += (t.time[i] - t.time[i - 1]) * (f[i] + f[i - 1]) / 2;
        return std::pair{m * (v[to] - v[from]) + m * 9.81 * (t.time[to] - t.time[from]), impulse};
    };
    const auto [fell, pushed] = gained_and_impulse("body_starboard", 400 * 0.02);
    EXPECT_NEAR(pushed / fell, 1, 0.01);
    const auto [stayed, held] = gained_and_impulse("body_port", 500 * 0.02);
    EXPECT_NEAR(held / stayed, 1, 0.01);
    EXPECT_LT(last(r.tables.at("body_starboard"), "z"), 0.03) << "from 0.05";
    EXPECT_EQ(last(r.tables.at("body_starboard"), "x"), 0.4) << "surge is locked";
    EXPECT_NEAR(last(r.tables.at("body_port"), "lowest"), -0.05, 0.005);
    EXPECT_EQ(r.bodies.size(), 2u);
}

// Their state lies beside the fields, and the log of both starts says where they were.
TEST_F(MovingBodies, TwoBoxesGoOnWhereTheyWereStopped) {
    const auto run = [&](const char* duration, const RunOptions& how) {
        const std::string falls = "density = \"400 kg/m3\"\ndraft = \"0 mm\"\n";
        return run_fvm(scene(two_boxes("density = \"500 kg/m3\"\ndraft = \"45 mm\"\n", falls, duration) +
                             "[sampling]\ninterval = 0.01\n"),
                       how);
    };
    const RunRecord whole = run("0.04 s", options());
    RunOptions parts = options();
    parts.folder = folder / "parts";
    run("0.02 s", parts);
    parts.resume = true;
    const RunRecord resumed = run("0.04 s", parts);
    ASSERT_EQ(resumed.state, "finished") << resumed.reason;
    for (const char* body : {"body_port", "body_starboard"}) {
        const Table &a = whole.tables.at(body), &b = resumed.tables.at(body);
        EXPECT_TRUE(std::ranges::is_sorted(b.time, std::less_equal<>()));
        EXPECT_LT(b.time.front(), 0.001) << "the rows before the stop are there";
        const double later = b.time.back() - a.time.back();  // the last steps end at different times
        EXPECT_NEAR(last(a, "z") + later * last(a, "vz"), last(b, "z"), 1e-4) << body;
    }
}

TEST_F(MovingBodies, TwoBoxesThatFallSideBySideAreEachOthersMirrorImage) {
    const std::string falls = "density = \"500 kg/m3\"\ndraft = \"20 mm\"\nvelocity = [0, 0, -0.2]\n";
    const RunRecord r =
        run_fvm(scene(two_boxes(falls + "trim = \"4 deg\"\n", falls + "trim = \"-4 deg\"\n", "0.16 s")), options());
    ASSERT_EQ(r.state, "finished") << r.reason;
    const Table &a = r.tables.at("body_port"), &b = r.tables.at("body_starboard");
    // Released in water at rest, each shares its momentum with the water that a half submerged plate moves.
    const double mass = 500 * 0.02, water = std::numbers::pi / 8 * 1000 * 0.2 * 0.2;
    EXPECT_NEAR(a.find("vz")->values.front(), -0.2 * mass / (mass + water), 0.01);
    EXPECT_LT(last(a, "z"), 0.025) << "they have fallen from 0.03";
    EXPECT_NEAR(last(a, "z"), last(b, "z"), 5e-4);
    EXPECT_NEAR(last(a, "x"), -last(b, "x"), 5e-4);
    EXPECT_NEAR(last(a, "qy"), -last(b, "qy"), 5e-3);
    EXPECT_GT(std::abs(last(a, "qy")), 1e-3) << "they turn";
}

/// OpenFOAM's rigid body alone, without water (`test`), in `steps` equal steps.
Table without_water(const Scene& s, const std::filesystem::path& folder, int steps) {
    const OpenFoam foam = sound_openfoam();
    const CasePlan plan = plan_case(s, Flavour::from_version(foam.vendor, foam.version));
    write_case(plan, folder, 1);
    const auto replace = [&](const char* file, const std::string& from, const std::string& to) {
        std::string text = read_text(folder / file);
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        write_text_atomically(folder / file, text.replace(at, from.size(), to));
    };
    replace("constant/dynamicMeshDict", "report ", "test yes; g (0 0 -9.81); report ");
    const double T = s.run.duration;
    write_text_atomically(
        folder / "system/controlDict",
        foam_file("dictionary", "controlDict",
                  {{"application", Word("moveDynamicMesh")},
                   {"startTime", 0},
                   {"startFrom", Word("startTime")},
                   {"stopAt", Word("endTime")},
                   {"endTime", T},
                   {"deltaT", T / steps},
                   {"writeControl", Word("timeStep")},
                   {"writeInterval", steps},
                   {"writePrecision", 14},
                   {"timePrecision", 10},
                   {"functions", Dictionary{{"bodyState", Dictionary{{"type", Word("sixDoFRigidBodyState")},
                                                                     {"libs", List{Word("sixDoFRigidBodyState")}},
                                                                     {"angleFormat", Word("radians")},
                                                                     {"writePrecision", 14},
                                                                     {"log", false},
                                                                     {"writeControl", Word("timeStep")},
                                                                     {"writeInterval", 1}}}}}}));
    const CasePrograms programs(foam, folder);
    programs.run("blockMesh", {}, {});
    programs.run("surfaceFeatureExtract", {}, {});
    programs.run("snappyHexMesh", {"-overwrite"}, {});
    std::filesystem::copy(folder / "0.orig", folder / "0", std::filesystem::copy_options::recursive);
    programs.run("moveDynamicMesh", {}, {});
    Table t;
    for (const BodyPlace& p : free_places(plan, folder / "postProcessing")) {
        t.time.push_back(p.time);
        const auto put = [&](const char* name, double v) { t.column(name, "").values.push_back(v); };
        put("x", p.centre.x()), put("z", p.centre.z()), put("vz", p.velocity.z());
        put("q0", p.attitude.w()), put("qx", p.attitude.x()), put("qy", p.attitude.y()), put("qz", p.attitude.z());
        put("spin_x", p.spin.x()), put("spin_y", p.spin.y()), put("spin_z", p.spin.z());
    }
    return t;
}

// A brick of three different moments of inertia, skewed in its tank, shot upwards with a spin about no axis of its own. The
// rules of motion/ are exact here to their own step.
TEST_F(MovingBodies, WithoutWaterMoveAsTheRulesOfMotionSay) {
    const Scene s = scene(R"(
[tank]
min = ["-0.5 m", "-0.5 m", "-0.3 m"]
max = ["0.7 m", "0.5 m", "2.2 m"]
[[body]]
name = "brick"
shape = "box"
length = "0.4 m"
beam = "0.3 m"
height = "0.1 m"
trim = "20 deg"
heel = "30 deg"
draft = "-1.5 m"
density = "3000 kg/m3"
spin = [1, 4, 2]
velocity = [0.5, 0, 2]
[motion]
kind = "none"
[resolution]
near_hull = "100 mm"
[run]
duration = "0.1 s"
)");
    const Table t = without_water(s, folder / "dry", 100);
    ASSERT_EQ(t.time.size(), 100u);
    RigidBody exact(s.bodies.at(0).motion);
    const double T = t.time.back(), dt = T / 20000;
    const Vec3 weight(0, 0, -9.81 * exact.mass().mass);
    for (int i = 0; i < 20000; ++i) {
        exact.kick(weight, Vec3::Zero(), dt / 2);
        exact.drift(dt);
        exact.kick(weight, Vec3::Zero(), dt / 2);
    }
    const RigidBody::State& state = exact.state();
    EXPECT_NEAR(last(t, "x"), state.centre.x(), 1e-6);
    EXPECT_NEAR(last(t, "z"), state.centre.z(), 1e-6);
    EXPECT_NEAR(last(t, "vz"), state.velocity.z(), 1e-6);
    const Eigen::Quaterniond found(last(t, "q0"), last(t, "qx"), last(t, "qy"), last(t, "qz"));
    EXPECT_LT(found.angularDistance(state.attitude), 1e-4) << "radians, of " << 4.6 * T;
    EXPECT_LT((Vec3(last(t, "spin_x"), last(t, "spin_y"), last(t, "spin_z")) - exact.spin()).norm(), 1e-3);
}

}  // namespace moving_bodies_test
}  // namespace tw
