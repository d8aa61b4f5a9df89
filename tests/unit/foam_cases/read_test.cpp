// Field files and hull surfaces as OpenFOAM writes them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "base/numbers.h"
#include "foam_cases/read/field_file.h"
#include "foam_cases/read/frame_reader.h"
#include "foam_cases/read/hull_patch.h"
#include "meshes/generate.h"
#include "record/snapshot.h"
#include "scenes.h"

namespace tw {
namespace read_test {
namespace fs = std::filesystem;

class ReadTest : public testing::Test {
protected:
    fs::path folder = fs::temp_directory_path() / ("foam_read_" + std::to_string(::getpid()));
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }
    fs::path write(const std::string& text) const {
        std::ofstream(folder / "field", std::ios::binary) << text;
        return folder / "field";
    }
    static std::string header(const std::string& format, const std::string& foam_class,
                              const std::string& arch = "LSB;label=32;scalar=64") {
        return "FoamFile\n{\n    version     2.0;\n    format      " + format + ";\n    class       " + foam_class +
               ";\n    arch        \"" + arch + "\";\n    object      x;\n}\n\ndimensions      [0 0 0 0 0 0 0];\n\n";
    }
    template <class Real>
    static std::string bytes(std::initializer_list<Real> values) {
        std::string out;
        for (const Real v : values) out.append(reinterpret_cast<const char*>(&v), sizeof v);
        return out;
    }
};

TEST_F(ReadTest, AsciiAndBinarySingleAndDoubleScalarAndVector) {
    const std::string tail = ")\n;\n\nboundaryField\n{\n    hull { type zeroGradient; }\n}\n";
    FieldFile f = read_field(write(header("ascii", "volScalarField") +
                                   "internalField   nonuniform List<scalar> \n3\n(\n0.5\n-1e-3\n2\n" + tail));
    ASSERT_EQ(f.cells(), 3u);
    EXPECT_DOUBLE_EQ(f.scalar(1), -1e-3);

    f = read_field(write(header("binary", "volScalarField") + "internalField   nonuniform List<scalar> 2(" +
                         bytes<double>({0.25, 41}) + tail));
    ASSERT_EQ(f.cells(), 2u);
    EXPECT_DOUBLE_EQ(f.scalar(1), 41) << "bytes that look like a bracket are no bracket";

    f = read_field(write(header("binary", "volVectorField", "LSB;label=32;scalar=32") +
                         "internalField nonuniform List<vector> 1(" + bytes<float>({1, 2, 3}) + tail));
    EXPECT_EQ(f.vector(0), Vec3(1, 2, 3));

    f = read_field(write(header("binary", "volVectorField") + "internalField   uniform (8 0 0);\n"));
    EXPECT_TRUE(f.uniform);
    EXPECT_EQ(f.vector(17), Vec3(8, 0, 0));

    f = read_field(write(header("binary", "volScalarField") +
                         "internalField   nonuniform List<scalar> 0()\n;\n"));  // a rank without cells
    EXPECT_EQ(f.cells(), 0u);
}

TEST_F(ReadTest, FilesThatAreCutOffOrOfAnotherClassAreErrorsThatNameThem) {
    const std::string good = header("binary", "volScalarField") + "internalField   nonuniform List<scalar> 3(" +
                             bytes<double>({1, 2, 3}) + ")\n;\n";
    ASSERT_NO_THROW(read_field(write(good)));
    for (const std::size_t keep :
         {good.size() - 4, good.size() - 12, good.find("3("), good.find("internalField"), std::size_t{0}})
        EXPECT_THROW(read_field(write(good.substr(0, keep))), RunError) << keep;
    EXPECT_THROW(read_field(write(header("ascii", "surfaceScalarField") + "internalField uniform 0;")), RunError);
    EXPECT_THROW(
        read_field(write(header("ascii", "volScalarField") + "internalField nonuniform List<scalar> 99999999999(1)")),
        RunError);
    try {
        read_field(folder / "missing");
        FAIL();
    } catch (const RunError& e) { EXPECT_NE(std::string(e.what()).find("missing"), std::string::npos); }
}

TEST_F(ReadTest, CellVolumesHaveTheNameThatTheReleaseGivesThem) {
    std::ofstream(folder / "V") << "";
    EXPECT_EQ(cell_volumes_in(folder), "V");
    fs::remove(folder / "V");
    std::ofstream(folder / "Vc") << "";
    EXPECT_EQ(cell_volumes_in(folder), "Vc") << "openfoam.org 12";
}

/// A box in still water, 0.3 m wide, its top `above` the surface; pressure rho g depth on it, all faces wet below z =
/// 0.
HullPatch box_in_water(const fs::path& folder, double above) {
    Surface box = make_hull("box", {{"length", 0.4}, {"beam", 0.3}, {"height", 0.2}});
    const Box b = box.bounds();
    for (Vec3& p : box.points) p += Vec3(1, 0, above - b.max.z());
    for (auto& t : box.triangles) std::swap(t[1], t[2]);  // OpenFOAM's faces point out of the flow
    Field p{"p", 1, {}}, alpha{"alpha.water", 1, {}};
    for (std::size_t t = 0; t < box.triangles.size(); ++t) {
        const double z = (box.corner(static_cast<int>(t), 0).z() + box.corner(static_cast<int>(t), 1).z() +
                          box.corner(static_cast<int>(t), 2).z()) /
                         3;
        p.values.push_back(static_cast<float>(z < 0 ? -9810 * z : 0));
        alpha.values.push_back(z < 0 ? 1.0f : 0.0f);
    }
    write_surface(folder / "hull.vtp", box, {p, alpha});
    return *read_hull_patch(folder);
}

TEST_F(ReadTest, SuctionIsPressureBelowTheAirsOnWetFacesAlone) {
    HullPatch patch = box_in_water(folder, -0.1);
    EXPECT_EQ(wet_wall(patch).suction_area(), 0) << "still water presses everywhere";
    for (HullPatch::Face& f : patch.faces) f.pressure = f.area.z() > 0 ? -50 : 200;  // the bottom's faces point up
    EXPECT_NEAR(wet_wall(patch).suction_area(), 0.4 * 0.3, 1e-6);
    EXPECT_NEAR(wet_wall(patch).suction_force(), 50 * 0.4 * 0.3, 1e-4);
    for (HullPatch::Face& f : patch.faces) f.water = 0.4;
    EXPECT_EQ(wet_wall(patch).suction_force(), 0) << "air";
}

TEST_F(ReadTest, TheWatersLoadOnASubmergedBoxIsItsWeightOfWater) {
    const HullPatch patch = box_in_water(folder, -0.1);
    // About a point 1 m ahead of its centre the lift turns the bow down: my = -x fz.
    const WaterLoad load = water_load(patch, 1000, 1.2, Vec3::Zero());
    EXPECT_NEAR(load.pressure.z(), 9810 * 0.4 * 0.3 * 0.2, 1e-3);
    EXPECT_NEAR(load.pressure.x(), 0, 1e-4);
    EXPECT_NEAR(load.wetted_area, 2 * (0.4 * 0.3 + 0.4 * 0.2 + 0.3 * 0.2), 1e-6);
    EXPECT_EQ(load.air, Vec3(0, 0, 0));
    EXPECT_NEAR(load.ventilation, 0, 1e-12);
    double mean_x = 0.5 * (patch.surface.bounds().min.x() + patch.surface.bounds().max.x());
    EXPECT_NEAR(load.moment.y(), -mean_x * load.pressure.z(), 0.02 * load.pressure.z());
    // The picture's triangles point out of the hull again.
    double volume = 0;
    for (const auto& t : patch.surface.triangles)
        volume += patch.surface.points[static_cast<std::size_t>(t[0])].dot(
                      patch.surface.points[static_cast<std::size_t>(t[1])].cross(
                          patch.surface.points[static_cast<std::size_t>(t[2])])) /
                  6;
    EXPECT_NEAR(volume, 0.4 * 0.3 * 0.2, 1e-7);
}

TEST_F(ReadTest, DryFacesCountAsAirAndNotAsWater) {
    HullPatch patch = box_in_water(folder, -0.1);
    for (auto& f : patch.faces)
        if (f.area.z() < 0) f.water = 0.01, f.pressure = 100;  // the deck looks up: 100 Pa of air on it
    const WaterLoad load = water_load(patch, 1000, 1.2, Vec3::Zero());
    EXPECT_NEAR(load.air.z(), -100 * 0.4 * 0.3, 1e-6);
    EXPECT_NEAR(load.pressure.z(), 9810 * 0.3 * 0.12, 1e-3) << "only the bottom, 0.3 m deep, is left";
}

TEST_F(ReadTest, FrictionIsCorrectedForAirUnderTheHull) {
    HullPatch patch = box_in_water(folder, -0.1);
    for (auto& f : patch.faces)
        if (f.area.z() > 0) f.water = 0.8, f.shear = Vec3(-0.01, 0, 0);  // OpenFOAM's sign: the wall brakes the stream
    const WaterLoad load = water_load(patch, 1000, 0, Vec3::Zero());
    EXPECT_NEAR(load.viscous.x(), 1000 * 0.01 * 0.12, 1e-7) << "drag: along the stream";
    EXPECT_NEAR(load.viscous_mixture.x(), 0.8 * 1000 * 0.01 * 0.12, 1e-7);
    EXPECT_NEAR(load.ventilation, 0.2, 1e-9);
}

TEST_F(ReadTest, AnEdgeThatTheMeshHasCutOffShows) {
    const HullPatch patch = box_in_water(folder, -0.1);
    Surface box = patch.surface;
    EXPECT_LT(mesh_error(patch, box, -1, 0), 1e-7);
    box.points.push_back(Vec3(1, 0, -0.35));  // the true keel: 0.05 m below the mesh's bottom
    EXPECT_NEAR(mesh_error(patch, box, -1, 0), 0.05, 1e-6);
    EXPECT_LT(mesh_error(patch, box, 0.1, 0), 1e-7) << "not in the solved half";
}

TEST_F(ReadTest, AMissingOrBrokenSurfaceIsNoSurface) {
    EXPECT_FALSE(read_hull_patch(folder));
    std::ofstream(folder / "hull.vtp") << "<VTKFile type=\"PolyData\"";
    EXPECT_FALSE(read_hull_patch(folder));
}

/// Corners that are no points, and fields that are not one value a face.
TEST_F(ReadTest, ASurfaceWhoseNumbersContradictEachOtherIsNoSurface) {
    const std::string sound =
        "# vtk DataFile Version 2.0\nhull\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
        "POLYGONS 1 4\n3 0 1 2\nCELL_DATA 1\nFIELD a 2\np 1 1 float\n100\nalpha.water 1 1 float\n1\n";
    const auto read = [&](const std::string& from, const std::string& to) {
        std::string text = sound;
        std::ofstream(folder / "hull.vtk") << text.replace(text.find(from), from.size(), to);
        return read_hull_patch(folder).has_value();
    };
    EXPECT_TRUE(read("hull", "hull"));
    EXPECT_FALSE(read("3 0 1 2", "3 0 1 9"));
    EXPECT_FALSE(read("3 0 1 2", "3 0 1 -900000"));
    EXPECT_FALSE(read("3 0 1 2", "9 0 1 2"));
    EXPECT_FALSE(read("POLYGONS 1 4", "POLYGONS 1 40000000"));
    EXPECT_FALSE(read("p 1 1 float\n100", "p 1 0 float\n"));
    EXPECT_FALSE(read("p 1 1 float\n100", "p 2 1 float\n100 3"));
}

// Two by two cells of 0.1 m over half a metre of span, the lower ones full and one of the upper half full; the box takes the
// right column, four tenths of the left one beside it, and the lower half of the upper cells.
TEST_F(ReadTest, WaterInABoxIsThatOfTheCellsThatItHoldsAndOfTheirPartsThatItCuts) {
    Scene scene = dam_break_scene();
    scene.domain.box = {Vec3(0, 0, 0), Vec3(0.2, 0.5, 0.2)};
    scene.water_blocks = {{Vec3(0, 0, 0), Vec3(0.2, 0.5, 0.1)}};
    scene.sampling.raster.voxel = 0;
    scene.sampling.volumes = {{"right", {Vec3(0.06, -infinite, -1), Vec3(1, infinite, 0.15)}}};
    const CasePlan plan = plan_case(scene, Flavour{});
    const auto field = [&](const fs::path& at, const std::string& of, const std::string& name,
                           const std::string& list) {
        fs::create_directories(folder / at);
        std::ofstream(folder / at / name) << header("ascii", of) + "internalField   nonuniform List<" +
                                                 (of == "volVectorField" ? "vector" : "scalar") + "> 4(" + list +
                                                 "\n)\n;\n";
    };
    field("0", "volVectorField", "C", "(0.05 0.25 0.05)(0.15 0.25 0.05)(0.05 0.25 0.15)(0.15 0.25 0.15)");
    field("0", "volScalarField", "V", "0.005 0.005 0.005 0.005");
    field("0.02", "volScalarField", "alpha.water", "1 1 0 0.5");
    field("0.02", "volVectorField", "U", "(0 0 0)(0 0 0)(0 0 0)(0 0 0)");
    RunRecord record;
    FrameReader(plan, folder).read({0.02, "0.02"}, SolverLog{}, record);
    ASSERT_TRUE(record.series("volume", "right"));
    EXPECT_NEAR(record.series("volume", "right")->values.at(0), 0.01 * (1 + 0.4 + 0.25), 1e-12);
    EXPECT_EQ(record.series("volume", "right")->unit, "m3/m");
}

TEST(FrameReader, ContinuityOfAHeldHullIsWhatIsMadeWhileTheStreamPassesItOnce) {
    const Scene scene = planing_scene();  // 4 m at 8 m/s
    const auto line = [&](double made) {  // of the domain in a step of 10 ms, of which half a second holds fifty
        SolverLog::Step step;
        step.step = 0.01, step.continuity = made;
        return continuity_of_held_hull(scene, step);
    };
    EXPECT_NEAR(line(1e-5).value, 0.05, 1e-12);
    EXPECT_TRUE(line(1e-5).met());
    EXPECT_FALSE(line(1e-4).met());
    EXPECT_FALSE(line(std::nan("")).met());
}

}  // namespace read_test
}  // namespace tw
