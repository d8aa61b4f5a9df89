#include "meshes/read/cad.h"

#include <dlfcn.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/errors.h"
#include "base/trial.h"
#include "meshes/read/cut_drawing.h"
#include "meshes/read/vtk_arrays.h"

namespace tw {
namespace {

/// A function of the library that reads drawings. Throws InputError where it, or one of Open CASCADE's that it needs,
/// is not there.
template <class Function>
Function* in_library(const char* name) {
    void* const library =
        dlopen("libtwinwake_drawings.so", RTLD_NOW | RTLD_LOCAL);  // beside the program, by its RUNPATH
    auto* const function = library != nullptr ? reinterpret_cast<Function*>(dlsym(library, name)) : nullptr;
    if (function == nullptr)
        throw InputError(
            "this program has no Open CASCADE, which reads STEP and IGES; export the hull as STL, or "
            "install libocct-data-exchange-dev and build again");
    return function;
}

/// As a fault of input, whatever the library says.
void in_words(auto work) {
    try {
        work();
    } catch (const std::runtime_error& e) { throw InputError(e.what()); }
}

/// With the file's name before it.
auto of_file(const std::filesystem::path& file, auto read) {
    try {
        return read();
    } catch (const InputError& e) { throw InputError(file.string() + ": cannot be read: " + e.what()); }
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

std::vector<SolidNames> names_from(const std::filesystem::path& readable) {
    std::vector<SolidNames> names;
    const auto name_solids = in_library<decltype(tw_name_solids)>("tw_name_solids");
    in_words([&] { name_solids(readable.c_str(), &names); });
    return names;
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_cad(const std::filesystem::path& file, const std::filesystem::path& readable,
                                      bool iges, const std::string& solid) {
    const auto read = [&]() -> vtkSmartPointer<vtkPointSet> {
        CutDrawing drawing;
        const auto cut = in_library<decltype(tw_cut_drawing)>("tw_cut_drawing");
        in_words([&] { cut(readable.c_str(), iges, cad_chord, 12 * std::numbers::pi / 180, solid.c_str(), &drawing); });
        return surface_of(drawing);
    };
    const auto surface = of_file(file, [&] { return surface_of(read_by_vtk(read, true)); });
    if (surface->GetNumberOfPolys() == 0)
        throw InputError(file.string() + ": " + no_such_solid(solid, solids_in_step(file, readable)));
    return surface;
}

/// As lines of names with tabs between them: no name has either.
std::vector<SolidNames> solids_in_step(const std::filesystem::path& file, const std::filesystem::path& readable) {
    const std::string lines = of_file(file, [&] {
        return answer_of_trial([&] {
            std::string text;
            for (const SolidNames& names : names_from(readable)) {
                for (const std::string& name : names) text += name + '\t';
                text += '\n';
            }
            return text;
        });
    });
    std::vector<SolidNames> solids(1);
    std::string name;
    for (const char c : lines) {
        if (c == '\t')
            solids.back().push_back(std::exchange(name, {}));
        else if (c == '\n')
            solids.emplace_back();
        else
            name += c;
    }
    solids.pop_back();
    return solids;
}

}  // namespace tw
