// What follows from a scene, and the OpenFOAM files that say it.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/errors.h"
#include "base/numbers.h"
#include "case_text.h"
#include "foam_cases/axis_cells.h"
#include "foam_cases/files/case_files.h"
#include "scenes.h"

namespace tw {
namespace case_files_test {

const Flavour v1912{};

void set_effect(Scene& scene, const std::string& name, bool on) {
    EffectChoice choice;
    choice.name = name;
    choice.on = on;
    scene.effects.push_back(choice);
}

TEST(SplitAxis, PutsWantedPlanesOnCellFacesWhereCellsStayNearlyCubes) {
    const AxisCells a = split_axis(-3, 2, 1.0 / 3, {0});
    EXPECT_EQ(a.planes, (std::vector<double>{-3, 0, 2}));
    EXPECT_EQ(a.cells, (std::vector<int>{9, 6}));
    // 0.1 spacings from the end: no room for a cell, the plane is left out.
    EXPECT_EQ(split_axis(0, 1, 0.1, {0.99}).planes, (std::vector<double>{0, 1}));
    // A tank of Koshizuka & Oka's column: every cell within a quarter of the spacing.
    const AxisCells tank = split_axis(0, 0.584, 0.0146, {0.146, 0.146});
    EXPECT_EQ(tank.cells, (std::vector<int>{10, 30}));
}

TEST(CasePlan, StillWaterIsACellFaceAndTheStreamIsOpen) {
    const Scene scene = planing_scene();
    const CasePlan plan = plan_case(scene, v1912);
    EXPECT_EQ(std::count(plan.axes[2].planes.begin(), plan.axes[2].planes.end(), 0.0), 1);
    EXPECT_EQ(plan.sides[0].name, "inlet");
    EXPECT_EQ(plan.sides[1].name, "outlet");
    EXPECT_EQ(plan.sides[2].name, "midPlane");
    EXPECT_EQ(plan.sides[5].name, "atmosphere");
    EXPECT_EQ(plan.wet_level, 3);
    EXPECT_EQ(plan.surface_level, 1) << "the wet box reaches the finest level: dry topsides may be coarser";
    EXPECT_NEAR(plan.finest_cell, 1.0 / 24, 1e-12);
    // 40 pressure samples per hull length of travel, and the frames' interval a multiple of theirs.
    EXPECT_LE(plan.write_interval, 4.0 / 8 / 40 + 1e-12);
    EXPECT_NEAR(plan.write_interval * plan.raster_every, scene.sampling.interval, 1e-15);
}

TEST(CasePlan, WithoutAWetBoxTheWholeHullIsFine) {
    Scene scene = planing_scene();
    scene.refinement.pop_back();
    EXPECT_EQ(plan_case(scene, v1912).surface_level, 3);
}

TEST(CaseFiles, SnappingIsNotGivenUpAtSharpEdges) {
    const Scene scene = planing_scene();
    const std::string mesh = snappy_hex_mesh_dict(plan_case(scene, v1912));
    for (const char* limit : {"minTetQuality -1e+30;", "minTwist -1;", "maxConcave 180;", "nSmoothPatch 0;"})
        EXPECT_SAYS(mesh, limit) << "cuts off keels and transoms: decision 028";
    EXPECT_SAYS(mesh, "minVol 1e-13;") << "cells stay cells";
    const Scene flat = flat_plate_scene();
    EXPECT_SAYS(snappy_hex_mesh_dict(plan_case(flat, v1912)), "nSmoothPatch 3;");
}

TEST(CaseFiles, CellsAreHalvedOnceMoreAlongTheEdgesThatTheStreamLeaves) {
    const Scene scene = planing_scene();
    const CasePlan plan = plan_case(scene, v1912);
    ASSERT_EQ(plan.ribbon, "shedding_edges");
    for (const SheddingEdge& e : plan.shedding.edges) {
        EXPECT_GE(std::min(e.from.y(), e.to.y()), 0) << "half a model";
        EXPECT_LE(std::max(e.from.z(), e.to.z()), 0.1 + 1e-12) << "above half the draft the chine is dry";
    }
    EXPECT_SAYS(snappy_hex_mesh_dict(plan), "shedding_edges { mode distance; levels ((0.041666666666666664 4)); }");
    EXPECT_EQ(plan.wet_level, 3);
    EXPECT_NEAR(plan.finest_cell, 1.0 / 24, 1e-12) << "probes and the largest step follow the cells at the hull";

    Scene smooth = planing_scene();
    smooth.hull->surface = posed(make_hull("sphere", {{"diameter", 1}, {"level", 4}}), {.draft = 0.2});
    EXPECT_SILENT(snappy_hex_mesh_dict(plan_case(smooth, v1912)), "shedding_edges");
    const Scene flat = flat_plate_scene();
    EXPECT_SILENT(snappy_hex_mesh_dict(plan_case(flat, v1912)), "shedding_edges");
    Scene named = planing_scene();
    named.refinement[0].name = "shedding_edges";
    EXPECT_EQ(plan_case(named, v1912).ribbon, "shedding_edges_");
}

TEST(CasePlan, ThePointInTheFluidIsOutsideEverySolid) {
    Scene scene = planing_scene();
    // An obstacle that fills the corner where the point would lie.
    const Vec3 low = scene.domain.box.min - Vec3(1, 1, 1);
    Surface box = make_hull("box", {{"length", 4}, {"beam", 2}, {"height", 2}});
    const Box b = box.bounds();
    for (Vec3& p : box.points) p += low - b.min;
    scene.obstacles.push_back({"corner", box});
    const CasePlan plan = plan_case(scene, v1912);
    EXPECT_FALSE(box.bounds().contains(plan.point_in_fluid));
    EXPECT_TRUE(scene.domain.box.contains(plan.point_in_fluid));
    // A solid that fills everything leaves no place: a message, not a mesh of nothing.
    Surface whole = make_hull("box", {{"length", 40}, {"beam", 40}, {"height", 40}});
    for (Vec3& p : whole.points) p.z() -= 20;
    scene.obstacles = {{"everything", whole}};
    EXPECT_THROW(plan_case(scene, v1912), InputError);
}

TEST(CaseFiles, TheInviscidTwinSlipsAndTheViscousOneHasWallFunctions) {
    Scene scene = planing_scene();
    const CasePlan slippery = plan_case(scene, v1912);
    EXPECT_SAYS(turbulence_file(slippery), "simulationType laminar;");
    EXPECT_SAYS(velocity_field(slippery), "hull { type slip; }");
    EXPECT_TRUE(turbulence_fields(slippery).empty());

    set_effect(scene, "viscosity", true);
    set_effect(scene, "no_slip", true);
    const CasePlan laminar = plan_case(scene, v1912);
    EXPECT_SAYS(turbulence_file(laminar), "simulationType laminar;");
    EXPECT_SAYS(velocity_field(laminar), "hull { type noSlip; }");

    set_effect(scene, "turbulence", true);
    const CasePlan viscous = plan_case(scene, v1912);
    EXPECT_SAYS(turbulence_file(viscous), "RASModel kOmegaSST;");
    EXPECT_SAYS(velocity_field(viscous), "hull { type noSlip; }");
    ASSERT_EQ(turbulence_fields(viscous).size(), 3u);
    EXPECT_SAYS(turbulence_fields(viscous)[2].text, "nutUSpaldingWallFunction");
    EXPECT_SAYS(control_dict(viscous), "wallShearStress");
}

// docs/decisions/015-interfoam-settings.md: what was measured of a held hull's load says nothing of a splash.
TEST(CaseFiles, OnlyAHullHeldInAStreamIsSolvedWithSettingsThatCostLess) {
    const Scene held = planing_scene();
    const CasePlan plan = plan_case(held, v1912);
    EXPECT_SAYS(control_dict(plan), "writeControl runTime;");
    EXPECT_SAYS(fv_solution(plan), "tolerance 1e-07; relTol 0.05; } p_rghFinal");
    EXPECT_SAYS(fv_solution(plan), "tolerance 1e-07; relTol 0.01; } \"(U|k|omega).*\"");
    EXPECT_SAYS(fv_solution(plan), "nLimiterIter 3;");
    Scene free = held, geometric = held, waiting = held, under = held;
    free.hull->free.emplace().motion.mass = {300, Vec3(2.4, 0, 0.2), 300 * Eigen::Matrix3d::Identity()};
    free.hull->free->motion.free = {{false, false, true}, {false, true, false}};
    geometric.fvm.interface = "isoadvector";
    waiting.motion.kind = Motion::Kind::none;
    for (Vec3& p : under.hull->surface.points) p.z() -= 2;
    for (const Scene& other : {free, geometric, waiting, under, flat_plate_scene(), dam_break_scene()}) {
        const CasePlan tight = plan_case(other, v1912);
        EXPECT_SAYS(fv_solution(tight), "tolerance 1e-07; relTol 0.01; } p_rghFinal");
        EXPECT_SAYS(fv_solution(tight), "tolerance 1e-07; relTol 0.001; } \"(U|k|omega).*\"");
        EXPECT_SAYS(fv_solution(tight), "nLimiterIter 8;");
        const bool stream = other.motion.kind == Motion::Kind::stream;
        EXPECT_SAYS(control_dict(tight), stream ? "writeControl adjustableRunTime;" : "writeControl runTime;");
    }
}

TEST(CaseFiles, SolidsLetWaterGoWhereTheInstallationHasTheLibraryForIt) {
    Scene scene = planing_scene();
    OpenFoam openfoam;
    openfoam.vendor = "openfoam.com", openfoam.version = "v1912";
    openfoam.wall_library = "/some where/libventilatedWall.so";
    set_effect(scene, "ventilation", true);
    const CasePlan plan = plan_case(scene, openfoam);
    EXPECT_SAYS(control_dict(plan), "libs (\"/some where/libventilatedWall.so\");");
    EXPECT_SAYS(p_rgh(plan), "hull { type ventilatedWallPressure;");
    EXPECT_SAYS(p_rgh(plan), "inlet { type fixedFluxPressure;") << "the domain's own sides are as they were";
    EXPECT_SAYS(alpha_water(plan), "hull { type ventilatedWallFraction;");
    EXPECT_EQ(plan.walls, "allow separation at ambient pressure where air can reach them");

    const auto holds = [&](const CasePlan& held, const char* why) {
        EXPECT_SILENT(control_dict(held), "libventilatedWall");
        EXPECT_SAYS(p_rgh(held), "hull { type fixedFluxPressure;");
        EXPECT_SAYS(alpha_water(held), "hull { type zeroGradient;");
        EXPECT_NE(held.walls.find(why), std::string::npos) << held.walls;
    };
    scene.effects.back().on = false;
    holds(plan_case(scene, openfoam), "ventilation is off");
    scene.effects.back().on = true;
    scene.domain.z_max = Side::slip_wall;
    holds(plan_case(scene, openfoam), "closed");
    scene.domain.z_max = Side::atmosphere;
    openfoam.wall_library.clear();
    holds(plan_case(scene, openfoam), "lacks the library");
}

// snappyHexMesh took 31 s for 19 thousand cells between `empty` sides, and takes 2.4 s between planes of symmetry.
TEST(CaseFiles, AFlatObstacleIsCutOutOfASlabBetweenPlanesOfSymmetry) {
    Scene scene = dam_break_scene();
    const Box& box = scene.domain.box;
    scene.obstacles.push_back({"sill", box_surface({Vec3(0.3, box.min.y(), 0), Vec3(0.34, box.max.y(), 0.05)})});
    const CasePlan plan = plan_case(scene, v1912);
    const std::string slab = block_mesh_dict(plan);
    EXPECT_SAYS(slab, "frontOfSlab { type symmetryPlane;");
    EXPECT_SILENT(slab, "empty");
    EXPECT_SAYS(create_patch_dict(plan), "type empty;");
    EXPECT_EQ(plan.finest_cell, plan.background_cell) << "cells of one size, as before";
    const Box solid = plan.solids.at(0).surface.bounds();
    EXPECT_LT(solid.min.y(), box.min.y() - 0.5 * box.size().y());
    EXPECT_GT(solid.max.y(), box.max.y() + 0.5 * box.size().y());
    EXPECT_EQ(solid.min.x(), 0.3) << "its section stays";
    EXPECT_EQ(solid.max.z(), 0.05);
    scene.domain.dimensions = 3;
    EXPECT_EQ(plan_case(scene, v1912).solids.at(0).surface.bounds().max.y(), box.max.y());
    scene.domain.dimensions = 2;
    scene.obstacles.clear();
    EXPECT_SAYS(block_mesh_dict(plan_case(scene, v1912)), "front { type empty;") << "blockMesh alone makes its mesh";
}

// Where nothing falls, the walls of a tank and its surface's tension say how fast water may be.
TEST(CaseFiles, TheWatchdogsSpeedComesFromWhatMovesTheWater) {
    Scene scene = dam_break_scene();
    const double falling = plan_case(scene, v1912).water_speed_limit;
    EXPECT_NEAR(falling, 10 * (1 + std::sqrt(2)) * std::sqrt(9.81 * 0.4), 1e-9);
    scene.tank_motion.emplace().law = {.axis = Vec3::UnitX(), .rate = 2};
    EXPECT_NEAR(plan_case(scene, v1912).water_speed_limit, falling + 20, 1e-9);
    scene.water.gravity = 0;
    EXPECT_NEAR(plan_case(scene, v1912).water_speed_limit, 20, 1e-9);
    scene.tank_motion.reset();
    EXPECT_EQ(plan_case(scene, v1912).water_speed_limit, HUGE_VAL);
    EffectChoice& tension = scene.effects.emplace_back();
    tension.name = "surface_tension", tension.on = true;
    EXPECT_NEAR(plan_case(scene, v1912).water_speed_limit, 10 * std::sqrt(pi * 0.072 / (1000 * 0.0146)), 1e-9);
}

TEST(CaseFiles, ATanksWallsHoldTheWaterWhereItSticksAndAStreamsSidesNeverDo) {
    Scene tank = dam_break_scene();
    EXPECT_SAYS(velocity_field(plan_case(tank, v1912)), "bottom { type symmetryPlane; }");
    set_effect(tank, "viscosity", true);
    set_effect(tank, "no_slip", true);
    set_effect(tank, "turbulence", true);
    const CasePlan plan = plan_case(tank, v1912);
    EXPECT_SAYS(block_mesh_dict(plan), "bottom { type wall;");
    EXPECT_SAYS(block_mesh_dict(plan), "right { type wall;");
    EXPECT_SAYS(block_mesh_dict(plan), "front { type empty;");
    EXPECT_SAYS(velocity_field(plan), "bottom { type noSlip; }");
    EXPECT_SAYS(turbulence_fields(plan)[2].text, "left { type nutUSpaldingWallFunction;");
    EXPECT_SAYS(to_text(tank, {}), "x: no-slip wall, no-slip wall;");

    Scene stream = planing_scene();
    set_effect(stream, "viscosity", true);
    set_effect(stream, "no_slip", true);
    EXPECT_SAYS(velocity_field(plan_case(stream, v1912)), "bottom { type symmetryPlane; }");
}

TEST(CaseFiles, TheOutletsSpeedStandsUnderBothOfItsNames) {
    const Scene scene = planing_scene();
    const std::string u = velocity_field(plan_case(scene, v1912));
    EXPECT_SAYS(u, "Umean 8; UnMean 8;");
    EXPECT_SAYS(u, "tangentialVelocity uniform (8 0 0);");
}

TEST(CaseFiles, AFlatTankIsOneCellThickAndEmptySided) {
    const Scene scene = dam_break_scene();
    const CasePlan plan = plan_case(scene, v1912);
    EXPECT_FALSE(plan.snappy);
    const std::string mesh = block_mesh_dict(plan);
    EXPECT_SAYS(mesh, "front { type empty;");
    EXPECT_SAYS(mesh, "back { type empty;");
    EXPECT_SAYS(mesh, "left { type symmetryPlane;");
    EXPECT_SAYS(mesh, "(10 1 20) simpleGrading");  // the column's own block
    EXPECT_SAYS(set_fields_dict(plan), "volScalarFieldValue alpha.water 1");
    EXPECT_SILENT(set_fields_dict(plan), "boxToFace");
    // Blocks reach beyond the domain's sides, so that rounding leaves no cell out.
    EXPECT_SAYS(set_fields_dict(plan), "box (-0.584 -0.01 -0.4) (0.146 0.02 0.292);");
}

// A block that ends 5 mm below the surface of another takes no plane of cells from that surface: the water would stand
// at the inner block's top.
TEST(CaseFiles, BlocksOfOneWaterAreFilledToItsLevel) {
    Scene scene = dam_break_scene();
    const std::string alone = block_mesh_dict(plan_case(scene, v1912));
    scene.water_blocks = {{Vec3(0, 0, 0), Vec3(0.146, 0.01, 0.287)}, {Vec3(0, 0, 0.1), Vec3(0.146, 0.01, 0.292)}};
    const CasePlan plan = plan_case(scene, v1912);
    EXPECT_EQ(block_mesh_dict(plan), alone);
    EXPECT_SAYS(set_fields_dict(plan), "box (-0.584 -0.01 -0.4) (0.146 0.02 0.292);");
}

TEST(CaseFiles, AFlatHullIsRefinedInASlabOfWhichOneLayerIsDrawnOut) {
    const Scene scene = flat_plate_scene();
    const CasePlan plan = plan_case(scene, v1912);
    EXPECT_NEAR(plan.finest_cell, 0.025, 1e-15) << "two halvings at the hull";
    const Box solid = plan.solids.at(0).surface.bounds(), domain = scene.domain.box;
    EXPECT_GT(solid.size().y(), 100 * domain.size().y()) << "its ends are far from the slab";
    const std::string mesh = block_mesh_dict(plan), layer = extrude_mesh_dict(plan), patches = create_patch_dict(plan);
    EXPECT_SAYS(mesh, "midPlaneOfSlab { type symmetryPlane;");
    EXPECT_SILENT(mesh, "empty");
    EXPECT_SAYS(snappy_hex_mesh_dict(plan), "level (2 2);");
    EXPECT_SAYS(layer, "sourcePatches (midPlaneOfSlab); exposedPatchName midPlaneYOfSlab;");
    EXPECT_SAYS(layer, "sourceCase \"$FOAM_CASE\";");
    EXPECT_SAYS(layer, "thickness 0.1;");
    EXPECT_SAYS(patches, "name midPlane; patchInfo { type empty; } constructFrom patches; patches (midPlaneOfSlab);");
    EXPECT_SAYS(velocity_field(plan), "midPlane { type empty; }");
    EXPECT_SAYS(allrun_script(plan, 1), "extrudeMesh > log.extrudeMesh");
    const Scene tank = dam_break_scene();
    EXPECT_SILENT(allrun_script(plan_case(tank, v1912), 1), "extrudeMesh");
}

TEST(CaseFiles, BlockFacesCoverEverySideOnce) {
    const Scene scene = dam_break_scene();
    const CasePlan plan = plan_case(scene, v1912);
    std::size_t faces = 0, expected = 0;
    const std::string mesh = block_mesh_dict(plan);
    const std::string boundary = mesh.substr(mesh.find("boundary"));
    for (std::size_t at = boundary.find("faces"); at != std::string::npos; at = boundary.find("faces", at + 1)) {
        const std::string list = boundary.substr(at, boundary.find(';', at) - at);
        faces += static_cast<std::size_t>(std::count(list.begin(), list.end(), '(')) - 1;
    }
    for (std::size_t a = 0; a < 3; ++a)
        expected += 2 * plan.axes[(a + 1) % 3].cells.size() * plan.axes[(a + 2) % 3].cells.size();
    EXPECT_EQ(faces, expected);
}

TEST(CaseFiles, SurfaceTensionIsThereOnlyWhenTheEffectIsOn) {
    Scene scene = dam_break_scene();
    EXPECT_SAYS(phase_files(plan_case(scene, v1912))[0].text, "sigma 0;");
    set_effect(scene, "surface_tension", true);
    EXPECT_SAYS(phase_files(plan_case(scene, v1912))[0].text, "sigma 0.072;");
}

TEST(CaseFiles, NamesFromTheSceneStayNames) {
    Scene scene = planing_scene();
    scene.title = "evil\n$(touch x) \"; } #calc <script>";
    scene.refinement[0].name = "wake; } #calc \"1\"";
    scene.refinement[1].name = "hull";  // taken by the hull itself
    Surface box = make_hull("box", {{"length", 0.2}, {"beam", 0.2}, {"height", 0.2}});
    for (Vec3& p : box.points) p += Vec3(3, 1.5, -1);
    scene.obstacles = {{"inlet", box}, {"$(rm -rf /); }", box}};
    scene.sampling.pressure = {{"#calc \"system(x)\"", Vec3(3, 1, -1)}};
    const CasePlan plan = plan_case(scene, v1912);
    for (const CaseFile& f : case_files(plan, 2)) {
        if (f.path == "README" || f.path == "Allrun") continue;
        for (const char* word : {"#", "$", "touch", "calc ", "script", "rm -rf", "system(", "`", "\\"})
            EXPECT_EQ(f.text.find(word), std::string::npos) << f.path << " holds " << word;
        EXPECT_EQ(std::count(f.text.begin(), f.text.end(), '{'), std::count(f.text.begin(), f.text.end(), '}'))
            << f.path;
    }
    // The script of the case knows nothing of the scene's texts; the read-me shows the title on one line.
    EXPECT_EQ(allrun_script(plan, 2).find("touch"), std::string::npos);
    EXPECT_EQ(case_readme(plan).find("evil $(touch x)"), 0u);
    EXPECT_EQ(plan.solids[1].name, "inlet_") << "a patch of that name is there already";
    EXPECT_EQ(plan.boxes[1].name, "hull_");
}

TEST(CaseFiles, TheSameSceneGivesTheSameBytes) {
    const Scene a = planing_scene(), b = planing_scene();
    const auto files_a = case_files(plan_case(a, v1912), 2), files_b = case_files(plan_case(b, v1912), 2);
    ASSERT_EQ(files_a.size(), files_b.size());
    for (std::size_t i = 0; i < files_a.size(); ++i) EXPECT_EQ(files_a[i].text, files_b[i].text) << files_a[i].path;
}

TEST(CaseFiles, RanksAreAProductAndNeverCutTheWaterFromTheAir) {
    const Scene scene = planing_scene();
    const CasePlan plan = plan_case(scene, v1912);
    for (const auto& [ranks, n] :
         {std::pair{2, "(2 1 1)"}, {4, "(2 2 1)"}, {6, "(3 2 1)"}, {7, "(7 1 1)"}, {16, "(4 4 1)"}})
        EXPECT_SAYS(decompose_par_dict(plan, ranks), std::string("n ") + n);
}

TEST(Flavour, OpenFoamOrgGetsItsOwnKeywords) {
    const Scene scene = planing_scene();
    const CasePlan com = plan_case(scene, Flavour::from_version("openfoam.com", "v2312"));
    const CasePlan org10 = plan_case(scene, Flavour::from_version("openfoam.org", "10"));
    const CasePlan org11 = plan_case(scene, Flavour::from_version("openfoam.org", "11"));
    EXPECT_EQ(com.flavour.number, 2312);
    EXPECT_SAYS(fv_schemes(com), "div(phirb,alpha) Gauss linear;");
    EXPECT_SAYS(fv_schemes(org10), "Gauss interfaceCompression vanLeer 2;");
    EXPECT_SILENT(fv_solution(org10), "cAlpha");
    EXPECT_SAYS(fv_solution(com), "cAlpha 2;");
    EXPECT_EQ(com.flavour.solver_program(), "interFoam");
    EXPECT_EQ(org11.flavour.solver_program(), "foamRun");
    EXPECT_EQ(phase_files(org10).size(), 3u);
    EXPECT_EQ(phase_files(com).size(), 1u);
    EXPECT_EQ(surface_features_dict(org10).find("surfaceFeaturesDict") != std::string::npos, true);
    EXPECT_SAYS(control_dict(org10), "\"libforces.so\"");
    EXPECT_SAYS(control_dict(org11), "solver incompressibleVoF;");
}

TEST(CaseFiles, AGeometricSurfaceIsInterIsoFoamsOnAMeshAtRest) {
    Scene scene = planing_scene();
    const CasePlan limited = plan_case(scene, v1912);
    EXPECT_SAYS(control_dict(limited), "application interFoam;");
    EXPECT_SILENT(fv_solution(limited), "isoFaceTol");
    scene.fvm.interface = "isoadvector";
    const CasePlan geometric = plan_case(scene, v1912);
    EXPECT_SAYS(control_dict(geometric), "application interIsoFoam;");
    EXPECT_SAYS(fv_solution(geometric), "reconstructionScheme isoAlpha;");
    EXPECT_SAYS(fv_solution(geometric), "nAlphaSubCycles 4;");
}

TEST(CasePlan, RefusesASceneWithoutSizes) {
    Scene scene = dam_break_scene();
    scene.resolution.near_hull = 0;
    EXPECT_THROW(plan_case(scene, v1912), InputError);
}

}  // namespace case_files_test
}  // namespace tw
