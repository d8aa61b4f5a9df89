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
    for (const char* name : {"viscosity", "turbulence", "surface_tension", "air", "compressibility", "shifting"}) {
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

TEST(Effects, WhatOnlyOneMethodCouldSolveIsRefusedAndOffIsAccepted) {
    for (const char* name : {"viscosity", "turbulence", "surface_tension", "air", "compressibility"}) {
        const std::string message = complaint(planing + "[effects]\n" + name + " = \"on\"\n");
        EXPECT_NE(message.find(std::string("[effects] ") + name + " = \"on\": "), std::string::npos) << message;
        EXPECT_EQ(complaint(planing + "[effects]\n" + name + " = \"off\"\n"), "") << name;
    }
}

TEST(Effects, ShiftingOffReachesTheSolver) {
    const Scene s = scene_of(planing + "[effects]\nshifting = \"off\"\n");
    EXPECT_EQ(s.sph.shifting, 0);
    EXPECT_FALSE(s.effect_on("shifting"));
    EXPECT_GT(scene_of(planing).sph.shifting, 0);
}

}  // namespace
}  // namespace tw::test
