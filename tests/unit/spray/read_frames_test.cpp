#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/snapshot.h"
#include "spray/extract/read_frames.h"
#include "tests/unit/record/example_record.h"

namespace tw::spray {
namespace {
namespace fs = std::filesystem;

TEST(Snapshots, GiveBackTheWaterThatWasWritten) {
    const ScratchFolder folder;
    fs::create_directories(folder / "snapshots");
    const std::vector<Vec3> places{{0, 0, 0}, {1, 2, 3}};
    for (const double time : {0.5, 0.25})
        write_particles(folder / "snapshots" / ("particles_" + std::to_string(time) + ".hdf"), time, places,
                        {{"velocity", 3, {1, 2, 3, 4, 5, 6}}, {"spacing", 1, {0.5f, 0.25f}}});
    const auto frames = particle_frames(folder / "", {});
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].time, 0.25);
    const WaterFrame frame = read_particles(frames[0]);
    ASSERT_EQ(frame.elements.size(), 2u);
    EXPECT_EQ(frame.elements[1].place, Vec3(1, 2, 3));
    EXPECT_EQ(frame.elements[1].velocity, Vec3(4, 5, 6));
    EXPECT_EQ(frame.elements[1].volume, 0.25 * 0.25 * 0.25);
    EXPECT_EQ(mirrored(frame).elements[3].place, Vec3(1, -2, 3));
    EXPECT_EQ(mirrored(frame).elements[3].velocity, Vec3(4, -5, 6));
    EXPECT_THROW(particle_frames(folder / "", {0.3, 0.4}), InputError);
}

TEST(Snapshots, RefuseWhatIsNone) {
    const ScratchFolder folder;
    EXPECT_THROW(particle_frames(folder / "nowhere", {}), InputError);
    EXPECT_THROW(particle_frames(folder / "", {}), InputError);
    write_text_atomically(folder / "particles_1.hdf", "not HDF5");
    EXPECT_THROW(particle_frames(folder / "", {}), InputError);
    write_particles(folder / "flat.hdf", 0, {{0, 0.5, 0}, {1, 0.5, 1}},
                    {{"velocity", 3, {1, 2, 3, 4, 5, 6}}, {"spacing", 1, {1, 1}}});
    EXPECT_THROW(read_particles({0, folder / "flat.hdf"}), InputError);  // two dimensions
    write_particles(folder / "bare.hdf", 0, {{0, 0, 0}}, {});
    EXPECT_THROW(read_particles({0, folder / "bare.hdf"}), InputError);
}

/// Three cubes of 1 m in a row along x, as an OpenFOAM case of text: full, a tenth full, and full again.
void write_row_of_cells(const fs::path& folder) {
    const auto foam = [](const char* kind, const std::string& name, const std::string& body) {
        return std::string("FoamFile { version 2.0; format ascii; class ") + kind + "; object " + name + "; }\n" + body;
    };
    const auto put = [&](const std::string& file, const std::string& text) {
        fs::create_directories((folder / file).parent_path());
        write_text_atomically(folder / file, text);
    };
    const auto list = [](const std::vector<std::string>& items) {
        std::string text = std::to_string(items.size()) + "\n(\n";
        for (const auto& item : items) text += item + "\n";
        return text + ")\n";
    };
    put("system/controlDict", foam("dictionary", "controlDict", "startTime 0; deltaT 1; writeInterval 1;\n"));
    std::vector<std::string> points;
    for (int i = 0; i < 4; ++i)
        for (const char* yz : {"0 0", "1 0", "1 1", "0 1"}) points.push_back("(" + std::to_string(i) + " " + yz + ")");
    std::vector<std::string> faces, owner;
    const auto face = [&](int a, int b, int c, int d, int cell) {
        faces.push_back("4(" + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " " +
                        std::to_string(d) + ")");
        owner.push_back(std::to_string(cell));
    };
    face(4, 5, 6, 7, 0), face(8, 9, 10, 11, 1);  // between the cells
    face(0, 3, 2, 1, 0), face(12, 13, 14, 15, 2);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 4; ++k) face(4 * i + k, 4 * i + (k + 1) % 4, 4 * i + 4 + (k + 1) % 4, 4 * i + 4 + k, i);
    put("constant/polyMesh/points", foam("vectorField", "points", list(points)));
    put("constant/polyMesh/faces", foam("faceList", "faces", list(faces)));
    put("constant/polyMesh/owner", foam("labelList", "owner", list(owner)));
    put("constant/polyMesh/neighbour", foam("labelList", "neighbour", list({"1", "2"})));
    put("constant/polyMesh/boundary",
        foam("polyBoundaryMesh", "boundary", "1\n(\nwalls { type wall; nFaces 14; startFace 2; }\n)\n"));
    const auto field = [&](const char* kind, const std::string& at, const std::string& name,
                           const std::string& values) {
        put(at + "/" + name, foam(kind, name,
                                  "dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform " + values +
                                      ";\nboundaryField { walls { type zeroGradient; } }\n"));
    };
    field("volVectorField", "0", "C", "List<vector> 3((0.5 0.5 0.5) (1.5 0.5 0.5) (2.5 0.5 0.5))");
    field("volScalarField", "0", "V", "List<scalar> 3(1 1 1)");
    field("volScalarField", "1", "alpha.water", "List<scalar> 3(1 0.1 1)");
    field("volVectorField", "1", "U", "List<vector> 3((1 0 0) (2 0 0) (3 0 4))");
}

TEST(Cells, GiveTheirWaterAndWhatWasLeftOut) {
    const ScratchFolder folder;
    write_row_of_cells(folder / "case");
    const auto frames = foam_frames(folder / "", {});
    ASSERT_EQ(frames.size(), 1u);
    double left_out = 0;
    const WaterFrame frame = read_cells(frames[0], 0.2, left_out);
    EXPECT_NEAR(left_out, 0.1, 1e-7);
    ASSERT_EQ(frame.elements.size(), 2u);
    EXPECT_EQ(frame.elements[1].place, Vec3(2.5, 0.5, 0.5));
    EXPECT_EQ(frame.elements[1].velocity, Vec3(3, 0, 4));
    EXPECT_NEAR(frame.elements[1].volume, 1, 1e-7);
    EXPECT_NEAR(frame.elements[1].size, 1, 1e-7);
    fs::remove(folder / "case" / "0" / "V");
    EXPECT_THROW(read_cells(frames[0], 0.2, left_out), InputError);
    EXPECT_THROW(foam_frames(folder / "", {2, 3}), InputError);
    EXPECT_THROW(foam_frames(folder / "case" / "0", {}), InputError);
}

}  // namespace
}  // namespace tw::spray
