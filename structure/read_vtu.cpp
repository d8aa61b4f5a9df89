#include "structure/read_vtu.h"

#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "base/errors.h"
#include "structure/mesh_builder.h"

namespace tw::structure {

MeshFile read_vtu(const std::filesystem::path& file, double metres_per_unit) {
    const auto refuse = [&](const std::string& why) { throw InputError(fmt::format("{}: {}", file.string(), why)); };
    const int warnings = vtkObject::GetGlobalWarningDisplay();
    vtkObject::GlobalWarningDisplayOff();
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    const bool known = reader->CanReadFile(file.c_str()) != 0;
    reader->SetFileName(file.c_str());
    if (known) reader->Update();
    vtkObject::SetGlobalWarningDisplay(warnings);
    vtkUnstructuredGrid* grid = reader->GetOutput();
    if (!known || reader->GetErrorCode() != 0 || grid->GetNumberOfPoints() == 0)
        refuse("VTK cannot read it as an unstructured grid, or it has no points; expected a whole .vtu file");
    MeshBuilder mesh;
    for (vtkIdType n = 0; n < grid->GetNumberOfPoints(); ++n) {
        const double* x = grid->GetPoint(n);
        const Vec3 place = metres_per_unit * Vec3(x[0], x[1], x[2]);
        if (!place.allFinite()) refuse(fmt::format("point {} has a place that is no number", n));
        mesh.add_node(static_cast<int>(n), place);
    }
    for (int a = 0; a < grid->GetPointData()->GetNumberOfArrays(); ++a) {
        vtkDataArray* values = grid->GetPointData()->GetArray(a);
        if (!values || !values->GetName() || values->GetNumberOfComponents() != 1) continue;
        for (vtkIdType n = 0; n < values->GetNumberOfTuples(); ++n)
            if (values->GetTuple1(n) != 0) mesh.set(values->GetName()).push_back(static_cast<int>(n));
    }
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
        vtkCell* cell = grid->GetCell(c);
        const auto corner = [&](std::size_t k) { return static_cast<int>(cell->GetPointId(static_cast<int>(k))); };
        const int number = static_cast<int>(c);
        if (cell->GetCellType() == VTK_QUAD)
            mesh.add_quad(number, {corner(0), corner(1), corner(2), corner(3)});
        else if (cell->GetCellType() == VTK_HEXAHEDRON)
            mesh.add_hexahedron(
                number, {corner(0), corner(1), corner(2), corner(3), corner(4), corner(5), corner(6), corner(7)}, "");
        else
            refuse(fmt::format("element {} is a cell of type {}; expected quadrilaterals ({}) or hexahedra ({})", c,
                               cell->GetCellType(), static_cast<int>(VTK_QUAD), static_cast<int>(VTK_HEXAHEDRON)));
    }
    if (!mesh.has_elements()) refuse("no cells in this file; expected quadrilaterals or hexahedra");
    return mesh.finish();
}

}  // namespace tw::structure
