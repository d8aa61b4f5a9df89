#include <cmath>

#include "scene_text.h"

namespace tw::test {
namespace {

const std::string tank =
    "[tank]\nsize = [1, 1, 1]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 1, 0.5]\n[resolution]\nnear_hull = "
    "0.01\n[run]\nduration = 1\n[sampling]\ninterval = 0.1\n";

TEST(Cost, ParticlesAreTheWatersVolumeOverTheirOwn) {
    const Prediction p = predict(scene_of(tank));
    EXPECT_NEAR(p.particles, 0.25 / 1e-6, 1);
    EXPECT_NEAR(p.cells, 1e6, 1);
}

TEST(Cost, HalvingTheSpacingCostsSixteenTimes) {
    const Prediction coarse = predict(scene_of(tank)), fine = predict(scene_of(with(tank, "0.01", "0.005")));
    EXPECT_NEAR(fine.sph_seconds / coarse.sph_seconds, 16, 0.01);  // eight times the particles, half the step
    EXPECT_GT(fine.fvm_seconds / coarse.fvm_seconds, 12);          // meshing grows with the cells alone
}

TEST(Cost, TheReferenceMeshIsPredictedWithinATenth) {
    // Measured: 74 thousand cells (cells L/12, wet bottom beam/48, domain -5..9 x 0..4 x -3..2 m), with these levels.
    Scene s = scene_of(
        with(with(planing, "near_hull = \"0.05 m\"", "near_hull = 0.0208333333333333\nspacing = 0.3333333333333333"),
             "[motion]", "[domain]\nx = [-5, 9]\ny = [-4, 4]\nz = [-3, 2]\n[motion]"));
    for (RefinementBox& r : s.refinement) {
        if (r.name == "near") r.level = 2;
        if (r.name == "wake") r.level = 1;
    }
    const Prediction p = predict(s);
    EXPECT_NEAR(p.cells / 74e3, 1, 0.1);
}

TEST(Cost, HalfAHullIsHalfTheWork) {
    const Prediction half = predict(scene_of(planing)),
                     whole = predict(scene_of(with(planing, "half     = true", "half     = false")));
    EXPECT_NEAR(whole.particles / half.particles, 2, 0.01);
    EXPECT_NEAR(whole.cells / half.cells, 2, 0.05);
}

TEST(Cost, BillionsOfParticlesAreRefusedWithTheNumberAndThePlace) {
    const Scene s = scene_of(with(tank, "0.01", "0.0003"));  // 0.25 m3 / (0.3 mm)^3 = 9.26e9
    const Prediction p = predict(s);
    EXPECT_NEAR(p.particles / 9.26e9, 1, 0.01);
    std::string message;
    try {
        refuse_oversize(s, p);
    } catch (const InputError& e) { message = e.what(); }
    EXPECT_NE(
        message.find(
            "scene.toml:7:13: [resolution] near_hull = 0.0003: too fine for this machine: 9.26e+09 particles need"),
        std::string::npos)
        << message;
    EXPECT_NO_THROW(refuse_oversize(scene_of(tank), predict(scene_of(tank))));
}

}  // namespace
}  // namespace tw::test
