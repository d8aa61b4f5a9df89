#include "meshes/read/cad.h"

#include <dlfcn.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <numbers>
#include <string>

#include "base/errors.h"
#include "meshes/read/cut_drawing.h"
#include "meshes/read/vtk_arrays.h"

namespace tw {
namespace {

using Cut = decltype(&tw_cut_drawing);

/// Null: the library is not there, or one of Open CASCADE's that it needs.
Cut cutter() {
    void* const library =
        dlopen("libtwinwake_drawings.so", RTLD_NOW | RTLD_LOCAL);  // beside the program, by its RUNPATH
    return library != nullptr ? reinterpret_cast<Cut>(dlsym(library, "tw_cut_drawing")) : nullptr;
}

vtkSmartPointer<vtkPolyData> surface_of(const CutDrawing& drawing) {
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto triangles = vtkSmartPointer<vtkCellArray>::New();
    points->SetDataTypeToDouble();
    for (std::size_t n = 0; n < drawing.points.size(); n += 3) points->InsertNextPoint(&drawing.points[n]);
    for (std::size_t n = 0; n < drawing.corners.size(); n += 3) {
        const vtkIdType corners[] = {drawing.corners[n], drawing.corners[n + 1], drawing.corners[n + 2]};
        triangles->InsertNextCell(3, corners);
    }
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    return surface;
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_cad(const std::filesystem::path& file, const std::filesystem::path& readable,
                                      bool iges) {
    const auto read = [&]() -> vtkSmartPointer<vtkPointSet> {
        const Cut cut = cutter();
        if (cut == nullptr)
            throw InputError(
                "this program has no Open CASCADE, which reads STEP and IGES; export the hull as STL, or "
                "install libocct-data-exchange-dev and build again");
        CutDrawing drawing;
        try {
            cut(readable.c_str(), iges, cad_chord, 12 * std::numbers::pi / 180, &drawing);
        } catch (const std::exception& e) { throw InputError(e.what()); }
        return surface_of(drawing);
    };
    try {
        return surface_of(read_by_vtk(read, true));
    } catch (const InputError& e) { throw InputError(file.string() + ": cannot be read: " + e.what()); }
}

}  // namespace tw
