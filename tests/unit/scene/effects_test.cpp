#include "scene/effects_plan.h"

#include <cmath>

#include "scene_text.h"

namespace tw::test {
namespace {

TEST(Effects, Ittc57IsTheLineOf1957) {
    EXPECT_NEAR(ittc57(1e7), 0.003, 1e-12);      // 0.075 / 25
    EXPECT_NEAR(ittc57(1.28e7), 0.00287, 1e-5);  // the reference hull
}

TEST(Effects, EveryChoiceSaysWhy) {
    const Scene s = scene_of(planing);
    for (const char* name :
         {"viscosity", "no_slip", "turbulence", "surface_tension", "air", "compressibility", "gravity", "cavitation",
          "damping_layers", "acoustic_damping", "shifting", "tension_control"}) {
        bool found = false;
        for (const EffectChoice& e : s.effects) {
            if (e.name != name) continue;
            found = true;
            EXPECT_FALSE(e.reason.empty() || e.influence.empty()) << name;
            EXPECT_FALSE(e.forced) << name;
        }
        EXPECT_TRUE(found) << name;
    }
    EXPECT_FALSE(s.effect_on("viscosity"));
    EXPECT_TRUE(s.effect_on("shifting"));
}

TEST(Effects, TheListOfNamesIsThePlans) {
    std::vector<std::string> planned;
    for (const EffectChoice& e : scene_of(planing).effects) planned.push_back(e.name);
    EXPECT_EQ(effect_names(), planned);
    for (const std::string& name : effect_names()) {
        const std::string needed = effect_needed_by(name);
        const bool refused =
            complaint(planing + "[effects]\n" + name + " = \"on\"\n").find("needs ") != std::string::npos;
        EXPECT_EQ(needed.empty(), !refused) << name;
    }
}

TEST(Effects, WhatThisVersionCannotSolveIsRefusedAndOffIsAccepted) {
    const std::string message = complaint(planing + "[effects]\ncompressibility = \"on\"\n");
    EXPECT_NE(message.find("[effects] compressibility = \"on\": "), std::string::npos) << message;
    EXPECT_EQ(complaint(planing + "[effects]\ncompressibility = \"off\"\n"), "");
}

TEST(Effects, AirIsOnOnDemandInTanksAndSaysWhatItCosts) {
    const std::string tank =
        "[tank]\nsize = [1, 0.5, 0.8]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 0.5, 0.4]\n"
        "[resolution]\nnear_hull = 0.05\n[run]\nduration = 1\n[sph]\nc0 = 40\n";
    const Scene without = scene_of(tank), with = scene_of(tank + "[effects]\nair = \"on\"\n");
    EXPECT_FALSE(without.effect_on("air"));
    EXPECT_TRUE(with.effect_on("air"));
    for (const Scene* s : {&without, &with})
        for (const EffectChoice& e : s->effects)
            if (e.name == "air") {
                // three times the water's volume besides it, and sound faster than the water's
                EXPECT_GT(e.cost, 4 * (343.0 + 3) / (40 + 3) - 1.5);
                EXPECT_LT(e.cost, 4 * 343.0 / 40);
                EXPECT_NE(e.reason.find("density ratio 0.0012"), std::string::npos) << e.reason;
            }
    EXPECT_NEAR(predict(with).air_particles, 3 * predict(with).particles, 1);
    EXPECT_GT(predict(with).sph_bytes, 3.9 * predict(without).sph_bytes);
    EXPECT_NE(complaint(tank + "scheme = \"rk4_frozen_diffusion\"\n[effects]\nair = \"on\"\n")
                  .find("needs a time step of one evaluation"),
              std::string::npos);
    EXPECT_NE(complaint(planing + "[effects]\nair = \"on\"\n").find("in tanks alone"), std::string::npos);
}

TEST(Effects, FrictionNeedsViscosity) {
    EXPECT_NE(complaint(planing + "[effects]\nturbulence = \"on\"\n").find("needs viscosity"), std::string::npos);
    EXPECT_NE(complaint(planing + "[effects]\nno_slip = \"on\"\n").find("needs viscosity"), std::string::npos);
    const Scene s = scene_of(planing + "[effects]\nviscosity = \"on\"\n");
    EXPECT_TRUE(s.effect_on("viscosity"));
    EXPECT_TRUE(s.effect_on("no_slip"));
    EXPECT_TRUE(s.effect_on("turbulence"));  // Re = 2e7
    EXPECT_FALSE(scene_of(planing + "[effects]\nviscosity = \"on\"\nno_slip = \"off\"\n").effect_on("no_slip"));
    EXPECT_NE(complaint(planing + "[water]\nviscosity = 0\n[effects]\nviscosity = \"on\"\n").find("[water] viscosity"),
              std::string::npos);
}

TEST(Effects, ThickSlowWaterIsViscousAndSmallThingsFeelTheSurface) {
    // a laminar layer of 5 L/sqrt(Re) thicker than five spacings
    EXPECT_TRUE(scene_of(planing + "[water]\nviscosity = 0.1\n").effect_on("viscosity"));
    EXPECT_FALSE(scene_of(planing).effect_on("viscosity"));
    // We < 100: a cup of water, 1 cm deep
    EXPECT_TRUE(scene_of("[tank]\nmin = [0, 0, -0.01]\nmax = [0.02, 0.02, 0.01]\n[motion]\nkind = \"none\"\n"
                         "[resolution]\nnear_hull = \"1 mm\"\n[run]\nduration = \"0.1 s\"\n")
                    .effect_on("surface_tension"));
    EXPECT_FALSE(scene_of(planing).effect_on("surface_tension"));
}

TEST(Effects, ARunWithAnEffectIsAnotherRun) {
    const Scene plain = scene_of(planing);
    for (const char* name :
         {"viscosity", "surface_tension", "cavitation", "damping_layers", "acoustic_damping", "tension_control"}) {
        const Scene s = scene_of(planing + "[effects]\n" + name + " = \"on\"\n");
        EXPECT_NE(s.hash, plain.hash) << name;
        EXPECT_TRUE(s.effect_on(name));
    }
    const Scene still = scene_of(planing + "[effects]\ngravity = \"off\"\n");
    EXPECT_EQ(still.water.gravity, 0);
    EXPECT_NE(still.hash, plain.hash);
}

TEST(Effects, ACommandLineForcesThemLikeTheScene) {
    SceneOverrides overrides;
    overrides.effects = {{"surface_tension", true}, {"shifting", false}};
    const Scene s = scene_of(planing, overrides);
    EXPECT_TRUE(s.effect_on("surface_tension"));
    EXPECT_EQ(s.sph.shifting, 0);
}

TEST(Effects, ShiftingOffReachesTheSolver) {
    const Scene s = scene_of(planing + "[effects]\nshifting = \"off\"\n");
    EXPECT_EQ(s.sph.shifting, 0);
    EXPECT_FALSE(s.effect_on("shifting"));
    EXPECT_GT(scene_of(planing).sph.shifting, 0);
}

}  // namespace
}  // namespace tw::test
