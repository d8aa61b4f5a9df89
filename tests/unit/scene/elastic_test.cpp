#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "scene/hash.h"
#include "scene/mesh/mesh_motion.h"
#include "scene_text.h"

namespace tw::test {
namespace elastic_test {

TEST(ElasticScene, HasItsPlateAndTheSurfaceThatTheWaterSees) {
    const Scene scene = scene_of(dropped);
    const MovingBody& b = scene.bodies.at(0);
    ASSERT_TRUE(b.plate());
    EXPECT_NEAR(b.plate()->thickness(), 0.004, 1e-15);
    EXPECT_NEAR(b.plate()->skin, 6 * 0.02, 1e-15);
    const Vec3 size = b.surface.bounds().size();
    EXPECT_LT((size - Vec3(0.4, 0.2, 0.12)).norm(), 1e-12);
    EXPECT_NEAR(b.motion.mass.mass, 5, 1e-12);
    EXPECT_EQ(b.motion.velocity, Vec3(0, 0, -2));
    EXPECT_NE(scene_hash(scene), scene_hash(scene_of(with(dropped, "60 GPa", "50 GPa"))));
    EXPECT_NE(scene_hash(scene), scene_hash(scene_of(with(dropped, "[0 C/90 C]s", "[90 C/0 C]s"))));
}

TEST(ElasticScene, OfTwoDimensionsIsAStripPerMetre) {
    const std::string flat =
        with(with(with(dropped, "[motion]", "[domain]\ndimensions = 2\n[motion]"), "\"y_min\", \"y_max\"", ""),
             ", \"x_max\", ", ", \"x_max\"");
    const MovingBody b = scene_of(flat).bodies.at(0);
    EXPECT_NEAR(b.surface.bounds().size().y(), 1, 1e-12);
    EXPECT_FALSE(b.motion.free.along[1]);
}

/// What was found and what to do, at the key's place; nothing is written.
TEST(ElasticScene, RefusesWhatIsNoPlate) {
    const struct {
        std::string from, to, message;
    } wrong[] = {
        {"layup = \"[0 C/90 C]s\"", "layup = \"[0 C/90 D]s\"", "D"},
        {"nu12 = 0.25", "nu12 = 3", "no material has the constants of ply C"},
        {"mass = \"5 kg\"", "mass = \"0.1 kg\"", "the plate alone has 0.48 kg"},
        {"mass = \"5 kg\"\n", "", "needs the mass of plate and frame"},
        {"cells = [8, 4]", "cells = [8, 0]", "expected whole numbers"},
        {"plate = [\"0.4 m\", \"0.2 m\"]", "plate = [0, \"0.2 m\"]", "no area"},
        {"carried = [\"x_min\"", "clamped = [\"x_min\"]\ncarried = [\"x_min\"", "supported twice"},
        {"velocity = [0, 0, \"-2 m/s\"]", "skin = \"1 mm\"", "thinner than the plate"},
        {"position = [\"30 mm\", 0, \"0.5 m\"]", "position = [\"30 mm\", 0, \"0.6 m\"]", "gauge strain"},
        {"near_hull = \"20 mm\"", "near_hull = \"20 mm\"\n[sph]\nscheme = \"symplectic_euler\"", "kick_drift_kick"},
        {"near_hull = \"20 mm\"", "near_hull = \"20 mm\"\n[effects]\nviscosity = \"on\"\nno_slip = \"on\"", "friction"},
    };
    for (const auto& [from, to, message] : wrong) {
        const std::string found = complaint(with(dropped, from, to));
        EXPECT_NE(found.find(message), std::string::npos) << to << ": '" << found << "'";
        EXPECT_EQ(found.find("scene.toml:"), 0u) << found;
    }
    const std::string unsupported =
        with(dropped, "carried = [\"x_min\", \"x_max\", \"y_min\", \"y_max\"]\nmass = \"5 kg\"\n", "");
    EXPECT_EQ(complaint(unsupported), "") << "a plate with a velocity may fly";
    EXPECT_NE(complaint(with(unsupported, "velocity = [0, 0, \"-2 m/s\"]\n", "")).find("neither support nor frame"),
              std::string::npos);
}

TEST(ElasticScene, RefusesWhatNoMaterialIsAndBodiesThatOverlap) {
    const std::string isotropic = with(dropped, "layup = \"[0 C/90 C]s\"",
                                       "thickness = 0.01\nyoungs_modulus = 7e10\npoisson = 0.3\ndensity = 2700");
    ASSERT_EQ(complaint(isotropic), "") << "or nothing below is seen";
    const std::string beside = with(dropped, "[[gauge]]",
                                    "[[body]]\nname = \"box\"\nshape = \"box\"\nlength = 0.2\nbeam = 0.2\n"
                                    "height = 0.2\ndraft = \"-0.7 m\"\nmass = 1\n[[gauge]]");
    ASSERT_EQ(complaint(beside), "");
    const struct {
        std::string scene, message;
    } wrong[] = {
        {with(isotropic, "poisson = 0.3", "poisson = 0.5"),
         "poisson = 0.5: no material has these constants: Poisson's"},
        {with(isotropic, "poisson = 0.3", "poisson = -1"), "poisson = -1: out of range; expected greater than -1"},
        {with(isotropic, "poisson = 0.3", "poisson = 0.6"), "poisson = 0.6: out of range"},
        {with(isotropic, "youngs_modulus = 7e10\n", ""), "youngs_modulus: missing"},
        {with(dropped, "layup = \"[0 C/90 C]s\"", "layup = \"[0/90]s\""), "layup = \"[0/90]s\": "},
        {with(beside, "-0.7 m", "-0.5 m"), "body box starts in body laminate or within half a particle of it"},
    };
    for (const auto& [scene, message] : wrong) {
        const std::string found = complaint(scene);
        EXPECT_NE(found.find(message), std::string::npos) << message << ": '" << found << "'";
        EXPECT_EQ(found.find("scene.toml:"), 0u) << found;
    }
}

/// The sheet of a file is the rectangle of the same elements, to the bit of its mass.
TEST(ElasticScene, TakesItsMeshFromAFile) {
    write_text_atomically(scratch() / "sheet.inp", sheet_mesh(0.2));
    const std::string meshed =
        with(with(dropped, "plate = [\"0.4 m\", \"0.2 m\"]\ncells = [8, 4]", "mesh = \"sheet.inp\""),
             "\"x_min\", \"x_max\", \"y_min\", \"y_max\"", "\"ENDS\"");
    const std::string drawn =
        with(with(dropped, "[8, 4]", "[4, 2]"), "\"x_min\", \"x_max\", \"y_min\", \"y_max\"", "\"x_min\", \"x_max\"");
    const MovingBody file = scene_of(meshed).bodies.at(0), rectangle = scene_of(drawn).bodies.at(0);
    ASSERT_TRUE(file.plate() && file.plate()->mesh);
    EXPECT_EQ(file.plate()->elements(), 8);
    EXPECT_LT((file.surface.bounds().size() - rectangle.surface.bounds().size()).norm(), 1e-12);
    EXPECT_NEAR(file.plate()->first_period() / rectangle.plate()->first_period(), 1, 1e-9);
    EXPECT_NEAR(file.plate()->cell(), rectangle.plate()->cell(), 1e-12);

    const struct {
        std::string from, to, message;
    } wrong[] = {
        {"sheet.inp", "none.inp", "cannot be read"},
        {"\"ENDS\"", "\"ENDS\", \"TIP\"", "'TIP' is no node set of the mesh; it has: ENDS"},
        {"mesh =", "plate = [1, 1]\nmesh =", "keep one"},
        {"[motion]", "[domain]\ndimensions = 2\n[motion]", "three dimensions"},
        {"mesh =", "unit = \"mm\"\nmesh =", "gauge strain"},
    };
    for (const auto& [from, to, message] : wrong) {
        const std::string found = complaint(with(meshed, from, to));
        EXPECT_NE(found.find(message), std::string::npos) << to << ": '" << found << "'";
        EXPECT_EQ(found.find("scene.toml:"), 0u) << found;
    }
    write_text_atomically(scratch() / "sheet.inp", with(sheet_mesh(0.2), "101, 1, 2, 7, 6", "101, 1, 6, 7, 2"));
    const std::string turned = complaint(meshed);
    EXPECT_NE(turned.find("sheet.inp: element 102 is turned the other way than element 101"), std::string::npos)
        << turned;
}

/// Whether the first body of a scene has a finding of that name.
bool warns(const std::string& text, const std::string& name) {
    const Scene scene = scene_of(text);
    return std::ranges::any_of(scene.bodies.at(0).findings, [&](const Finding& f) { return f.name == name; });
}

TEST(ElasticScene, WarnsOfElementsMuchCoarserThanTheParticles) {
    EXPECT_FALSE(warns(dropped, "coarse_elements"));
    EXPECT_TRUE(warns(with(dropped, "cells = [8, 4]", "cells = [4, 2]"), "coarse_elements"));
}

/// Water on both sides sees through a surface thinner than its kernels.
TEST(ElasticScene, WarnsOfASurfaceThinnerThanAWallOfParticlesNeeds) {
    EXPECT_FALSE(warns(dropped, "few_particles"));
    EXPECT_TRUE(warns(with(dropped, "mass = \"5 kg\"", "mass = \"5 kg\"\nskin = \"60 mm\""), "few_particles"));
}

const std::string dam_break_on_wall = R"(title = "elastic wall behind a dam break"
[tank]
size = ["0.584 m", "5 mm", "0.3 m"]
[domain]
dimensions = 2
[[water_block]]
min = [0, 0, 0]
max = ["0.146 m", "5 mm", "0.292 m"]
[[body]]
name = "wall"
elastic = "plate"
plate = ["90 mm", "1 m"]
cells = [45, 1]
middle = ["0.292 m", 0, "35 mm"]
trim = "90 deg"
thickness = "12 mm"
youngs_modulus = "1 MPa"
poisson = 0.3
density = "2500 kg/m3"
clamped = ["x_max"]
margin = 0
skin = "12 mm"
[motion]
kind = "none"
[resolution]
near_hull = "2.5 mm"
[run]
duration = "0.6 s"
methods = ["sph"]
)";

/// A dam break got in under the end of a wall that stood on the floor, and was lost there at 0.50 s with c0 = 48 m/s; with
/// the wall four spacings into the floor it ran to its end, with the default of 24 m/s and with 48.
TEST(ElasticScene, WarnsOfAWallThatEndsOnTheFloor) {
    EXPECT_FALSE(warns(dam_break_on_wall, "ends_at_wall"));
    EXPECT_TRUE(warns(with(with(dam_break_on_wall, "90 mm", "80 mm"), "35 mm", "40 mm"), "ends_at_wall"));
}

/// What strikes a wall is thrown at the tank's far side: an impact. A wall that has held the water from the start, or one
/// that does not bend, keeps the default of all scenes.
TEST(ElasticScene, TakesTheSoundSpeedOfAnImpactWhereWaterStrikesADryPlate) {
    const double fall = std::sqrt(2 * 9.81 * 0.292);
    EXPECT_NEAR(scene_of(dam_break_on_wall).sph.c0, 40 * fall, 1e-9);
    EXPECT_NEAR(scene_of(with(dam_break_on_wall, "[\"0.292 m\", 0, \"35", "[\"0.152 m\", 0, \"35")).sph.c0, 10 * fall,
                1e-9);
    const std::size_t body = dam_break_on_wall.find("[[body]]"), motion = dam_break_on_wall.find("[motion]");
    const std::string rigid = dam_break_on_wall.substr(0, body) +
                              "[[obstacle]]\nname = \"wall\"\nmin = [0.286, -0.1, 0]\n" + "max = [0.298, 0.1, 0.08]\n" +
                              dam_break_on_wall.substr(motion);
    EXPECT_NEAR(scene_of(rigid).sph.c0, 10 * fall, 1e-9);
    const Scene own = scene_of(dam_break_on_wall + "[sph]\nc0 = 30\n");
    EXPECT_EQ(own.sph.c0, 30);
    EXPECT_NE(to_text(own, predict(own)).find("raise [sph] c0"), std::string::npos) << "or nobody is told";
}

/// The mesh method moves the rigid counterpart of a plate on a frame, and refuses a plate that is held.
TEST(ElasticScene, IsRigidForTheMeshMethod) {
    EXPECT_NO_THROW(refuse_unmeshable(scene_of(dropped)));
    const std::string held =
        with(with(dropped, "carried = [\"x_min\", \"x_max\", \"y_min\", \"y_max\"]\nmass = \"5 kg\"",
                  "clamped = [\"x_min\"]"),
             "velocity = [0, 0, \"-2 m/s\"]\n", "");
    EXPECT_THROW(mesh_motion(scene_of(held)), InputError);
}

TEST(TyreScene, StandsBlownUpWithItsLowestPointAtItsDraft) {
    const Scene scene = scene_of(with(tyre_scene, "cells", "drop_height = 0.3\ncells"));
    const MovingBody& b = scene.bodies.at(0);
    ASSERT_TRUE(b.tyre());
    EXPECT_NEAR(b.surface.bounds().min.z(), 0.004, 1e-12);
    EXPECT_GT(b.surface.bounds().size().z(), 0.2505) << "the pressure has not blown it up";
    EXPECT_NEAR(b.motion.velocity.z(), -std::sqrt(2 * 9.81 * 0.3), 1e-12);
    EXPECT_FALSE(b.motion.free.about[1]) << "a rim does not turn";
    EXPECT_THROW(mesh_motion(scene), InputError);
}

TEST(TyreScene, RefusesWhatIsNoTyre) {
    const struct {
        std::string from, to, message;
    } wrong[] = {
        {"mass = \"10 kg\"\n", "", "needs the mass of tyre, rim and load"},
        {"mass = \"10 kg\"", "mass = \"1 kg\"", "the rubber alone has"},
        {"draft = \"-4 mm\"\n", "", "depth of the tyre's lowest point"},
        {"cells", "tread = [-1e6, 1e6, 1e8]\ncells", "no rubber has these constants"},
        {"cells", "pressure = 2e7\ncells", "bursts the tyre"},
        {"cells", "tyre = [0.25, 0.24, 0.08]\ncells", "a tyre's rim is smaller"},
        {"cells", "locked = [\"roll\"]\ncells", "rim does not turn"},
        {"cells", "velocity = [0, 0, -1]\ndrop_height = 0.3\ncells", "keep one of the two"},
        {"position = [0", "direction = [1, 0, 0]\nposition = [0", "no strain gauges"},
        {"cells", "thickness = 0.01\ncells", "thickness"},
    };
    for (const auto& [from, to, message] : wrong) {
        const std::string found = complaint(with(tyre_scene, from, to));
        EXPECT_NE(found.find(message), std::string::npos) << to << ": '" << found << "'";
        EXPECT_EQ(found.find("scene.toml:"), 0u) << found;
    }
}

}  // namespace elastic_test
}  // namespace tw::test
