// What the plan does for slow bodies in viscous water and for drops: the numbers of the particle method that it sets.
#include <cmath>

#include "scene/water/capillary.h"
#include "scene/water/quiet_layer.h"
#include "scene_text.h"

namespace tw::test {
namespace slow_bodies_test {

const std::string settling =
    "[tank]\nmin = [-0.05, 0, -0.25]\nmax = [0.05, 0.001, 0.02]\n[domain]\ndimensions = 2\n"
    "[water]\nviscosity = \"1e-3 m2/s\"\n"
    "[[body]]\nname = \"rod\"\nshape = \"cylinder\"\ndiameter = \"20 mm\"\ndraft = \"0.12 m\"\ndensity = 1200\n"
    "[motion]\nkind = \"none\"\n[resolution]\nnear_hull = \"2 mm\"\n[run]\nduration = \"0.6 s\"\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(SlowBodies, SpeedIsThatOfTheBalanceOfWeightAndDrag) {
    const Scene s = scene_of(settling);
    const SlowBody rod = slow_body(s, s.bodies[0]);
    const double pull = 200 * 9.81 * M_PI * 1e-4, U = rod.speed;
    EXPECT_NEAR(4 * M_PI * U + 1000 * 0.02 * U * U / 2, pull, 0.01 * pull);
    EXPECT_NEAR(rod.size, 0.02, 1e-4);
    EXPECT_NEAR(rod.reynolds, U * 0.02 / 1e-3, 0.01 * rod.reynolds);
    EXPECT_NEAR(rod.hydrostatic, 1000 * 9.81 * 0.11, 1);
}

TEST(SlowBodies, InDeepOilTheParticlesCarryTheDynamicPressure) {
    const Scene s = scene_of(settling);
    ASSERT_TRUE(s.effect_on("dynamic_pressure"));
    const QuietLayer layer = quiet_layer(s);
    EXPECT_EQ(layer.surface, 0);
    EXPECT_LE(layer.bottom, -8 * 1.55 * 0.002);
    EXPECT_GT(layer.bottom, -0.1 + 4 * 1.55 * 0.002) << "the rod's top is at -0.1 m";
    // ten times the speed of a fall through the layer, not through the tank
    EXPECT_NEAR(s.sph.c0, 10 * std::sqrt(2 * 9.81 * -layer.bottom), 1e-9);
    EXPECT_EQ(s.sph.alpha, 0) << "the water has a viscosity of its own";
}

TEST(SlowBodies, WhatTheFileSaysStays) {
    const Scene own = scene_of(settling + "[sph]\nc0 = 15\nalpha = 0.02\n");
    EXPECT_TRUE(own.effect_on("dynamic_pressure"));
    EXPECT_EQ(own.sph.c0, 15);
    EXPECT_EQ(own.sph.alpha, 0.02);
    const Scene off = scene_of(settling + "[effects]\ndynamic_pressure = \"off\"\n");
    EXPECT_NEAR(off.sph.c0, 10 * std::sqrt(2 * 9.81 * 0.25), 1e-9);
}

TEST(SlowBodies, FastOnesAndThoseAtTheSurfaceKeepTheWholePressure) {
    EXPECT_FALSE(scene_of(with(settling, "1e-3 m2/s", "1e-6 m2/s")).effect_on("dynamic_pressure"));
    EXPECT_FALSE(scene_of(with(settling, "draft = \"0.12 m\"", "draft = \"10 mm\"")).effect_on("dynamic_pressure"));
    const std::string near = with(settling, "draft = \"0.12 m\"", "draft = \"40 mm\"");
    EXPECT_FALSE(scene_of(near).effect_on("dynamic_pressure"));
    const std::string refused = complaint(near + "[effects]\ndynamic_pressure = \"on\"\n");
    EXPECT_NE(refused.find("the water over the highest solid is 0.02 m deep; expected 0.0372 m"), std::string::npos)
        << refused;
    // and the plan says by how much its drag will be off
    bool warned = false;
    const Scene shallow = scene_of(near);
    for (const Finding& f : shallow.bodies[0].findings) warned = warned || f.name == "slow_body";
    EXPECT_TRUE(warned);
}

TEST(SlowBodies, TooFewSpacingsAreWarnedOf) {
    const auto warned = [](const std::string& text) {
        const Scene scene = scene_of(text);
        for (const Finding& f : scene.bodies[0].findings)
            if (f.message.find("needs ten spacings") != std::string::npos) return true;
        return false;
    };
    EXPECT_FALSE(warned(settling));
    EXPECT_TRUE(warned(with(settling, "near_hull = \"2 mm\"", "near_hull = \"2.5 mm\"")));
    // at Re = 40 its layer is 1.2 D/sqrt(Re) = 3.8 mm
    EXPECT_TRUE(warned(with(settling, "1e-3 m2/s", "1e-4 m2/s")));
}

TEST(SlowBodies, AHullDeepInASlowStreamIsWarnedOf) {
    const std::string stream =
        "[hull]\nshape = \"cylinder\"\ndiameter = \"20 mm\"\ndraft = \"0.19 m\"\n[water]\nviscosity = \"1e-4 m2/s\"\n"
        "[motion]\nspeed = 0.1\n[domain]\ndimensions = 2\nx = [-0.16, 0.24]\nz = [-0.36, 0.02]\n"
        "[resolution]\nnear_hull = \"2 mm\"\n[effects]\nviscosity = \"on\"\n";
    const auto warned = [](const std::string& text) {
        const Scene scene = scene_of(text);
        for (const Finding& f : scene.hull->findings)
            if (f.name == "slow_body") return f.message.find("Re = 20, and ") == 0;
        return false;
    };
    EXPECT_TRUE(warned(stream));
    EXPECT_FALSE(warned(stream + "gravity = \"off\"\n"));
    EXPECT_FALSE(warned(with(stream, "speed = 0.1", "speed = 3")));
}

const std::string drop =
    "[tank]\nmin = [-0.008, 0, -0.008]\nmax = [0.008, 0.00025, 0.008]\n[domain]\ndimensions = 2\n"
    "[[water_block]]\nmin = [-0.003, 0, -0.0020833]\nmax = [0.003, 0.00025, 0.0020833]\n"
    "[motion]\nkind = \"none\"\n[resolution]\nnear_hull = \"0.25 mm\"\n[run]\nduration = \"0.1 s\"\n"
    "[effects]\ngravity = \"off\"\nsurface_tension = \"on\"\n";

TEST(SurfaceTensionPlan, TakesWhatDropsWantAndSaysWhatItCosts) {
    const Scene s = scene_of(drop);
    EXPECT_EQ(s.sph.h_over_dp, 2);
    EXPECT_EQ(s.sph.alpha, 0.1);
    // 10 sqrt(4 sigma / (rho h))
    EXPECT_NEAR(s.sph.c0, 10 * std::sqrt(4 * 0.072 / (1000 * 2 * 0.25e-3)), 1e-9);
    // the drop's surface on its way to a circle, of 0.25 mm of span
    const double area = 6e-3 * 2 * 2.0833e-3, released = 2 * (6e-3 + 2 * 2.0833e-3) - 2 * std::sqrt(M_PI * area);
    EXPECT_NEAR(surface_energy(s), 0.072 * released * 0.25e-3, 1e-6 * surface_energy(s));
    for (const EffectChoice& e : s.effects) {
        if (e.name == "surface_tension") {
            EXPECT_NE(e.reason.find("h/dp = 2, alpha = 0.1 and c0 = 7.59 m/s"), std::string::npos) << e.reason;
            EXPECT_NE(e.reason.find("times as long"), std::string::npos) << e.reason;
        }
    }
    const Scene own = scene_of(drop + "[sph]\nh_over_dp = 1.6\nalpha = 0.05\nc0 = 9\n");
    EXPECT_EQ(own.sph.h_over_dp, 1.6);
    EXPECT_EQ(own.sph.alpha, 0.05);
    EXPECT_EQ(own.sph.c0, 9);
    const Scene without = scene_of(with(drop, "surface_tension = \"on\"", "surface_tension = \"off\""));
    EXPECT_EQ(without.sph.h_over_dp, SphOptions{}.h_over_dp);
    EXPECT_EQ(without.sph.alpha, SphOptions{}.alpha);
}

// With the weight of 0.8 m of water, which is off, the sound speed would be forty times as large, and the run as long.
TEST(SurfaceTensionPlan, OfASlowStreamWithoutGravityRaisesTheSoundSpeedByTheSurfaceAlone) {
    const Scene s = scene_of(
        "[hull]\nshape = \"cylinder\"\ndiameter = \"0.1 m\"\ndraft = \"0.45 m\"\n"
        "[water]\nviscosity = \"5e-4 m2/s\"\ndepth = \"0.8 m\"\n[domain]\ndimensions = 2\n"
        "[motion]\nkind = \"stream\"\nspeed = \"0.1 m/s\"\n[resolution]\nnear_hull = \"5 mm\"\n"
        "[effects]\ngravity = \"off\"\nsurface_tension = \"on\"\n");
    EXPECT_NEAR(s.sph.c0, 10 * std::sqrt(4 * 0.072 / (1000 * 2 * 5e-3)), 1e-9);
}

// A box 0.4 m long in a stream of 0.1 m/s: We = 56, Bo = 22 000. The water's weight holds the surface, not its tension.
TEST(SurfaceTensionPlan, IsOffWhereGravityHoldsTheSurface) {
    const std::string box =
        "[hull]\nshape = \"box\"\nlength = \"0.4 m\"\nbeam = \"0.3 m\"\nheight = \"0.2 m\"\ndraft = \"0.1 m\"\n"
        "[domain]\ndimensions = 2\nx = [\"-0.6 m\", \"1 m\"]\nz = [\"-0.5 m\", \"0.4 m\"]\n"
        "[motion]\nkind = \"stream\"\nspeed = \"0.1 m/s\"\n[resolution]\nnear_hull = \"12.5 mm\"\n";
    const Scene s = scene_of(box);
    EXPECT_FALSE(s.effect_on("surface_tension"));
    EXPECT_EQ(s.sph.alpha, SphOptions{}.alpha);
    EXPECT_TRUE(scene_of(box + "[effects]\ngravity = \"off\"\n").effect_on("surface_tension"));
    // asked for all the same: the viscosity alpha c0 h of a drop, at the sound speed of half a metre of water
    const Scene on = scene_of(box + "[effects]\nsurface_tension = \"on\"\n");
    EXPECT_NEAR(on.sph.c0, 10 * std::sqrt(2 * 9.81 * 0.5), 1e-9);
    EXPECT_NEAR(on.sph.alpha, std::max(SphOptions{}.alpha, 0.1 * 10 * capillary_speed(on) / on.sph.c0), 1e-9);
    EXPECT_LT(on.sph.alpha, 0.02);
}

}  // namespace slow_bodies_test
}  // namespace tw::test
