#include "record/snapshot.h"

#include <hdf5.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/hdf5_file.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

void check_fields(const fs::path& file, const std::vector<Field>& fields, std::size_t count) {
    for (const Field& f : fields)
        if (f.components < 1 || f.values.size() != count * static_cast<std::size_t>(f.components))
            throw RunError(fmt::format("{}: field {} has {} values; expected {} x {}", file.string(), f.name,
                                       f.values.size(), count, f.components));
}

/// VTKHDF 1.0: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html, UnstructuredGrid with one vertex
/// cell per particle. The PolyData type is read by neither VTK 9.1 nor ParaView 5.11.
std::string particle_bytes(double time, const std::vector<Vec3>& points, const std::vector<Field>& fields) {
    constexpr unsigned char vertex = 1;  // VTK_VERTEX
    const std::size_t n = points.size();
    const h5::Handle file = h5::create_in_memory();
    const h5::Handle root = h5::create_group(file, "VTKHDF");
    const std::array<long long, 2> version{1, 0};
    h5::write_attribute(root, "Version", version);
    h5::write_attribute(root, "Type", "UnstructuredGrid");

    const std::vector<long long> count{static_cast<long long>(n)};
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
        h5::write_vector(root, name, H5T_NATIVE_LLONG, count, false);
    std::vector<float> coordinates(3 * n);
    std::vector<long long> connectivity(n), offsets(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            coordinates[3 * i + k] = static_cast<float>(points[i][static_cast<Eigen::Index>(k)]);
        connectivity[i] = static_cast<long long>(i);
        offsets[i + 1] = static_cast<long long>(i + 1);
    }
    const std::array<hsize_t, 2> dims{n, 3};
    h5::write_array(root, "Points", H5T_NATIVE_FLOAT, coordinates.data(), dims, true);
    h5::write_vector(root, "Connectivity", H5T_NATIVE_LLONG, connectivity);
    h5::write_vector(root, "Offsets", H5T_NATIVE_LLONG, offsets);
    h5::write_vector(root, "Types", H5T_NATIVE_UCHAR, std::vector<unsigned char>(n, vertex));

    const h5::Handle point_data = h5::create_group(root, "PointData");
    for (const Field& f : fields) {
        if (f.components == 1) {
            h5::write_vector(point_data, f.name.c_str(), H5T_NATIVE_FLOAT, f.values);
        } else {
            const std::array<hsize_t, 2> field_dims{n, static_cast<hsize_t>(f.components)};
            h5::write_array(point_data, f.name.c_str(), H5T_NATIVE_FLOAT, f.values.data(), field_dims, true);
        }
    }
    const h5::Handle field_data = h5::create_group(root, "FieldData");
    h5::write_vector(field_data, "TimeValue", H5T_NATIVE_DOUBLE, std::vector<double>{time}, false);
    return h5::image(file);
}

}  // namespace

void write_particles(const fs::path& file, double time, const std::vector<Vec3>& points,
                     const std::vector<Field>& fields) {
    check_fields(file, fields, points.size());
    const h5::Silence silence;
    std::string bytes;
    try {
        bytes = particle_bytes(time, points, fields);
    } catch (const h5::Failure& f) { throw RunError(file.string() + ": cannot be written: HDF5 failed at " + f.what); }
    write_text_atomically(file, bytes);
}

void write_surface(const fs::path& file, const Surface& surface, const std::vector<Field>& cell_fields) {
    check_fields(file, cell_fields, surface.triangles.size());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(surface.points.size()));
    for (std::size_t i = 0; i < surface.points.size(); ++i)
        points->SetPoint(static_cast<vtkIdType>(i), surface.points[i].data());
    vtkNew<vtkCellArray> cells;
    for (const auto& t : surface.triangles) {
        const vtkIdType corners[3] = {t[0], t[1], t[2]};
        cells->InsertNextCell(3, corners);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    for (const Field& f : cell_fields) {
        vtkNew<vtkFloatArray> array;
        array->SetName(f.name.c_str());
        array->SetNumberOfComponents(f.components);
        array->SetNumberOfTuples(static_cast<vtkIdType>(surface.triangles.size()));
        std::copy(f.values.begin(), f.values.end(), array->GetPointer(0));
        data->GetCellData()->AddArray(array);
    }
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetDataModeToBinary();
    writer->SetWriteToOutputString(true);
    if (!writer->Write()) throw RunError(file.string() + ": the surface cannot be turned into a .vtp file");
    write_text_atomically(file, writer->GetOutputString());
}

std::vector<std::pair<std::string, double>> read_series(const fs::path& file) {
    std::vector<std::pair<std::string, double>> series;
    try {
        const auto content = nlohmann::json::parse(read_text(file));
        for (const auto& entry : content.at("files")) {
            const std::string name = entry.at("name");
            const double time = entry.at("time");
            if (!name.empty() && fs::path(name).filename() == name) series.emplace_back(name, time);
        }
    } catch (const nlohmann::json::exception&) {}  // not ours
    return series;
}

void write_series(const fs::path& file, const std::vector<std::pair<std::string, double>>& files_and_times) {
    nlohmann::ordered_json series;
    series["file-series-version"] = "1.0";
    series["files"] = nlohmann::ordered_json::array();
    for (const auto& [name, time] : files_and_times) series["files"].push_back({{"name", name}, {"time", time}});
    write_text_atomically(file, series.dump(1) + "\n");
}

}  // namespace tw
