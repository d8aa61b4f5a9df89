#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <functional>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/hdf5_file.h"
#include "record/snapshot.h"
#include "spray/extract/read_frames.h"
#include "tests/unit/record/example_record.h"
#include "tests/unit/spray/row_of_cells.h"

namespace tw::spray {
namespace read_frames_test {
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

/// Numbers that nobody can have meant, in a file whose own checksums are right.
TEST(Snapshots, RefuseNumbersThatContradictEachOther) {
    const ScratchFolder folder;
    const auto complaint = [&](const std::function<void(hid_t)>& change) -> std::string {
        const fs::path file = folder / "particles_1.hdf";
        write_particles(file, 1, {{0, 0, 0}, {1, 2, 3}}, {{"velocity", 3, {1, 2, 3, 4, 5, 6}}, {"spacing", 1, {1, 1}}});
        change(h5::Handle(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose));
        try {
            read_particles({1, file});
            return "";
        } catch (const InputError& e) { return e.what(); }
    };
    const auto put = [](hid_t file, const char* name, hid_t type, auto value) {
        const h5::Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
        std::vector<decltype(value)> values(
            static_cast<std::size_t>(H5Sget_simple_extent_npoints(h5::Handle(H5Dget_space(set), H5Sclose))), value);
        ASSERT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    };
    EXPECT_EQ(complaint([](hid_t) {}), "");
    for (const long long count : {-1LL, 3LL, 1LL << 39, 1LL << 60})
        EXPECT_NE(complaint([&](hid_t f) { put(f, "VTKHDF/NumberOfPoints", H5T_NATIVE_LLONG, count); }).find("points"),
                  std::string::npos)
            << count;
    for (const char* name : {"VTKHDF/Points", "VTKHDF/PointData/velocity", "VTKHDF/PointData/spacing"})
        EXPECT_NE(complaint([&](hid_t f) { put(f, name, H5T_NATIVE_FLOAT, NAN); }).find("particle 0"),
                  std::string::npos)
            << name;
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

/// Where a cell of one size meets finer ones it has more faces than a box: VTK's polyhedron.
TEST(Cells, OfManyFacesAreReadAsTheOthers) {
    const ScratchFolder folder;
    write_row_of_cells(folder / "case");
    const auto change = [&](const std::string& name, const std::string& from, const std::string& to) {
        const fs::path file = folder / "case/constant/polyMesh" / name;
        std::string text = read_text(file);
        ASSERT_NE(text.find(from), std::string::npos) << name;
        write_text_atomically(file, text.replace(text.find(from), from.size(), to));
    };
    change("faces", "16\n(", "17\n(");  // the face between the first two cells, in two
    change("faces", "4(4 5 6 7)", "3(4 5 6)\n3(4 6 7)");
    change("owner", "16\n(\n0", "17\n(\n0\n0");
    change("neighbour", "2\n(\n1", "3\n(\n1\n1");
    change("boundary", "startFace 2", "startFace 3");
    double left_out = 0;
    const WaterFrame frame = read_cells(foam_frames(folder / "", {}).at(0), 0.2, left_out);
    EXPECT_NEAR(left_out, 0.1, 1e-7);
    ASSERT_EQ(frame.elements.size(), 2u);
    EXPECT_EQ(frame.elements[0].place, Vec3(0.5, 0.5, 0.5));
    EXPECT_EQ(frame.elements[1].velocity, Vec3(3, 0, 4));
}

}  // namespace read_frames_test
}  // namespace tw::spray
