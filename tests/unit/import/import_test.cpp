#include <fmt/format.h>

#include <cmath>

#include "compare/grid_study/grid_study.h"
#include "compare/metrics/splash.h"
#include "import_folder.h"
#include "record/raster_grid.h"
#include "record/run_record.h"
#include "scene/new_record.h"

namespace tw {
namespace import_test {

const std::vector<double>& series(const RunRecord& r, const std::string& table, const std::string& column) {
    const Column* c = r.series(table, column);
    if (!c) throw std::runtime_error("no " + table + "." + column);
    return c->values;
}

TEST_F(ImportTest, CsvColumnsBecomeSiByUnitScaleAndOffset) {
    write("data/forces.csv", "t;Drag;Lift [kN];H;P;Lw\n0;0.25;2.7;12;1.5;230\n500;0.26;;-3;1.6;231\n");
    const RunRecord r = imported("csv", "data/forces.csv", R"(
[time]
column = "t"
unit = "ms"
offset = "0.1 s"
[forces]
fx = { column = "Drag", unit = "kN", scale = -2, uncertainty = "15 N" }
fz = "Lift [kN]"
[height]
gauge = { column = 4, unit = "mm", offset = "0.5 m" }
[pressure]
keel = { column = "P", unit = "kPa" }
[samples]
wetted_length = { column = "Lw", unit = "cm" }
)");
    for (const char* table : {"forces", "height", "pressure", "samples"})
        EXPECT_EQ(r.tables.at(table).time, (std::vector<double>{0.1, 0.6})) << table;
    EXPECT_EQ(series(r, "forces", "fx"), (std::vector<double>{-500, -520}));
    EXPECT_EQ(series(r, "forces", "fz")[0], 2700);
    EXPECT_TRUE(std::isnan(series(r, "forces", "fz")[1]));
    EXPECT_DOUBLE_EQ(series(r, "height", "gauge")[0], 0.512);
    EXPECT_DOUBLE_EQ(series(r, "height", "gauge")[1], 0.497);
    EXPECT_EQ(series(r, "pressure", "keel")[1], 1600);
    EXPECT_DOUBLE_EQ(series(r, "samples", "wetted_length")[1], 2.31);
    EXPECT_EQ(r.numbers.at("uncertainty:forces:fx"), 15);
    EXPECT_FALSE(r.numbers.contains("uncertainty:forces:fz"));
    EXPECT_EQ(r.series("forces", "fx")->unit, "N");
    EXPECT_EQ(r.series("height", "gauge")->unit, "m");
    EXPECT_EQ(r.attributes.at("friction"), "included");  // a measured drag
}

TEST_F(ImportTest, TheSceneIsTheQuestionAndNothingOfASolverIsClaimed) {
    write("f.csv", "t [s],F [N]\n0,1\n1,2\n");
    const RunRecord r = imported("csv", "f.csv", "time = 1\n[forces]\nfz = 2\n");
    const RunRecord scene = new_record(read_scene(folder / "scene.toml"), "sph");
    for (const char* same : {"scene_hash", "hull_hash", "title", "moment_reference", "motion"})
        EXPECT_EQ(r.attributes.at(same), scene.attributes.at(same)) << same;
    for (const char* same : {"speed", "draft", "length", "trim", "duration", "mean_from", "domain_x_max", "gravity"})
        EXPECT_EQ(r.numbers.at(same), scene.numbers.at(same)) << same;
    for (const char* none : {"spacing", "near_hull", "h_over_dp", "c0", "ramp"}) EXPECT_FALSE(r.numbers.contains(none));
    for (const char* none : {"machine", "isa", "compiler", "run_hash", "started"})
        EXPECT_FALSE(r.attributes.contains(none)) << none;
    EXPECT_EQ(r.hull.triangles.size(), scene.hull.triangles.size());
    EXPECT_TRUE(r.frames.empty() && r.hull_pressure.empty() && r.hull_wet.empty() && r.effects.empty() &&
                r.phases.empty());
    EXPECT_FALSE(scene.effects.empty());  // or this test sees nothing
    EXPECT_EQ(r.attributes.at("method"), "towing tank");
    EXPECT_EQ(r.attributes.at("import_kind"), "csv");
    EXPECT_EQ(r.attributes.at("imported_from"), "f.csv");
    for (const auto& [name, text] : r.attributes) EXPECT_FALSE(says(text, folder.string())) << name;
    EXPECT_EQ(r.state, "finished");

    write_record(folder / "record.h5", r);
    const RunRecord back = read_record(folder / "record.h5");
    EXPECT_EQ(series(back, "forces", "fz"), (std::vector<double>{1, 2}));
    EXPECT_EQ(back.attributes, r.attributes);
}

TEST_F(ImportTest, ARecordOfARunStandsForItsScene) {
    SceneOverrides faster;
    faster.speed = 9;
    RunRecord run = new_record(read_scene(folder / "scene.toml", faster), "sph");
    run.table("height").time = {0};
    run.table("height").column("gauge", "m").values = {0};
    run.table("forces").time = {0};
    run.table("forces").column("fx", "N").values = {77};
    write_record(folder / "run.h5", run);
    write("f.csv", "t [s],F [N],H [m]\n0,1,0.1\n1,2,0.2\n");
    write("map.toml",
          "kind = \"csv\"\nname = \"tank\"\nsource = \"f.csv\"\nscene = \"run.h5\"\ntime = 1\n[forces]\nfz = 2\n"
          "[height]\ngauge = 3\n");
    const RunRecord r = import_record(folder / "map.toml");
    EXPECT_EQ(r.attributes.at("scene_hash"), run.attributes.at("scene_hash"));
    EXPECT_EQ(r.numbers.at("speed"), 9);
    EXPECT_NE(r.attributes.at("scene_hash"), read_scene(folder / "scene.toml").hash);
    EXPECT_EQ(series(r, "height", "gauge")[1], 0.2);
    EXPECT_EQ(r.series("forces", "fx"), nullptr);  // nothing of the run's own results
    EXPECT_FALSE(r.numbers.contains("near_hull"));
}

TEST_F(ImportTest, HalfModelsAreDoubledOnce) {
    write("f.csv", "t,a,b\n0,100,3\n1,,4\n");
    const std::string columns =
        "moment_point = [0, 0, 0]\ntime = { column = \"t\", unit = \"s\" }\n[forces]\n"
        "fx = { column = \"a\", unit = \"N\" }\nfy = { column = \"a\", unit = \"N\" }\n"
        "fz = { column = \"a\", unit = \"N\" }\nmy = { column = \"b\", unit = \"N m\" }\n[pressure]\n"
        "keel = { column = \"a\", unit = \"Pa\" }\n[samples]\nwetted_length = { column = \"b\", unit = \"m\" }\n"
        "wetted_area = { column = \"b\", unit = \"m2\" }\n";
    const RunRecord whole = imported("csv", "f.csv", columns);
    const RunRecord half = imported("csv", "f.csv", "half_model = true\n" + columns);
    EXPECT_EQ(series(whole, "forces", "fx")[0], 100);
    EXPECT_EQ(series(whole, "forces", "fy")[0], 100);
    EXPECT_EQ(series(half, "forces", "fx")[0], 200);
    EXPECT_EQ(series(half, "forces", "fz")[0], 200);
    EXPECT_EQ(series(half, "forces", "fy")[0], 0);  // the two sides carry opposite side forces
    EXPECT_TRUE(std::isnan(series(half, "forces", "fy")[1]) && std::isnan(series(half, "forces", "fx")[1]));
    EXPECT_DOUBLE_EQ(series(half, "forces", "my")[0], 2 * series(whole, "forces", "my")[0]);
    EXPECT_EQ(series(half, "pressure", "keel")[0], 100);
    EXPECT_EQ(series(half, "samples", "wetted_length")[0], 3);
    EXPECT_EQ(series(half, "samples", "wetted_area")[0], 6);
    EXPECT_EQ(half.attributes.at("symmetry_factor"), "2");
    EXPECT_EQ(whole.attributes.at("symmetry_factor"), "1");
}

TEST_F(ImportTest, MomentsAreMovedToTheScenesReference) {
    // A force (10, 0, 1000) N at the reference has no moment there; about another point it has M_y = r_z F_x - r_x F_z
    // with r from the point to the reference.
    const Vec3 reference = moment_reference(read_scene(folder / "scene.toml")), point(-1, 0, 0.5);
    const Vec3 arm = reference - point;
    const double moment = arm.z() * 10 - arm.x() * 1000;
    ASSERT_LT(moment, -1000);  // lift behind the point: bow down
    write("f.csv", fmt::format("t [s],X [N],Z [N],M [Nm]\n0,10,1000,{}\n", moment));
    const std::string forces = "time = 1\n[forces]\nfx = 2\nfz = 3\nmy = 4\n";
    const RunRecord r = imported("csv", "f.csv", "moment_point = [-1, 0, 0.5]\n" + forces);
    EXPECT_NEAR(series(r, "forces", "my")[0], 0, 1e-9);
    EXPECT_TRUE(says(refusal("csv", "f.csv", forces), "nothing says which point the moment my is taken about"));
    EXPECT_TRUE(says(refusal("csv", "f.csv", "moment_point = [-1, 0, 0]\ntime = 1\n[forces]\nfx = 2\nmy = 4\n"),
                     "expected fz beside it"));
}

TEST_F(ImportTest, ComputeForcesOfDualSPHysicsIsKnownByItsHeader) {
    write("forces.csv",
          "Part;Time [s];Np;ForceFluid.x [N];ForceFluid.y [N];ForceFluid.z [N];ForceFluid [N];Moment [Nm]\n"
          "0;0;12;1;2;3;3.7;9\n1;0.01;12;4;5;6;8.8;9\n");
    RunRecord r = imported("dualsphysics", "forces.csv", "half_model = true\n");
    EXPECT_EQ(r.tables.at("forces").time, (std::vector<double>{0, 0.01}));
    EXPECT_EQ(series(r, "forces", "fx"), (std::vector<double>{2, 8}));
    EXPECT_EQ(series(r, "forces", "fz"), (std::vector<double>{6, 12}));
    EXPECT_EQ(r.attributes.at("friction"), "none");
    EXPECT_EQ(r.series("forces", "my"), nullptr);  // its axis is not in the file
    // Commas and short names do as well; what the mapping says goes first.
    write("short.csv", "time,fx,fz,Moment [Nm]\n0,1,3,9\n1,4,6,9\n");
    r = imported("dualsphysics", "short.csv",
                 "friction = true\n[forces]\nfx = { column = \"fz\", unit = \"N\", scale = -1 }\n");
    EXPECT_EQ(series(r, "forces", "fx"), (std::vector<double>{-3, -6}));
    EXPECT_EQ(series(r, "forces", "fz"), (std::vector<double>{3, 6}));
    EXPECT_EQ(r.attributes.at("friction"), "included");

    write("other.csv", "step,resistance\n0,1\n");
    const std::string message = refusal("dualsphysics", "other.csv", "");
    EXPECT_TRUE(says(message, "\"step\", \"resistance\"") && says(message, "kind = \"csv\"")) << message;
    write("flat.csv", "Part;Time [s];ForceFluid.x [N/m];ForceFluid.z [N/m]\n0;0;1;2\n");  // a 2-D run
    EXPECT_TRUE(says(refusal("dualsphysics", "flat.csv", ""), "is in N/m; expected unit = \"N\""));
}

/// One row of force.dat and moment.dat as openfoam.com writes them: total, pressure, viscous.
std::string com_row(double t, const Vec3& pressure, const Vec3& viscous) {
    const auto vec = [](const Vec3& v) { return fmt::format("({} {} {})", v.x(), v.y(), v.z()); };
    return fmt::format("{} \t{}\t{}\t{}\n", t, vec(pressure + viscous), vec(pressure), vec(viscous));
}
const std::string com_head =
    "# Force         \n# CofR          : (1.5 0 0)\n#\n# Time          \t(total_x total_y total_z)\t(pressure_x "
    "pressure_y pressure_z)\t(viscous_x viscous_y viscous_z)\n";

TEST_F(ImportTest, OpenFoamStartTimesAreJoinedAndAxesTurned) {
    // The case has its bow towards +x: the scene's x, y, z are the case's -x, -y, z.
    const std::string post = "case/postProcessing/hullForces/";
    for (const char* name : {"force.dat", "moment.dat"}) {
        write(post + "0/" + name,
              com_head + com_row(0.1, {-1, 0, 10}, {-2, 0, 0}) + com_row(0.2, {-9, 9, 99}, {-9, 9, 9}));
        write(post + "0.2/" + name, com_head + com_row(0.2, {-3, 5, 30}, {-4, 0, 1}));
    }
    const std::string keys = "function_object = \"hullForces\"\n";
    const RunRecord r = imported("openfoam", "case", keys + "axes = \"-x-yz\"\nhalf_model = true\n");
    EXPECT_EQ(r.tables.at("forces").time, (std::vector<double>{0.1, 0.2}));  // the later start wins
    EXPECT_EQ(series(r, "forces", "fx"), (std::vector<double>{6, 14}));
    EXPECT_EQ(series(r, "forces", "fy"), (std::vector<double>{0, 0}));
    EXPECT_EQ(series(r, "forces", "fz"), (std::vector<double>{20, 62}));
    EXPECT_EQ(series(r, "forces", "fx_pressure"), (std::vector<double>{2, 6}));
    EXPECT_EQ(series(r, "forces", "fx_viscous"), (std::vector<double>{4, 8}));
    EXPECT_EQ(r.attributes.at("imported_from"), "case");
    EXPECT_FALSE(r.attributes.contains("friction"));  // its column tells

    // The moment about the case's CofR, turned with the axes and moved: M_y' = M_y + d_z F_x - d_x F_z.
    const RunRecord whole = imported("openfoam", "case", keys + "axes = \"-x-yz\"\n");
    EXPECT_EQ(series(whole, "forces", "fy")[1], -5);
    const double d_x = -1.5 - moment_reference(read_scene(folder / "scene.toml")).x();
    EXPECT_NEAR(series(whole, "forces", "my")[1], -5 - d_x * 31, 1e-9);
    // A case with y up: lift is its y, the scene's y its -z.
    const RunRecord y_up = imported("openfoam", "case", keys + "axes = \"x-zy\"\n");
    EXPECT_EQ(series(y_up, "forces", "fx")[1], -7);
    EXPECT_EQ(series(y_up, "forces", "fy")[1], -31);
    EXPECT_EQ(series(y_up, "forces", "fz")[1], 5);
    EXPECT_TRUE(says(refusal("openfoam", "case", keys + "axes = \"-xyz\"\n"), "mirrors the case"));
    EXPECT_TRUE(says(refusal("openfoam", "case", ""), "holds: hullForces"));
}

TEST_F(ImportTest, OpenFoamOrgWritesOneFile) {
    write("case/postProcessing/forces/0/forces.dat",
          "# Forces\n# CofR : (0 0 0)\n# Time forces(pressure viscous) moment(pressure viscous)\n"
          "0.5\t((1 2 3) (10 20 30)) ((4 5 6) (40 50 60))\n0.6\t((1 2 3) (10 20 30)) ((4 5 6) (40 50 60))\n");
    const RunRecord r = imported("openfoam", "case", "moment_point = [2, 0, 0]\n");
    EXPECT_EQ(series(r, "forces", "fx"), (std::vector<double>{11, 11}));
    EXPECT_EQ(series(r, "forces", "fz_viscous")[0], 30);
    const double d_x = 2 - moment_reference(read_scene(folder / "scene.toml")).x();
    EXPECT_NEAR(series(r, "forces", "my")[0], 55 - d_x * 33, 1e-9);  // not the 55 about the file's CofR
    // Without CofR and moment_point a moment is about nothing, and is left out.
    write("case/postProcessing/forces/0/forces.dat", "# Time\n0.5 ((1 2 3) (1 2 3)) ((4 5 6) (4 5 6))\n");
    EXPECT_EQ(imported("openfoam", "case", "").series("forces", "my"), nullptr);
}

/// Two times of a block of water, 1 m by 0.5 m by 0.5 m, in cubes of 0.125 m; the second time 0.25 m higher.
std::string block_of_water() {
    std::string text = "t [ms],x [m],y [m],z [mm],V [m3],cell [m3]\n";
    for (const int frame : {0, 1})
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 4; ++j)
                for (int k = 0; k < 4; ++k)
                    text += fmt::format("{},{},{},{},{},{}\n", 100 * frame, 1 + 0.125 * (i + 0.5), 0.125 * (j + 0.5),
                                        125 * (k + 0.5) + 250 * frame, std::pow(0.125, 3), std::pow(0.125, 3));
    return text;
}
const std::string water_columns =
    "[water]\nsource = \"water.csv\"\ntime = \"t [ms]\"\nx = \"x [m]\"\ny = \"y [m]\"\nz = \"z [mm]\"\nvolume = \"V "
    "[m3]\"\n";

TEST_F(ImportTest, WaterBecomesFramesAndTheSizeAtTheHullANumber) {
    write("f.csv", "t [s],F [N]\n0,1\n1,2\n");
    write("water.csv", block_of_water());
    const std::string top = "half_model = true\nnear_hull = \"40 mm\"\ntime = 1\n[forces]\nfz = 2\n";
    for (const char* cell : {"", "cell = 6\n"}) {
        const RunRecord r = imported("csv", "f.csv", top + water_columns + cell);
        EXPECT_EQ(r.numbers.at("near_hull"), 0.04);
        ASSERT_EQ(r.frames.size(), 2u);
        EXPECT_EQ(r.frames[1].time, 0.1);
        const RasterGrid grid(r.raster);
        ASSERT_EQ(grid.spec.voxel, 0.25);
        for (const int frame : {0, 1}) {
            const auto& water = r.frames[static_cast<std::size_t>(frame)].water;
            int wet = 0;
            for (int k = 0; k < grid.nz; ++k)
                for (int j = 0; j < grid.ny; ++j)
                    for (int i = 0; i < grid.nx; ++i) {
                        const double above = grid.z_low(k) - 0.25 * frame;
                        const bool in_block = grid.x(i) > 1 && grid.x(i) < 2 && grid.y(j) > 0 && grid.y(j) < 0.5 &&
                                              above > -0.01 && above < 0.49;
                        ASSERT_EQ(int(water[grid.voxel(i, j, k)]), in_block ? 255 : 0) << i << " " << j << " " << k;
                        wet += in_block;
                    }
            EXPECT_EQ(wet, 4 * 2 * 2);
        }
        EXPECT_EQ(grid_study_run(r).spacing, 0.04);
        EXPECT_NEAR(splash_series(r, 0).find("raw_height")->values[1], 0.75, 1e-9);
    }
}

TEST_F(ImportTest, WaterThatCannotBeIsRefused) {
    write("f.csv", "t [s],F [N]\n0,1\n1,2\n");
    const auto refused = [&](const std::string& rows, const std::string& columns = water_columns,
                             const std::string& half = "half_model = true\n") {
        write("water.csv", "t [ms],x [m],y [m],z [mm],V [m3],cell [m3]\n" + rows);
        return refusal("csv", "f.csv", half + "time = 1\n[forces]\nfz = 2\n" + columns);
    };
    EXPECT_TRUE(says(refused("0,1,0,0,-1,1\n"), "water.csv:2: -1 m3 of water in -1 m3"));
    EXPECT_TRUE(says(refused("0,1,0,0,2,1\n", water_columns + "cell = 6\n"), "water.csv:2: 2 m3 of water in 1 m3"));
    EXPECT_TRUE(says(refused("100,1,0,0,1,1\n0,1,0,0,1,1\n"), "water.csv:3: time 0 s found after 0.1 s"));
    EXPECT_TRUE(says(refused("0,1,,0,1,1\n"), "water.csv:2: a cell of [water] has no number"));
    EXPECT_TRUE(
        says(refused("0,1,0,0,1,1\n", "[water]\nsource = \"water.csv\"\ntime = 1\n"), "missing; expected a column"));
    EXPECT_TRUE(
        says(refused("0,1,0,0,1,1\n", water_columns, ""), "the scene is solved as one half and half_model = false"));
}

}  // namespace import_test
}  // namespace tw
