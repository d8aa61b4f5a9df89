// What the plan of effects bounds as numbers: how far the truth may lie from what a run without them computes.
#include <algorithm>
#include <cmath>

#include "record/influence_words.h"
#include "scene/effects/registry.h"
#include "scene/new_record.h"
#include "scene/water/dry_floor.h"
#include "scene_text.h"

namespace tw::test {
namespace bounds_test {

/// A tank of 4 x 2 x 1.6 m with water from x = 0 to `length`, 1.2 m high.
std::string tank(const std::string& length, const std::string& more = "") {
    return "[tank]\nsize = [4, 2, 1.6]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [" + length + ", 2, 1.2]\n" + more +
           "[motion]\nkind = \"none\"\n[resolution]\nnear_hull = 0.05\n";
}
const std::string wet_bed = "[[water_block]]\nmin = [1, 0, 0]\nmax = [4, 2, 0.1]\n";

const EffectBound* bound(const Scene& s, const std::string& effect, const std::string& of) {
    const auto e = std::ranges::find(s.effects, effect, &EffectChoice::name);
    if (e == s.effects.end()) return nullptr;
    const auto b = std::ranges::find(e->bounds, of, &EffectBound::of);
    return b == e->bounds.end() ? nullptr : &*b;
}

TEST(Bounds, DryFloorIsWhatNoBlockStandsOn) {
    EXPECT_NEAR(dry_floor(scene_of(tank("1"))), 0.75, 1e-12);
    EXPECT_NEAR(dry_floor(scene_of(tank("1", wet_bed))), 0, 1e-12);
    EXPECT_NEAR(dry_floor(scene_of(tank("1", "[[water_block]]\nmin = [0, 0, 1.2]\nmax = [4, 2, 1.4]\n"))), 0.75, 1e-12)
        << "a block above the floor wets none of it";
    EXPECT_NEAR(dry_floor(scene_of(tank("1", "[[water_block]]\nmin = [3, 1, 0]\nmax = [4, 2, 0.5]\n"))), 0.625, 1e-12);
}

TEST(Bounds, WaterIsLetGoWhereItsBlocksAreNotLevel) {
    EXPECT_EQ(released_height(scene_of(tank("1"))), 1.2);
    EXPECT_EQ(released_height(scene_of(tank("4"))), 0);
    const Scene dam = scene_of(tank("1"));
    EXPECT_EQ(new_record(dam, "sph").numbers.at("released_height"), 1.2);
    EXPECT_FALSE(new_record(scene_of(tank("4")), "fvm").numbers.contains("released_height"));
}

TEST(Bounds, FrictionLeftOutOverADryFloorMakesFrontsEarlyAndPressesTooHard) {
    const Scene s = scene_of(tank("1"));
    ASSERT_FALSE(s.effect_on("viscosity"));
    const EffectBound *arrival = bound(s, "viscosity", "arrival"), *pressure = bound(s, "viscosity", "pressure"),
                      *impulse = bound(s, "viscosity", "impulse"), *height = bound(s, "viscosity", "height");
    ASSERT_TRUE(arrival && pressure && impulse && height && bound(s, "viscosity", "peak"));
    EXPECT_EQ(arrival->below, 0) << "no friction makes it earlier";
    EXPECT_NEAR(arrival->above, 0.14, 1e-12);
    EXPECT_EQ(pressure->below, impulse->below) << "in open water, on no wall of the tank";
    EXPECT_NEAR(impulse->below, 1 - 1 / (1.14 * 1.14), 1e-12) << "momentum goes with the square of the speed";
    EXPECT_EQ(impulse->above, 0);
    EXPECT_EQ(bound(s, "viscosity", "peak")->below, impulse->below);
    EXPECT_FALSE(bound(s, "viscosity", "level")) << "the water is as much";
    EXPECT_NEAR(height->above, 0.14, 1e-12) << "a slower front is a thicker one";
    EXPECT_FALSE(bound(s, "viscosity", "motion"));
    for (const EffectBound* b : {arrival, pressure, impulse, height}) EXPECT_FALSE(b->source.empty()) << b->of;
    // The words that check prints have them.
    const auto e = std::ranges::find(s.effects, "viscosity", &EffectChoice::name);
    EXPECT_NE(e->influence.find("; arrival: up to 14 % later"), std::string::npos) << e->influence;
    EXPECT_NE(e->influence.find("; impulse, peak, pressure: up to 23 % less"), std::string::npos) << e->influence;
}

TEST(Bounds, TheSideOfAGaugesPressureFollowsFromItsPlace) {
    const auto gauge = [](const std::string& name, const std::string& place) {
        return "[[probe]]\nname = \"" + name + "\"\npressure = " + place + "\n";
    };
    const Scene s = scene_of(tank("1", gauge("low", "[4, 1, 0.06]") + gauge("between", "[4, 1, 0.2]") +
                                           gauge("high", "[4, 1, 0.4]") + gauge("inside", "[3, 1, 0.06]")));
    const EffectBound *low = bound(s, "viscosity", "pressure:low"), *high = bound(s, "viscosity", "pressure:high"),
                      *between = bound(s, "viscosity", "pressure:between");
    ASSERT_TRUE(low && high && between);
    EXPECT_NEAR(low->below, 1 - 1 / 1.55, 1e-12) << "55 % too hard: the roller in the corner takes it away";
    EXPECT_EQ(low->above, 0);
    EXPECT_EQ(high->below, 0);
    EXPECT_NEAR(high->above, 1 / 0.70 - 1, 1e-12) << "30 % too soft";
    EXPECT_EQ(between->below, low->below) << "either side";
    EXPECT_EQ(between->above, high->above);
    EXPECT_FALSE(bound(s, "viscosity", "pressure:inside")) << "on no wall";
}

TEST(Bounds, OverAWetFloorFrictionIsFeltInTheBoundaryLayerAlone) {
    const Scene s = scene_of(tank("1", wet_bed));
    const double Re = std::sqrt(2 * 9.81 * 1.2) * 1.2 / 1e-6;
    for (const char* kind : {"pressure", "peak", "height", "level", "arrival", "impulse", "motion"}) {
        const EffectBound* b = bound(s, "viscosity", kind);
        ASSERT_TRUE(b) << kind;
        EXPECT_NEAR(b->below, 1.72 / std::sqrt(Re), 1e-3 * b->below) << kind;
        EXPECT_EQ(b->below, b->above) << kind;
    }
}

TEST(Bounds, SurfaceTensionAndTheParticlesCompressibilityAreShares) {
    const Scene s = scene_of(tank("1"));
    const double U2 = 2 * 9.81 * 1.2, We = 1000 * U2 * 1.2 / 0.072, Ma2 = U2 / (s.sph.c0 * s.sph.c0);
    for (const char* kind : {"pressure", "peak", "height", "level", "arrival", "impulse", "motion"}) {
        const EffectBound *tension = bound(s, "surface_tension", kind), *sound = bound(s, "compressibility", kind);
        ASSERT_TRUE(tension && sound) << kind;
        EXPECT_NEAR(tension->below, 1 / We, 0.02 / We) << kind;
        EXPECT_NEAR(sound->above, Ma2, 1e-6 * Ma2) << kind;
        EXPECT_EQ(sound->elements, "particles") << "the mesh method's water is incompressible";
        EXPECT_EQ(tension->elements, "");
    }
}

TEST(Bounds, NoneIsNegativeAndAllSayWhereTheyAreFrom) {
    for (const std::string& text : {tank("1"), tank("1", wet_bed), tank("4")})
        for (const EffectChoice& e : scene_of(text).effects)
            for (const EffectBound& b : e.bounds) {
                EXPECT_TRUE(b.below >= 0 && b.above >= 0 && b.below + b.above > 0) << e.name << " " << b.of;
                EXPECT_FALSE(b.source.empty()) << e.name << " " << b.of;
            }
}

}  // namespace bounds_test
}  // namespace tw::test
