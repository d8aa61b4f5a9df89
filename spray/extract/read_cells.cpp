#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <charconv>

#include <cmath>
#include <optional>

#include "base/errors.h"
#include "spray/extract/read_frames.h"

namespace tw::spray {
namespace fs = std::filesystem;
namespace {

fs::path case_of(const fs::path& run) { return fs::is_directory(run / "case") ? run / "case" : run; }

std::optional<double> time_of(const std::string& name) {
    double time = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), time);
    if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
    return time;
}

/// The cell fields of one time; names that the reader gives.
vtkUnstructuredGrid* read_time(vtkOpenFOAMReader& reader, const fs::path& folder, double time) {
    const std::string control = (folder / "system" / "controlDict").string();
    reader.SetFileName(control.c_str());
    reader.SetSkipZeroTime(false);
    reader.SetCreateCellToPoint(false);
    reader.SetDecomposePolyhedra(false);
    reader.SetCacheMesh(false);
    reader.UpdateInformation();
    reader.SetTimeValue(time);
    reader.EnableAllCellArrays();
    reader.Update();
    auto* blocks = reader.GetOutput();
    auto* grid =
        blocks && blocks->GetNumberOfBlocks() > 0 ? vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(0)) : nullptr;
    if (!grid || grid->GetNumberOfCells() == 0)
        throw InputError(
            fmt::format("{}: no mesh to read at {:g} s; expected an OpenFOAM case", folder.string(), time));
    return grid;
}

vtkDataArray& field(vtkUnstructuredGrid& grid, const char* name, int components, const fs::path& folder, double time) {
    vtkDataArray* array = grid.GetCellData()->GetArray(name);
    if (!array || array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != grid.GetNumberOfCells())
        throw InputError(
            fmt::format("{}: field {} is not there at {:g} s, or not on all cells", folder.string(), name, time));
    return *array;
}

}  // namespace

std::vector<FrameFile> foam_frames(const fs::path& run, const FrameRange& range) {
    const fs::path folder = case_of(run);
    if (!fs::exists(folder / "system" / "controlDict"))
        throw InputError(run.string() + ": no OpenFOAM case there; expected RUN/fvm or the folder of a case");
    std::vector<FrameFile> frames;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto time = time_of(entry.path().filename().string());
        if (!time || *time == 0 || !fs::exists(entry.path() / "alpha.water") || !fs::exists(entry.path() / "U"))
            continue;
        if (*time >= range.from && *time <= range.to) frames.push_back({*time, entry.path()});
    }
    if (frames.empty())
        throw InputError(fmt::format("{}: no time between {:g} and {:g} s has alpha.water and U", folder.string(),
                                     range.from, range.to));
    std::ranges::sort(frames, {}, &FrameFile::time);
    return frames;
}

WaterFrame read_cells(const FrameFile& from, double least, double& left_out) {
    const fs::path folder = from.file.parent_path();
    vtkNew<vtkOpenFOAMReader> at_start, now;
    vtkUnstructuredGrid& mesh = *read_time(*at_start, folder, 0);
    vtkDataArray &centre = field(mesh, "C", 3, folder, 0), &volume = field(mesh, "V", 1, folder, 0);
    vtkUnstructuredGrid& state = *read_time(*now, folder, from.time);
    vtkDataArray &alpha = field(state, "alpha.water", 1, folder, from.time),
                 &u = field(state, "U", 3, folder, from.time);
    if (mesh.GetNumberOfCells() != state.GetNumberOfCells())
        throw InputError(folder.string() + ": its mesh changes with time, which is not read here");
    WaterFrame frame;
    frame.time = from.time;
    for (vtkIdType i = 0; i < mesh.GetNumberOfCells(); ++i) {
        const double share = std::clamp(alpha.GetTuple1(i), 0.0, 1.0), cell = volume.GetTuple1(i);
        if (!(cell > 0)) throw InputError(folder.string() + ": a cell without volume in field V");
        if (share < least) {
            left_out += share * cell;
            continue;
        }
        Element e;
        centre.GetTuple(i, e.place.data());
        u.GetTuple(i, e.velocity.data());
        e.volume = share * cell;
        e.size = std::cbrt(cell);
        frame.elements.push_back(e);
    }
    return frame;
}

}  // namespace tw::spray
