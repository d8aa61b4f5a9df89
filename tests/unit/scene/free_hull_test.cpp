#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "meshes/mass_properties.h"
#include "record/body_pose.h"
#include "record/hull_motion.h"
#include "scene/mesh/mesh_motion.h"
#include "scene/solids/hull_motion.h"
#include "scene_text.h"

namespace tw::test {
namespace free_hull_test {

const std::string keys = "free = [\"heave\", \"pitch\"]\nmass = 300\nlcg = 1.6\nvcg = 0.3\n";
const std::string free_planing = with(planing, "half     = true\n", "half     = true\n" + keys);

TEST(FreeHull, HasItsCentreAheadOfTheTransomAlongItsOwnAxisWhereItStands) {
    const Scene scene = scene_of(free_planing);
    const FreeHull& free = scene.hull->free.value();
    // the keel at the transom is the lowest point: 0.2 m below still water, at the hull's aftmost x but for the trim
    EXPECT_NEAR(free.transom_keel.z(), -0.2, 1e-9);
    const Vec3 arm = free.motion.mass.centre - free.transom_keel;
    EXPECT_NEAR(arm.x(), -1.6 * std::cos(5 * degree) + 0.3 * std::sin(5 * degree), 1e-9);
    EXPECT_NEAR(arm.z(), 1.6 * std::sin(5 * degree) + 0.3 * std::cos(5 * degree), 1e-9);
    EXPECT_EQ(free.motion.mass.mass, 300) << "of the whole hull, half model or not";
    EXPECT_NEAR(free.motion.mass.inertia(1, 1), 300 * 1 * 1, 1e-9) << "a quarter of its length is one metre";
    EXPECT_EQ(free.motion.release, scene.motion.ramp);
}

TEST(FreeHull, FloatsAtRestWhereItDisplacesItsMass) {
    const Scene scene = scene_of(free_planing);
    const FreeHull& free = scene.hull->free.value();
    ASSERT_TRUE(free.at_rest);
    Surface afloat = scene.hull->surface;
    const Eigen::AngleAxisd turn(free.at_rest->turn, Vec3::UnitY());
    const Vec3& centre = free.motion.mass.centre;
    for (Vec3& p : afloat.points) p = centre + turn * (p - centre) + Vec3(0, 0, free.at_rest->rise);
    const Hydrostatics at_rest = hydrostatics(afloat);
    EXPECT_NEAR(at_rest.volume, 0.3, 1e-6);
    EXPECT_NEAR(at_rest.centroid.x(), centre.x(), 1e-5);
}

TEST(FreeHull, IsOneSizeOfParticlesAndAMorphedMesh) {
    const Scene scene = scene_of(with(free_planing, "near_hull = \"0.05 m\"", "near_hull = 0.05\nspacing = 0.2"));
    EXPECT_EQ(scene.sph.levels, 1);
    EXPECT_EQ(mesh_motion(scene).kind, MeshMotion::Kind::morphing);
    const MeshMotion motion = mesh_motion(scene);
    EXPECT_GT(motion.stretch(), 0.2);
    EXPECT_NEAR(motion.follows_by(1), motion.inner, 1e-12);
    EXPECT_NEAR(motion.follows_by(0.5), (motion.inner + motion.outer) / 2, 1e-12);
    EXPECT_NEAR(motion.follows_by(0), motion.outer, 1e-12);
    EXPECT_EQ(mesh_motion(scene_of(planing)).kind, MeshMotion::Kind::none);
}

// Measured: 3.8 times the time of a step of a mesh at rest, a planing hull of 0.31 times its added mass, which comes to terms
// with the water three times in a step; twice that of a ship in waves, which does so once.
TEST(FreeHull, ThatIsLightTakesLongerThanAHeavyOne) {
    Scene light = scene_of(free_planing);
    light.run.duration = 1e5;  // beside which the start is nothing
    Scene heavy = light;
    heavy.hull->free->motion.mass.mass *= 10;
    EXPECT_EQ(predict(light).of("fvm").steps, predict(heavy).of("fvm").steps);
    EXPECT_NEAR(predict(light).of("fvm").seconds / predict(heavy).of("fvm").seconds, 4.0 / 3, 0.05);
}

TEST(FreeHull, GivesItsHeavesTimeToDieOut) {
    const std::string unsaid = with(free_planing, "duration = \"1.5 s\"\n", "");
    const Scene held = scene_of(with(unsaid, keys, "")), free = scene_of(unsaid);
    // 2 pi sqrt(2 m / (rho g L B))
    const double heave = 2 * std::numbers::pi * std::sqrt(2 * 300 / (1000 * 9.81 * held.hull->length * 1));
    EXPECT_NEAR(free.sampling.mean_from - held.sampling.mean_from, 2 * heave, 1e-9);
    EXPECT_NEAR(free.run.duration - free.sampling.mean_from, 3 * heave, 1e-9);
}

TEST(FreeHull, IsRefusedWithWhatIsMissingOrCannotBe) {
    const auto refused = [](const std::string& text, const std::string& key, const std::string& why) {
        const std::string message = complaint(text);
        EXPECT_NE(message.find(key), std::string::npos) << message;
        EXPECT_NE(message.find(why), std::string::npos) << message;
    };
    refused(with(free_planing, "mass = 300\n", ""), "[hull] mass", "needs the mass of the whole hull");
    refused(with(free_planing, "mass = 300", "mass = 0"), "[hull] mass = 0", "greater than 0");
    refused(with(free_planing, "lcg = 1.6\n", ""), "[hull] lcg", "missing");
    refused(with(free_planing, "free = [\"heave\", \"pitch\"]\n", ""), "[hull] mass", "for a hull that is free");
    refused(with(free_planing, "\"pitch\"]", "\"surge\"]"), "[hull] free", "pitch");
    refused(with(free_planing, "kind  = \"stream\"\nspeed = \"8 m/s\"", "kind = \"none\""), "[hull] free", "[[body]]");
    refused(free_planing + "[sph]\nscheme = \"rk4_frozen_diffusion\"\n", "[sph] scheme", "kick_drift_kick");
    refused(with(free_planing, keys, keys + "release = 2\n"), "[hull] release", "held to the end");
}

TEST(FreeHull, MassesThatCannotFloatAndCentresOutsideAreNoted) {
    const auto noted = [](const std::string& text, const std::string& name) {
        return std::ranges::count(scene_of(text).hull->findings, name, &Finding::name) == 1;
    };
    EXPECT_FALSE(noted(free_planing, "centre_outside"));
    EXPECT_TRUE(noted(with(free_planing, "vcg = 0.3", "vcg = 3"), "centre_outside"));
    EXPECT_FALSE(noted(free_planing, "does_not_float"));
    EXPECT_TRUE(noted(with(free_planing, "mass = 300", "mass = 30000"), "does_not_float"));
}

TEST(FreeHull, AMeshThatWouldTakeTheInletWithItIsRefused) {
    const Scene scene = scene_of(free_planing + "[fvm]\nbody_mesh = \"whole\"\n");
    try {
        refuse_unmeshable(scene);
        ADD_FAILURE() << "not refused";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("expected \"morphing\""), std::string::npos) << e.what();
    }
}

// The motion as append_hull_motion records it, and the hull that the record holds, give back what moved.
TEST(FreeHull, ItsRecordedMotionIsItsHeaveAndTrim) {
    Hull hull;
    hull.trim = 0.05;
    hull.free = FreeHull{};
    hull.free->motion.mass.centre = {1, 0, 0.5};
    RigidBody::State state;
    state.centre = {1, 0, 0.7};
    state.attitude = Eigen::AngleAxisd(0.1, Vec3::UnitY());
    RunRecord r;
    r.numbers["trim"] = hull.trim;
    r.bodies.push_back({hull_motion_table, {}, {1, 0, 0.5}});
    append_hull_motion(r.table(hull_motion_table), 0.2, hull, state, Vec3::Zero());
    const auto pose = body_pose(r, r.bodies[0], 0.2);
    ASSERT_TRUE(pose);
    const Vec3 bow(-1, 0, 0.5);
    EXPECT_LT(((*pose)(bow) - (state.centre + state.attitude * (bow - Vec3(1, 0, 0.5)))).norm(), 1e-12);
    EXPECT_GT((*pose)(bow).z(), 0.7) << "bow up";
}

}  // namespace free_hull_test
}  // namespace tw::test
