#include <fmt/format.h>
#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "spray/extract/read_frames.h"
#include "spray/openfoam/foam_fields.h"

namespace tw::spray {
namespace fs = std::filesystem;

std::vector<FrameFile> foam_frames(const fs::path& run, const FrameRange& range) {
    const fs::path folder = foam_case(run);
    std::vector<FrameFile> frames;
    for (const FoamTime& t : foam_times(folder)) {
        if (t.time == 0 || !fs::exists(t.folder / "alpha.water") || !fs::exists(t.folder / "U")) continue;
        if (t.time >= range.from && t.time <= range.to) frames.push_back({t.time, t.folder});
    }
    if (frames.empty())
        throw InputError(fmt::format("{}: no time between {:g} and {:g} s has alpha.water and U", folder.string(),
                                     range.from, range.to));
    return frames;
}

WaterFrame read_cells(const FrameFile& from, double least, double& left_out) {
    const fs::path folder = from.file.parent_path();
    const FoamFields mesh(folder, 0, FoamFields::At::cells), state(folder, from.time, FoamFields::At::cells);
    // openfoam.org writes the volumes as Vc from 12 on
    vtkDataArray &centre = mesh.field("C", 3), &volume = mesh.field(mesh.has("Vc") ? "Vc" : "V", 1),
                 &alpha = state.field("alpha.water", 1), &u = state.field("U", 3);
    if (mesh.grid().GetNumberOfCells() != state.grid().GetNumberOfCells())
        throw InputError(folder.string() + ": its mesh changes with time, which is not read here");
    WaterFrame frame;
    frame.time = from.time;
    for (vtkIdType i = 0; i < mesh.grid().GetNumberOfCells(); ++i) {
        const double share = std::clamp(alpha.GetTuple1(i), 0.0, 1.0), cell = volume.GetTuple1(i);
        if (!(cell > 0)) throw InputError(folder.string() + ": a cell without volume");
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
