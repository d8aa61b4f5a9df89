#include "spray/openfoam/foam_fields.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkPointData.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/errors.h"
#include "meshes/read/vtk_arrays.h"

namespace tw::spray {
namespace fs = std::filesystem;

namespace {

/// Everything that the mesh and the fields of that time take on the disk [bytes].
double size_of(const fs::path& folder) {
    double bytes = 0;
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(folder, none))
        if (entry.is_regular_file(none)) bytes += static_cast<double>(entry.file_size(none));
    return bytes;
}

vtkSmartPointer<vtkPointSet> read(const fs::path& folder, double time, FoamFields::At at) {
    const bool points = at == FoamFields::At::points;
    vtkNew<vtkOpenFOAMReader> reader;
    reader->SetFileName((folder / "system" / "controlDict").c_str());
    reader->SetSkipZeroTime(false);
    reader->SetCreateCellToPoint(points);
    reader->SetDecomposePolyhedra(points);
    reader->SetCacheMesh(false);
    reader->UpdateInformation();
    reader->SetTimeValue(time);
    reader->EnableAllCellArrays();
    reader->Update();
    auto* blocks = reader->GetOutput();
    if (!blocks || blocks->GetNumberOfBlocks() == 0) return nullptr;
    return vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(0));
}

}  // namespace

FoamFields::FoamFields(const fs::path& folder, double time, At at) : folder_(folder), time_(time), at_(at) {
    double bytes = size_of(folder / "constant" / "polyMesh");
    for (const FoamTime& t : foam_times(folder))
        if (t.time == time) bytes += size_of(t.folder);
    constexpr double slowest = 1e6;                 // [bytes/s]; text is read some fifty times faster
    constexpr double slowest_of_a_processor = 1e7;  // [bytes/s]
    try {
        const VtkArrays arrays = read_by_vtk([&] { return read(folder, time, at); }, false,
                                             {.seconds = 20 + bytes / slowest,
                                              .processor = 2 + bytes / slowest_of_a_processor,
                                              .bytes = 4e9 + 50 * bytes});
        if (arrays.count() == 0) throw InputError("it has no cells");
        constexpr double farthest = 1e9;  // [m]
        for (const double x : arrays.points)
            if (!(std::abs(x) <= farthest)) throw InputError(fmt::format("a point at {:g} m", x));
        grid_ = grid_of(arrays);
        complaint_ = arrays.complaint;
    } catch (const InputError& e) {
        throw InputError(fmt::format("{}: no mesh to read at {:g} s: {}; expected an OpenFOAM case", folder.string(),
                                     time, e.what()));
    }
}

vtkDataArray* FoamFields::found(const char* name) const {
    vtkDataSetAttributes* fields = grid_->GetCellData();
    if (at_ == At::points) fields = grid_->GetPointData();
    return fields->GetArray(name);
}

vtkDataArray& FoamFields::field(const char* name, int components) const {
    const vtkIdType count = at_ == At::points ? grid_->GetNumberOfPoints() : grid_->GetNumberOfCells();
    vtkDataArray* array = found(name);
    if (!array || array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != count)
        throw InputError(
            fmt::format("{}: field {} is not there at {:g} s, or not on all cells; expected {} in its "
                        "time folder{}",
                        folder_.string(), name, time_, components == 3 ? "a vector" : "a scalar",
                        complaint_.empty() ? "" : "; VTK says: " + complaint_));
    return *array;
}

fs::path foam_case(const fs::path& run) {
    const fs::path folder = fs::is_directory(run / "case") ? run / "case" : run;
    if (!fs::exists(folder / "system" / "controlDict"))
        throw InputError(run.string() + ": no OpenFOAM case there; expected RUN/fvm or the folder of a case");
    return folder;
}

std::vector<FoamTime> foam_times(const fs::path& folder) {
    std::vector<FoamTime> times;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        double time = 0;
        const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), time);
        if (error == std::errc() && end == name.data() + name.size()) times.push_back({time, entry.path()});
    }
    std::ranges::sort(times, {}, &FoamTime::time);
    return times;
}

}  // namespace tw::spray
