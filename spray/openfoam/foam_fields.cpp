#include "spray/openfoam/foam_fields.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>

#include <algorithm>
#include <charconv>

#include "base/errors.h"

namespace tw::spray {
namespace fs = std::filesystem;

FoamFields::FoamFields(const fs::path& folder, double time, At at) : folder_(folder), time_(time), at_(at) {
    const std::string control = (folder / "system" / "controlDict").string();
    reader_->SetFileName(control.c_str());
    reader_->SetSkipZeroTime(false);
    reader_->SetCreateCellToPoint(at == At::points);
    reader_->SetDecomposePolyhedra(at == At::points);
    reader_->SetCacheMesh(false);
    reader_->UpdateInformation();
    reader_->SetTimeValue(time);
    reader_->EnableAllCellArrays();
    reader_->Update();
    auto* blocks = reader_->GetOutput();
    if (blocks && blocks->GetNumberOfBlocks() > 0) grid_ = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(0));
    if (!grid_ || grid_->GetNumberOfCells() == 0)
        throw InputError(
            fmt::format("{}: no mesh to read at {:g} s; expected an OpenFOAM case", folder.string(), time));
}

vtkDataArray& FoamFields::field(const char* name, int components) const {
    vtkDataSetAttributes* fields = grid_->GetCellData();
    vtkIdType count = grid_->GetNumberOfCells();
    if (at_ == At::points) fields = grid_->GetPointData(), count = grid_->GetNumberOfPoints();
    vtkDataArray* array = fields->GetArray(name);
    if (!array || array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != count)
        throw InputError(
            fmt::format("{}: field {} is not there at {:g} s, or not on all cells; expected {} in its "
                        "time folder",
                        folder_.string(), name, time_, components == 3 ? "a vector" : "a scalar"));
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
