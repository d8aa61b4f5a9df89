#include "scene/defaults.h"

#include <cmath>
#include <numbers>

#include "scene_text.h"

namespace tw::test {
namespace defaults_test {

bool multiple(double value, double of) { return std::abs(value / of - std::round(value / of)) < 1e-6; }

TEST(Defaults, FacesLieOnTheLatticeOfParticlesAndCells) {
    for (const char* near_hull : {"0.05", "0.0625", "0.03", "0.0217"}) {
        const Scene s = scene_of(with(planing, "\"0.05 m\"", near_hull));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_TRUE(multiple(s.domain.box.min[axis], s.resolution.spacing)) << near_hull << " axis " << axis;
            EXPECT_TRUE(multiple(s.domain.box.max[axis], s.resolution.spacing)) << near_hull << " axis " << axis;
            EXPECT_TRUE(multiple(s.sampling.raster.origin[axis], s.sampling.raster.voxel))
                << near_hull << " axis " << axis;
        }
        const double n = std::log2(s.resolution.spacing / s.resolution.near_hull);
        EXPECT_TRUE(multiple(n, 1)) << near_hull;
        EXPECT_LE(s.resolution.spacing, s.hull->length / 12 + 1e-12);
    }
}

TEST(Defaults, FacesThatTheUserGaveStayWithinHalfAParticleAndTheFloorWhereItIs) {
    const Scene s =
        scene_of(with(planing, "[motion]", "[domain]\nx = [-3.01, 4.52]\nz = [-1.63, 2]\n[motion]") + one_size);
    EXPECT_NEAR(s.domain.box.min.x(), -3.01, 0.025 + 1e-9);
    EXPECT_NEAR(s.domain.box.max.x(), 4.52, 0.025 + 1e-9);
    EXPECT_EQ(s.domain.box.min.z(), -1.63);
    EXPECT_TRUE(multiple(s.domain.box.min.x(), s.resolution.near_hull));
}

TEST(Defaults, ThePlaningHullHasTheRoomItWasMeasuredToNeed) {
    const Scene s = scene_of(planing);
    EXPECT_GE(s.domain.box.max.y(), 2.0 * s.hull->beam - 1e-9);
    EXPECT_GE(-s.domain.box.min.z(), 1.6 * s.hull->beam - 1e-9);
    EXPECT_GT(s.domain.box.max.z(), s.hull->surface.bounds().max.z() + 0.2 * s.hull->length);
    EXPECT_LT(s.domain.box.min.x(), s.hull->surface.bounds().min.x() - 0.1 * s.hull->length);
}

TEST(Defaults, ADisplacementHullHasRoomForItsWave) {
    // Wigley hull at length Froude number 0.3: ten times as long as wide, so two beams would be a ditch.
    const Scene s = scene_of(
        "[hull]\nshape = 'wigley'\ndraft = 0.15625\nhalf = true\n[motion]\nspeed = 1.5\n[resolution]\nnear_hull = "
        "0.0125\n");
    EXPECT_GE(s.domain.box.max.y(), 0.5 * s.hull->length - 1e-9);
    const double wavelength = 2 * M_PI * 1.5 * 1.5 / 9.81;
    EXPECT_GE(-s.domain.box.min.z(), 0.5 * wavelength - 1e-9);
}

TEST(Defaults, ShallowWaterLimitsTheDepthAndDeepWaterDoesNot) {
    EXPECT_NEAR(scene_of(with(planing, "[motion]", "[water]\ndepth = 0.8\n[motion]")).water.depth, 0.8, 1e-9);
    EXPECT_LT(scene_of(with(planing, "[motion]", "[water]\ndepth = 100\n[motion]") + one_size).water.depth, 2);
}

TEST(Defaults, TheBedIsWhereTheSceneHasItAtEverySize) {
    for (const double scale : {1.0, std::sqrt(2.0), 0.7})
        for (const char* bed : {"[water]\ndepth = 0.63\n[motion]", "[domain]\nbelow = 0.63\n[motion]"}) {
            SceneOverrides o;
            o.scale_resolution = scale;
            const Scene s = scene_of(with(planing, "[motion]", bed), o);
            EXPECT_DOUBLE_EQ(s.domain.box.min.z(), -0.63) << bed << ", scale " << scale;
            EXPECT_DOUBLE_EQ(s.water.depth, 0.63) << bed << ", scale " << scale;
        }
}

TEST(Defaults, AHullHeldInAStreamWithoutADurationStopsWhenItsLoadsHaveSettled) {
    const auto run_of = [](const std::string& keys) { return with(planing, "duration = \"1.5 s\"\n", keys); };
    const Scene free = scene_of(run_of(""));
    EXPECT_EQ(free.run.stop, "settled");
    EXPECT_EQ(scene_of(run_of("duration = \"auto\"\n")).run.duration, free.run.duration);
    // twice what is run where nothing ends it before: slow loads have not settled by then
    const Scene whole = scene_of(run_of("stop = \"duration\"\n"));
    EXPECT_NEAR(whole.run.duration, whole.motion.ramp + 3 * time_scale(whole), 1e-12);
    EXPECT_NEAR(free.run.duration, 2 * whole.run.duration, 1e-12);
    EXPECT_EQ(scene_of(run_of("stop = \"settled\"\n")).run.duration, free.run.duration);
    EXPECT_EQ(scene_of(planing).run.stop, "duration") << "as ever";
    const Scene bound = scene_of(run_of("duration = \"1.5 s\"\nstop = \"settled\"\n"));
    EXPECT_TRUE(bound.run.stops_when_settled());
    EXPECT_EQ(bound.run.duration, 1.5);
    EXPECT_EQ(bound.hash, scene_of(planing).hash) << "it answers the same question";
    EXPECT_EQ(scene_of(run_of("stop = \"duration\"\n")).run.stop, "duration");
    SceneOverrides longer;
    longer.duration = 3;
    EXPECT_EQ(scene_of(run_of("stop = \"settled\"\n"), longer).run.stop, "duration") << "who asks for a time gets it";
    EXPECT_EQ(free.run.wave_period, 0) << "it planes";
    const Scene slow = scene_of(with(run_of(""), "8 m/s", "1.5 m/s"));
    EXPECT_NEAR(slow.run.wave_period, start_up_period(slow), 1e-12);
    EXPECT_GT(slow.run.wave_period, 0);
}

TEST(Defaults, WhatDoesNotSettleIsRunToItsDuration) {
    const std::string tank =
        "[tank]\nsize = [1, 1, 1]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 1, 0.5]\n[resolution]\nnear_hull = "
        "0.05\n";
    EXPECT_EQ(scene_of(tank).run.stop, "duration");
    const std::string why = complaint(tank + "[run]\nstop = \"settled\"\n");
    EXPECT_NE(why.find("stop = \"settled\": only the loads on a hull that is held in a stream settle"),
              std::string::npos)
        << why;
}

TEST(Defaults, WithoutGravityAStreamWaitsForNoWavesAndNoWaterFalls) {
    const std::string slow = with(with(planing, "8 m/s", "1.5 m/s"), "duration = \"1.5 s\"\n", "");
    const Scene with_waves = scene_of(slow), without = scene_of(slow + "[effects]\ngravity = \"off\"\n");
    EXPECT_GT(with_waves.run.duration, 1.5 * without.run.duration);
    const double passage = without.hull->length / 1.5;
    EXPECT_NEAR(without.run.duration, 2 * (0.3 + 1 + 2) * passage, 1e-9);  // twice ramp, settling, mean: a bound
    EXPECT_DOUBLE_EQ(without.sph.c0, 15);
    EXPECT_GT(with_waves.sph.c0, 40);
    EXPECT_EQ(without.water.gravity, 0);
    EXPECT_EQ(without.domain.box.min, with_waves.domain.undamped.min) << "but for zones the box is that with gravity";
}

TEST(Defaults, TheFinestCellsLieRoundTheWettedBottom) {
    const Scene s = scene_of(with(planing, "\"0.05 m\"", "0.025"));
    const RefinementBox& finest = s.refinement.back();
    EXPECT_EQ(finest.name, "wet_bottom");
    EXPECT_NEAR(s.resolution.spacing / std::exp2(finest.level), s.resolution.near_hull, 1e-12);
    const Box wet = s.hull->still.wet_bounds;
    EXPECT_LT(finest.box.min.x(), wet.min.x());
    EXPECT_GT(finest.box.max.x(), wet.max.x());
    EXPECT_LT(finest.box.min.z(), wet.min.z());
    EXPECT_GT(finest.box.max.y(), wet.max.y());
    for (std::size_t i = 1; i < s.refinement.size(); ++i) EXPECT_LE(s.refinement[i - 1].level, s.refinement[i].level);
}

TEST(Defaults, TheBoxesFollowTheHull) {
    // Measured on the reference mesh (prism, length 4 m between perpendiculars, cells L/12 and beam/48): wet bottom box
    // from x = -0.5 to 2.1 m, to y = 0.55 m, from z = -0.235 to 0.06 m.
    const Scene s = scene_of(
        with(planing, "near_hull = \"0.05 m\"", "near_hull = 0.0208333333333333\nspacing = 0.3333333333333333"));
    const Box& box = s.refinement.back().box;
    EXPECT_NEAR(box.min.x(), -0.5, 0.03);
    EXPECT_NEAR(box.max.x(), 2.1, 0.08);
    EXPECT_NEAR(box.max.y(), 0.55, 1e-9);
    EXPECT_NEAR(box.min.z(), -0.235, 1e-9);
    EXPECT_NEAR(box.max.z(), 0.06, 1e-9);
    EXPECT_EQ(s.refinement.back().level, 4);
}

TEST(Defaults, ARasterVoxelIsTwoParticlesAndTheRasterHoldsTheWake) {
    const Scene s = scene_of(planing);
    EXPECT_DOUBLE_EQ(s.sampling.raster.voxel, 2 * s.resolution.near_hull);
    const RasterSpec& r = s.sampling.raster;
    const Vec3 high = r.origin + r.voxel * Vec3(r.count[0], r.count[1], r.count[2]);
    EXPECT_LT(r.origin.x(), s.hull->still.wet_bounds.min.x());
    EXPECT_GE(high.x(), s.domain.box.max.x() - r.voxel);
    EXPECT_LE(r.origin.z(), -s.hull->draft - 1 + 1e-9);  // its beam under the keel: fast hulls make deep troughs
    EXPECT_GT(high.z(), s.hull->surface.bounds().max.z());
}

TEST(Defaults, AShipsRunWaitsForTheOscillationOfItsStart) {
    // 8 pi U / g = 8 pi F^2 L/U: at F = 0.3 2.26 L/U, one to settle and three to average over.
    const auto at_froude = [](double F) {
        Scene s = scene_of(planing);
        s.motion.speed = F * std::sqrt(s.water.gravity * s.hull->length);
        s.motion.ramp = default_ramp(s);
        s.run.duration = s.sampling.mean_from = 0;
        fill_times(s);
        return s;
    };
    const Scene ship = at_froude(0.3);
    const double L_over_U = ship.hull->length / ship.motion.speed;
    const double period = 8 * std::numbers::pi * ship.motion.speed / ship.water.gravity;
    EXPECT_NEAR(start_up_period(ship), period, 1e-12 * period);
    EXPECT_NEAR(period / L_over_U, 2.262, 1e-3);
    EXPECT_NEAR(ship.sampling.mean_from, ship.motion.ramp + period, 1e-9);
    EXPECT_NEAR(ship.run.duration, ship.motion.ramp + 4 * period, 1e-9);
    EXPECT_NE(to_text(ship, predict(ship)).find("averaging over three takes"), std::string::npos);
    Scene brief = ship;
    brief.run.duration = 3 * L_over_U;
    EXPECT_NE(to_text(brief, predict(brief)).find("may give no drag"), std::string::npos);

    const Scene slow = at_froude(0.1);  // the oscillation is over before the wake has formed
    EXPECT_NEAR(slow.run.duration, slow.motion.ramp + 3 * slow.hull->length / slow.motion.speed, 1e-9);
    const Scene planes = at_froude(1.2);
    EXPECT_EQ(start_up_period(planes), 0);
    EXPECT_NEAR(planes.run.duration, planes.motion.ramp + 3 * planes.hull->length / planes.motion.speed, 1e-9);
    EXPECT_NEAR(start_up_period(at_froude(0.8)) * 0.8, start_up_period(at_froude(0.5)) * 0.5, 1e-9);
}

/// A round section of 0.1 m in water of 2 m at Re 200, `dp` [m], its middle `depth` below still water.
std::string round_section(const std::string& dp, double depth, const std::string& more = "") {
    return "[hull]\nshape = 'cylinder'\ndiameter = 0.1\ndraft = " + std::to_string(depth + 0.05) +
           "\n[motion]\nspeed = 0.2\n[water]\nviscosity = 1e-4\n[domain]\nx = [-1, 2]\nz = [-2, 0.2]\n"
           "dimensions = 2\n[resolution]\nnear_hull = " +
           dp + "\n" + more;
}

/// What is found of the shedding, with its level.
std::string shedding(const std::string& text) {
    const Scene scene = scene_of(text);
    for (const Finding& f : scene.hull->findings)
        if (f.name == "vortex_shedding") return (f.level == Finding::Level::note ? "note: " : "warning: ") + f.message;
    return {};
}

TEST(VortexShedding, ACheckSaysWhatARunTakesToShedAndNothingWhereNoneIsExpected) {
    // 1.2 D/sqrt(200) = 8.5 mm of boundary layer: 1.7 mm, and a pair in 0.1/(0.2 0.2) s.
    const std::string on = "[effects]\nviscosity = 'on'\n", off = "[effects]\nviscosity = 'off'\n";
    EXPECT_EQ(shedding(round_section("0.0016", 1, on)),
              "note: at Re = 200 on its height it sheds vortices, about one pair in 2.5 s");
    const std::string coarse = shedding(round_section("0.005", 1, off));
    EXPECT_EQ(coarse.find("warning: at Re = 200"), 0u) << coarse;
    EXPECT_NE(coarse.find("[effects] viscosity = \"on\""), std::string::npos) << coarse;
    EXPECT_NE(coarse.find("particles of 0.0017 m"), std::string::npos) << coarse;
    EXPECT_EQ(coarse.find("still water 0.8 m"), std::string::npos) << coarse;
    const std::string shallow = shedding(round_section("0.0016", 0.5, on));
    EXPECT_NE(shallow.find("floor and still water 0.8 m from its middle, eight of its heights (here 0.5 m)"),
              std::string::npos)
        << shallow;
    EXPECT_EQ(shedding(with(round_section("0.005", 1), "1e-4", "1e-3")), "");  // Re = 20
    EXPECT_EQ(shedding(with(round_section("0.005", 1), "'cylinder'\ndiameter = 0.1",
                            "'box'\nlength = 0.4\nbeam = 0.3\nheight = 0.1")),
              "");  // a plate
}

}  // namespace defaults_test
}  // namespace tw::test
