#include "structure/read_vtu.h"

#include <fmt/format.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "meshes/read/precheck.h"
#include "meshes/read/vtk_arrays.h"
#include "structure/mesh_builder.h"

namespace tw::structure {

namespace {

vtkSmartPointer<vtkPointSet> read_grid(const std::filesystem::path& file) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
}

}  // namespace

MeshFile read_vtu(const std::filesystem::path& file, double metres_per_unit) {
    const auto refuse = [&](const std::string& why) { throw InputError(fmt::format("{}: {}", file.string(), why)); };
    check_vtk_xml(file, read_text(file), "UnstructuredGrid");
    VtkArrays grid;
    try {
        grid = read_by_vtk([&] { return read_grid(file); }, true);
    } catch (const InputError& e) { refuse(std::string("cannot be read: ") + e.what()); }
    MeshBuilder mesh;
    for (std::size_t n = 0; 3 * n < grid.points.size(); ++n) {
        const Vec3 place = metres_per_unit * grid.point(n);
        if (!place.allFinite()) refuse(fmt::format("point {} has a place that is no number", n));
        mesh.add_node(static_cast<int>(n), place);
    }
    for (const VtkArrays::Values& v : grid.values) {
        if (!v.of_points || v.components != 1) continue;
        for (std::size_t n = 0; n < v.values.size(); ++n)
            if (v.values[n] != 0) mesh.set(v.name).push_back(static_cast<int>(n));
    }
    for (std::size_t c = 0; c < grid.count(); ++c) {
        const auto corners = grid.cell(c);
        const int number = static_cast<int>(c), type = grid.types[c];
        std::array<int, 8> at{};
        if (type != VTK_QUAD && type != VTK_HEXAHEDRON)
            refuse(fmt::format("element {} is a cell of type {}; expected quadrilaterals ({}) or hexahedra ({})", c,
                               type, static_cast<int>(VTK_QUAD), static_cast<int>(VTK_HEXAHEDRON)));
        if (corners.size() != (type == VTK_QUAD ? 4 : at.size()))
            refuse(fmt::format("element {} has {} corners; expected {}", c, corners.size(),
                               type == VTK_QUAD ? 4 : at.size()));
        std::ranges::transform(corners, at.begin(), [](std::int64_t id) { return static_cast<int>(id); });
        if (type == VTK_QUAD)
            mesh.add_quad(number, {at[0], at[1], at[2], at[3]});
        else
            mesh.add_hexahedron(number, at, "");
    }
    if (!mesh.has_elements()) refuse("no cells in this file; expected quadrilaterals or hexahedra");
    return mesh.finish();
}

}  // namespace tw::structure
