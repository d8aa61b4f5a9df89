#include <gtest/gtest.h>
#include <hdf5.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/snapshot.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace snapshot_test {

template <class T>
std::vector<T> whole(hid_t file, const std::string& path, hid_t type) {
    const hid_t set = H5Dopen2(file, path.c_str(), H5P_DEFAULT), space = H5Dget_space(set);
    std::vector<T> v(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, v.data());
    H5Sclose(space);
    H5Dclose(set);
    return v;
}

/// The layout VTK's file format document asks of an UnstructuredGrid in one piece.
TEST(Snapshots, ParticlesFollowTheVtkHdfLayout) {
    const ScratchFolder folder;
    const std::vector<Vec3> points{{0, 0, 0}, {1, 2, 3}, {-1, 0.5, 0.25}};
    write_particles(folder / "p.hdf", 0.75, points,
                    {{"pressure", 1, {1, 2, 3}}, {"velocity", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}}});
    const hid_t file = H5Fopen((folder / "p.hdf").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    EXPECT_EQ(whole<long long>(file, "VTKHDF/NumberOfPoints", H5T_NATIVE_LLONG), (std::vector<long long>{3}));
    EXPECT_EQ(whole<long long>(file, "VTKHDF/NumberOfCells", H5T_NATIVE_LLONG), (std::vector<long long>{3}));
    EXPECT_EQ(whole<long long>(file, "VTKHDF/Offsets", H5T_NATIVE_LLONG), (std::vector<long long>{0, 1, 2, 3}));
    EXPECT_EQ(whole<long long>(file, "VTKHDF/Connectivity", H5T_NATIVE_LLONG), (std::vector<long long>{0, 1, 2}));
    EXPECT_EQ(whole<int>(file, "VTKHDF/Types", H5T_NATIVE_INT), (std::vector<int>{1, 1, 1}));
    EXPECT_EQ(whole<float>(file, "VTKHDF/Points", H5T_NATIVE_FLOAT),
              (std::vector<float>{0, 0, 0, 1, 2, 3, -1, 0.5, 0.25}));
    EXPECT_EQ(whole<float>(file, "VTKHDF/PointData/velocity", H5T_NATIVE_FLOAT).size(), 9u);
    EXPECT_EQ(whole<double>(file, "VTKHDF/FieldData/TimeValue", H5T_NATIVE_DOUBLE), (std::vector<double>{0.75}));
    H5Fclose(file);
}

TEST(Snapshots, NoParticlesAtAllIsAFileToo) {
    const ScratchFolder folder;
    write_particles(folder / "p.hdf", 0, {}, {{"pressure", 1, {}}});
    EXPECT_TRUE(std::filesystem::exists(folder / "p.hdf"));
}

TEST(Snapshots, SurfaceComesBackThroughVtk) {
    const ScratchFolder folder;
    const RunRecord r = example_record();
    write_surface(folder / "hull.vtp", r.hull, {{"pressure", 1, {1, 2, 3, 4}}});
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((folder / "hull.vtp").c_str());
    reader->Update();
    ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), 4);
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 4);
    EXPECT_EQ(reader->GetOutput()->GetCellData()->GetArray("pressure")->GetTuple1(2), 3);
    EXPECT_EQ(reader->GetOutput()->GetPoint(3)[2], 1.0 / 3.0);
}

TEST(Snapshots, AFieldOfTheWrongLengthIsRefused) {
    const ScratchFolder folder;
    EXPECT_THROW(write_particles(folder / "p.hdf", 0, {{0, 0, 0}}, {{"pressure", 1, {1, 2}}}), RunError);
    EXPECT_THROW(write_surface(folder / "s.vtp", example_record().hull, {{"pressure", 1, {1}}}), RunError);
}

TEST(Snapshots, SeriesIsTheJsonParaViewReads) {
    const ScratchFolder folder;
    write_series(folder / "p.hdf.series", {{"p_0.hdf", 0}, {"p_1.hdf", 0.1}});
    const auto json = nlohmann::json::parse(read_text(folder / "p.hdf.series"));
    EXPECT_EQ(json["file-series-version"], "1.0");
    EXPECT_EQ(json["files"][1]["name"], "p_1.hdf");
    EXPECT_EQ(json["files"][1]["time"], 0.1);
}

}  // namespace snapshot_test
}  // namespace tw
