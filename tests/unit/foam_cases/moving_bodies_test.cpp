// Free hulls and bodies that move: the OpenFOAM files that move them and their mesh.
#include <gtest/gtest.h>

#include "case_text.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/files/times_of_table.h"
#include "foam_cases/release.h"
#include "scenes.h"

namespace tw {
namespace moving_bodies_test {

const Flavour v1912{};

/// The planing hull, free in heave and pitch.
Scene free_hull_scene() {
    Scene scene = planing_scene();
    FreeHull& free = scene.hull->free.emplace();
    free.motion.mass = {300, Vec3(2.4, 0, 0.2), 300 * Eigen::Matrix3d::Identity()};
    free.motion.free = {{false, false, true}, {false, true, false}};
    return scene;
}

TEST(CaseFiles, AFreeHullMovesItsMeshWithHalfItsMassAndLetsNoWaterThrough) {
    const Scene scene = free_hull_scene();
    const CasePlan plan = plan_case(scene, v1912);
    EXPECT_EQ(plan.bodies.at(0).patch, "hull");
    EXPECT_EQ(plan.solids.size(), 1u) << "the hull itself, no body beside it";
    EXPECT_EQ(plan.motion_table(plan.bodies[0]), "hull_motion");
    const std::vector<CaseFile> motion = mesh_motion_files(plan);
    ASSERT_EQ(motion.size(), 2u);
    EXPECT_SAYS(motion[0].text, "mass 150;");
    EXPECT_SAYS(motion[0].text, "momentOfInertia (150 150 150);");
    EXPECT_SAYS(motion[0].text, "sixDoFRigidBodyMotionConstraint line; direction (0 0 1);");
    EXPECT_SAYS(motion[0].text, "sixDoFRigidBodyMotionConstraint axis; axis (0 1 0);");
    EXPECT_SAYS(motion[1].text, "midPlane { type symmetryPlane; }");
    EXPECT_SAYS(velocity_field(plan), "hull { type movingWallVelocity;");  // slip would let it through
    CasePlan lets_go = plan;
    lets_go.wall_library = "libventilatedWall.so";
    EXPECT_SAYS(velocity_field(lets_go), "hull { type ventilatedWallVelocity;");
    lets_go.flavour = Flavour::from_version("openfoam.org", "12");
    EXPECT_SAYS(velocity_field(lets_go), "hull { type movingWallVelocity;") << "not tried there";
    EXPECT_SAYS(fv_schemes(plan), "linearUpwind");                         // as of a hull that is held
    EXPECT_SAYS(control_dict(plan), "bodyState");
    EXPECT_SILENT(control_dict(plan), "forces_hull");  // its forces are recorded as the hull's
    EXPECT_TRUE(mesh_motion_files(plan_case(planing_scene(), v1912)).empty());
}

TEST(CaseFiles, AFreeHullIsHeldUntilItsReleaseWhereTheInstallationHasTheLibraryForIt) {
    Scene scene = free_hull_scene();
    scene.water.gravity = 9.81;
    RigidBodySetup& motion = scene.hull->free->motion;
    motion.release = 0.25;
    OpenFoam openfoam;
    openfoam.vendor = "openfoam.com", openfoam.version = "v1912";
    openfoam.hold_library = "/some where/libheldBody.so";
    const CasePlan held = plan_case(scene, openfoam);
    EXPECT_SAYS(mesh_motion_files(held)[0].text, "solver { type heldNewmark; release 0.25; gamma 0.5; }");
    EXPECT_SAYS(mesh_motion_files(held)[0].text, "acceleration (0 0 0);");
    EXPECT_SAYS(control_dict(held), "libs (\"/some where/libheldBody.so\");");
    EXPECT_EQ(held.hull_release, "the hull is held until its release");

    const auto is_free = [](const CasePlan& plan, const std::string& why) {
        EXPECT_SAYS(mesh_motion_files(plan)[0].text, "solver { type Newmark; gamma 0.5; }");
        EXPECT_SAYS(mesh_motion_files(plan)[0].text, "acceleration (0 0 -9.81);");
        EXPECT_SILENT(control_dict(plan), "libheldBody");
        EXPECT_NE(plan.hull_release.find("free at once: " + why), std::string::npos) << plan.hull_release;
    };
    motion.release = 0;
    is_free(plan_case(scene, openfoam), "its release is the start");
    motion.release = 0.25;
    openfoam.hold_library.clear();
    is_free(plan_case(scene, openfoam), "this OpenFOAM lacks the library");
}

// Both bodies hang on joints of their own, with their share of the mass and their first motion, in the order of joints.
TEST(CaseFiles, SeveralBodiesAreJointsOfOneSystem) {
    Scene scene = dam_break_scene();
    scene.domain.box = {Vec3(0, 0, 0), Vec3(3, 0.01, 1)};
    scene.water_blocks.clear();
    for (const double x : {1.0, 2.0}) {
        MovingBody b;
        b.name = x < 1.5 ? "left" : "crate";
        const Box box{{x - 0.1, -0.05, 0.25}, {x + 0.1, 0.05, 0.35}};
        b.surface = make_hull("box", {{"length", 0.2}, {"beam", 0.1}, {"height", 0.1}});
        const Box own = b.surface.bounds();
        for (Vec3& p : b.surface.points) p += box.min - own.min;
        b.motion.mass = {8, Vec3(x, 0, 0.3), Eigen::Matrix3d(Vec3(0.1, 0.2, 0.3).asDiagonal())};
        b.motion.free = {{x < 1.5, false, true}, {false, true, false}};
        b.motion.velocity = {x < 1.5 ? 0.25 : 0.0, 0, -0.5 * x};
        scene.bodies.push_back(b);
    }
    scene.fvm.body_mesh = "morphing";
    const CasePlan plan = plan_case(scene, v1912);
    ASSERT_EQ(plan.bodies.size(), 2u);
    EXPECT_NE(plan.bodies[0].patch, "left") << "a side of the tank has that name";
    const std::string motion = mesh_motion_files(plan)[0].text;
    EXPECT_SAYS(motion, "motionSolver rigidBodyMotion;");
    EXPECT_SAYS(motion, "joints ( { type Px; } { type Pz; } { type Ry; } );");
    EXPECT_SAYS(motion, "joints ( { type Pz; } { type Ry; } );");
    EXPECT_SAYS(motion, "qDot (0.25 -0.5 0 -1 0);");
    EXPECT_SAYS(motion, "qDdot (0 -9.81 0 -9.81 0);");
    EXPECT_SAYS(motion, "patches (crate);");
    const std::string control = control_dict(plan);
    EXPECT_SAYS(control, "forces_crate");
    EXPECT_SILENT(control, "bodyState");
}

TEST(CaseFiles, ABodyInATankIsFreeAtOnce) {
    Scene scene = dam_break_scene();
    MovingBody& b = scene.bodies.emplace_back();
    b.name = "crate";
    b.surface = make_hull("box", {{"length", 0.05}, {"beam", 1}, {"height", 0.05}});
    for (Vec3& p : b.surface.points) p += Vec3(0.4, 0, 0.2);
    b.motion.mass = {1, Vec3(0.4, 0, 0.2), Eigen::Matrix3d::Identity()};
    b.motion.free = {{false, false, true}, {false, false, false}};
    b.motion.release = 0.05;
    OpenFoam openfoam;
    openfoam.vendor = "openfoam.com", openfoam.version = "v1912", openfoam.hold_library = "/lib/libheldBody.so";
    const CasePlan plan = plan_case(scene, openfoam);
    EXPECT_SAYS(mesh_motion_files(plan)[0].text, "type Newmark;");
    EXPECT_SILENT(control_dict(plan), "libheldBody");
    EXPECT_EQ(plan.hull_release, "");
}

// Steps that grow from the first on would lose a twelfth of the added mass.
TEST(CaseFiles, StepsOfABodyReleasedAtRestAreAFiftiethOfTheTimeSince) {
    Scene scene = dam_break_scene();
    scene.domain.box = {Vec3(-1, 0, -1), Vec3(1, 0.02, 1)};
    scene.water_blocks.clear();
    scene.run.duration = 2;
    MovingBody& b = scene.bodies.emplace_back();
    b.name = "box";
    b.surface = make_hull("box", {{"length", 0.2}, {"beam", 1}, {"height", 0.1}});
    for (Vec3& p : b.surface.points) p.z() -= 0.5 + b.surface.bounds().max.z();
    const double volume = mass_properties(b.surface).volume;
    b.motion.mass = {0.01 * 1000 * volume, Vec3(0, 0, -0.5), Eigen::Matrix3d::Identity()};
    b.motion.free = {{false, false, true}, {false, false, false}};
    const CasePlan plan = plan_case(scene, v1912);
    ASSERT_GT(plan.step_caps.size(), 2u);
    EXPECT_EQ(plan.first_step, plan.step_caps[0].step);
    EXPECT_NEAR(plan.first_step, std::sqrt(2 * plan.finest_cell / 9.81) / 50, 1e-9);
    for (std::size_t k = 1; k < plan.step_caps.size(); ++k)
        EXPECT_NEAR(plan.step_caps[k].step, plan.step_caps[k - 1].until / 50, 1e-12);
    EXPECT_LT(plan.step_caps.back().step, plan.largest_step);
    EXPECT_SAYS(control_dict(plan), "largestStep0");
    // So light a body rises with what the water that moves with it lets it, and damps what swings from step to step.
    const std::string motion = mesh_motion_files(plan)[0].text;
    EXPECT_SAYS(motion, "gamma 1;");
    EXPECT_GT(first_rise(plan.moving(), scene), 0.9 * 9.81 / 2);
    EXPECT_LT(first_rise(plan.moving(), scene), 9.81);
    EXPECT_LT(plan.relaxation, 0.03);

    scene.bodies[0].motion.velocity.z() = -5;
    EXPECT_TRUE(plan_case(scene, v1912).step_caps.empty()) << "its Courant number sets its steps";
    EXPECT_FALSE(released_in_air(plan_case(scene, v1912))) << "it is under water";
}

// In an empty tank a second and third corrector take 8 % of a wave's height on the way to a body (decision 032).
TEST(CaseFiles, ABodyInWavesAnswersOnceAStepBecauseMoreCorrectorsFlattenWaves) {
    Scene scene = dam_break_scene();
    scene.domain.box = {Vec3(-2, 0, -0.5), Vec3(2, 0.02, 0.5)};
    scene.water_blocks.clear();
    MovingBody& b = scene.bodies.emplace_back();
    b.name = "box";
    b.surface = make_hull("box", {{"length", 0.2}, {"beam", 1}, {"height", 0.1}});
    const double down = 0.05 + b.surface.bounds().min.z();
    for (Vec3& p : b.surface.points) p.z() -= down;
    b.motion.mass = {10, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    b.motion.free = {{false, false, true}, {false, false, false}};
    EXPECT_SAYS(fv_solution(plan_case(scene, v1912)), "nOuterCorrectors 3; nCorrectors 1;") << "still water";
    scene.wave.emplace();
    EXPECT_SAYS(fv_solution(plan_case(scene, v1912)), "nOuterCorrectors 1; nCorrectors 3;");
    b.motion.mass.mass = 5;
    EXPECT_SAYS(fv_solution(plan_case(scene, v1912)), "nOuterCorrectors 3; nCorrectors 1;") << "too light";
}

TEST(CaseFiles, AHullAtRestLetsWaterGoBySpeedsThatLastWhereStepsAreShort) {
    Scene scene = planing_scene();
    const auto velocity = [&](double courant, const char* library) {
        scene.fvm.max_courant = scene.fvm.max_alpha_courant = courant;
        CasePlan plan = plan_case(scene, v1912);
        plan.wall_library = library;
        return velocity_field(plan);
    };
    EXPECT_SAYS(velocity(0.15, "libventilatedWall.so"), "hull { type ventilatedSlip;");
    EXPECT_SAYS(velocity(4, "libventilatedWall.so"), "hull { type slip;");
    EXPECT_SAYS(velocity(0.15, ""), "hull { type slip;");
}

// Cells of fixed places are sought again whenever the mesh has moved, for twice the time of the rest of a step.
TEST(CaseFiles, GaugesBeyondTheMorphedCellsKeepTheCellsThatTheyHave) {
    Scene scene = dam_break_scene();
    scene.domain.box = {Vec3(-2, 0, -0.5), Vec3(2, 0.02, 0.5)};
    scene.water_blocks.clear();
    MovingBody& b = scene.bodies.emplace_back();
    b.name = "box";
    b.surface = make_hull("box", {{"length", 0.2}, {"beam", 1}, {"height", 0.1}});
    const double down = 0.05 + b.surface.bounds().min.z();
    for (Vec3& p : b.surface.points) p.z() -= down;
    b.motion.mass = {10, Vec3::Zero(), Eigen::Matrix3d::Identity()};
    b.motion.free = {{false, false, true}, {false, false, false}};
    scene.fvm.body_mesh = "morphing";
    const auto at = [&](double x) {
        scene.sampling.height = {{.name = "gauge", .x = x, .y = 0.01}};
        const std::string control = control_dict(plan_case(scene, v1912));
        return control.substr(control.find("heightColumns"));
    };
    const double edge = b.surface.bounds().max.x() + plan_case(scene, v1912).mesh_motion.follows_by(0.02);
    EXPECT_SAYS(at(edge + 0.05), "fixedLocations no;");
    EXPECT_SAYS(at(edge - 0.05), "fixedLocations yes;") << "its cells move";
    scene.fvm.body_mesh = "whole";
    EXPECT_SAYS(at(1.5), "fixedLocations yes;") << "all cells move";
    scene.bodies.clear();
    EXPECT_SAYS(at(1.5), "fixedLocations yes;") << "none moves";
}

// Its first steps are run to find the speed with which it has to be released (run/first_steps.h).
TEST(CaseFiles, ABodyThatComesThroughTheAirIsReleasedFaster) {
    Scene scene = dam_break_scene();
    scene.domain.box = {Vec3(-1, 0, -1), Vec3(1, 0.02, 1)};
    scene.water_blocks.clear();
    MovingBody& b = scene.bodies.emplace_back();
    b.name = "box";
    b.surface = make_hull("box", {{"length", 0.2}, {"beam", 1}, {"height", 0.1}});
    const auto lies = [&](double above) {
        for (Vec3& p : b.surface.points) p.z() += above - b.surface.bounds().min.z();
        b.motion.mass = {10, Vec3(0, 0, above + 0.05), Eigen::Matrix3d::Identity()};
        return plan_case(scene, v1912);
    };
    b.motion.free = {{false, false, true}, {false, false, false}};
    b.motion.velocity.z() = -5;
    CasePlan plan = lies(0.1);
    EXPECT_TRUE(released_in_air(plan));
    EXPECT_FALSE(released_in_air(lies(0.5 * plan.finest_cell))) << "the water's force in its first steps is real";
    plan.release_factor = 1.04;
    EXPECT_SAYS(mesh_motion_files(plan)[0].text, "velocity (0 0 -5.2);");
    b.motion.velocity.z() = 0;
    EXPECT_FALSE(released_in_air(lies(0.1))) << "it falls from rest";
}

// A sphere driven in for 10 ms took a last step to 10.4 ms, beyond a table that ended at 10.1 ms.
TEST(CaseFiles, ATableOfMotionReachesAsFarAsTheLastStepMayLead) {
    MotionLaw law;
    law.kind = MotionLaw::Kind::constant;
    for (const double step : {1e-4, 22e-3}) {
        const std::vector<double> times = times_of_table(law, 10e-3, step);
        EXPECT_LT(times.front(), 0);
        EXPECT_GE(times.back(), 10e-3 + step);
        EXPECT_LT(times.back(), 10e-3 + step + 3e-4);
    }
}

}  // namespace moving_bodies_test
}  // namespace tw
