#include "scene/effects/registry.h"

#include <cmath>
#include <set>
#include <stdexcept>

#include "scene/hash.h"
#include "scene_text.h"

namespace tw::test {
namespace effects_test {

TEST(Effects, Ittc57IsTheLineOf1957) {
    EXPECT_NEAR(ittc57(1e7), 0.003, 1e-12);      // 0.075 / 25
    EXPECT_NEAR(ittc57(1.28e7), 0.00287, 1e-5);  // the reference hull
}

TEST(Effects, ThePlanIsTheRegistryAndEveryChoiceSaysWhy) {
    const Scene s = scene_of(planing);
    ASSERT_EQ(s.effects.size(), effects().size());
    for (std::size_t k = 0; k < s.effects.size(); ++k) {
        const EffectChoice& e = s.effects[k];
        EXPECT_EQ(e.name, effects()[k].name);
        EXPECT_FALSE(e.reason.empty() || e.influence.empty()) << e.name;
        EXPECT_FALSE(e.forced) << e.name;
    }
    EXPECT_FALSE(s.effect_on("viscosity"));
    EXPECT_TRUE(s.effect_on("shifting"));
    EXPECT_THROW(s.effect_on("viscossity"), std::logic_error);  // a misspelt name is no effect that is off
}

TEST(Effects, CheckNamesForcesByTheirDirectionsWhereNothingStreams) {
    const auto said = [](const std::string& text) {
        const Scene scene = scene_of(text);
        return to_text(scene, predict(scene));
    };
    const std::string stream = said(planing),
                      tank = said(
                          "[tank]\nsize = [1, 0.5, 0.8]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 0.5, 0.4]\n"
                          "[resolution]\nnear_hull = 0.05\n");
    EXPECT_NE(stream.find("influence: drag: "), std::string::npos);
    EXPECT_NE(stream.find("; lift: "), std::string::npos);
    EXPECT_EQ(tank.find("influence: drag: "), std::string::npos) << tank;
    EXPECT_EQ(tank.find("; lift: "), std::string::npos) << tank;
    EXPECT_NE(tank.find("influence: force along x: "), std::string::npos) << tank;
    EXPECT_NE(tank.find("; force up: "), std::string::npos) << tank;
}

TEST(Effects, WhatAnEffectNeedsComesFirstAndIsAskedFor) {
    std::set<std::string> before;
    for (const EffectPart& part : effects()) {
        EXPECT_TRUE(part.needs.empty() || before.contains(part.needs)) << part.name;
        EXPECT_TRUE(before.insert(part.name).second) << part.name << " is there twice";
        EXPECT_FALSE(part.meaning.empty()) << part.name;
        const std::string without = part.needs.empty() ? "" : part.needs + " = \"off\"\n",
                          message = complaint(planing + "[effects]\n" + part.name + " = \"on\"\n" + without);
        EXPECT_EQ(message.find("needs " + part.needs + " = \"on\" as well") != std::string::npos, !part.needs.empty())
            << part.name << ": " << message;
        EXPECT_NE(effects_text().find(part.name), std::string::npos);
    }
}

TEST(Effects, SwitchingOneChangesTheSceneHashAndItsParametersCountOnlyThen) {
    const std::string tank =
        "[tank]\nsize = [1, 0.5, 0.8]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 0.5, 0.4]\n"
        "[resolution]\nnear_hull = 0.05\n";
    const std::string sinking =
        "[tank]\nmin = [-0.05, 0, -0.25]\nmax = [0.05, 0.001, 0.02]\n[domain]\ndimensions = 2\n"
        "[[body]]\nshape = \"cylinder\"\ndiameter = 0.02\ndraft = 0.12\ndensity = 1200\n"
        "[resolution]\nnear_hull = 0.002\n[motion]\nkind = \"none\"\n";
    for (const EffectPart& part : effects()) {
        if (part.solved == EffectPart::Solved::by_neither) continue;
        SceneOverrides on, off;
        if (!part.needs.empty()) on.effects[part.needs] = off.effects[part.needs] = true;
        for (const std::string& other : effect_names())
            if (effect_part(other).needs == part.name) on.effects[other] = off.effects[other] = false;
        on.effects[part.name] = true;
        off.effects[part.name] = false;
        const std::string& text = part.name == "friction"           ? planing  // the line is for a hull in a stream
                                  : part.name == "dynamic_pressure" ? sinking  // for a body deep in water
                                                                    : tank;
        const Scene with_it = scene_of(text, on), without = scene_of(text, off);
        EXPECT_TRUE(with_it.effect_on(part.name));
        EXPECT_FALSE(without.effect_on(part.name));
        EXPECT_NE(with_it.hash, without.hash) << part.name;
        for (const SceneKey& key : part.keys) {
            if (key.name == "downstream") continue;  // of streams alone, and refused without the effect: keys_test.cpp
            const std::string header = "[" + key.section + "]\n",
                              line = key.name + " = " +
                                     (key.choices.empty() ? "0.77" : "\"" + key.choices.back() + "\"") + "\n",
                              other = tank.find(header) == std::string::npos ? tank + header + line
                                                                             : with(tank, header, header + line);
            EXPECT_NE(run_hash(scene_of(other, on), "sph"), run_hash(with_it, "sph")) << key.name;
            EXPECT_EQ(run_hash(scene_of(other, off), "sph"), run_hash(without, "sph")) << key.name;
        }
    }
}

TEST(Effects, TheDampingsCoefficientHasTheEffectsNameAndItsOlderSpellingIsRead) {
    const std::string on = planing + "[effects]\nacoustic_damping = \"on\"\n[sph]\n";
    EXPECT_EQ(scene_of(on + "acoustic_damping = 0.5\n").sph.acoustic_damping, 0.5);
    EXPECT_EQ(scene_of(on + "acoustic_damper = 0.5\n").sph.acoustic_damping, 0.5);
    EXPECT_EQ(
        complaint(on + "acoustic_damper = 0.5\nacoustic_damping = 0.4\n"),
        "scene.toml:24:19: [sph] acoustic_damper = 0.5: given twice: it is an older spelling of acoustic_damping; "
        "keep one");
    EXPECT_NE(complaint(on + "acoustic_damper = 7\n").find("[sph] acoustic_damper = 7: out of range"),
              std::string::npos);
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
    const auto bytes = [](const Scene& s) { return predict(s).of("sph").bytes - predict(s).raster_bytes; };
    EXPECT_GT(bytes(with), 3.9 * bytes(without));
    EXPECT_NE(complaint(tank + "scheme = \"rk4_frozen_diffusion\"\n[effects]\nair = \"on\"\n")
                  .find("needs a time step with a single evaluation"),
              std::string::npos);
    EXPECT_NE(complaint(planing + "[effects]\nair = \"on\"\n").find("in tanks only"), std::string::npos);
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
         {"viscosity", "surface_tension", "cavitation", "forcing_zones", "acoustic_damping", "tension_control"}) {
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

}  // namespace effects_test
}  // namespace tw::test
