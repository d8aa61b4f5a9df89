#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <new>
#include <utility>

#include "base/errors.h"
#include "meshes/axis_turn.h"
#include "meshes/read/cad.h"
#include "meshes/read/drawing_unit.h"
#include "meshes/read/named_solid.h"
#include "meshes/read/opened_surface.h"
#include "meshes/read/ply.h"
#include "meshes/read/precheck.h"
#include "meshes/read/stl.h"
#include "meshes/read/vtk_arrays.h"
#include "meshes/read/vtk_complaints.h"
#include "meshes/surface.h"

namespace tw {
namespace fs = std::filesystem;
namespace {

/// Edges of neighbouring faces are cut alike; what is left is rounding and the faces' own tolerance.
constexpr double metres_apart_in_drawings = 1e-6;

/// `file` is named in messages, `readable` is read: the file itself, or its unpacked content.
vtkSmartPointer<vtkPolyData> read_obj(const fs::path& file, const fs::path& readable) {
    vtkNew<vtkOBJReader> reader;
    const VtkComplaints complaints;
    reader->SetFileName(readable.c_str());
    try {
        reader->Update();
    } catch (const std::bad_alloc&) {
        throw InputError(file.string() +
                         ": cannot be read: its counts ask for more memory than there is; export the hull again");
    }
    if (const std::string first = complaints.first(); !first.empty())
        throw InputError(file.string() + ": cannot be read: " + first);
    vtkPolyData* data = reader->GetOutput();
    if (data == nullptr || data->GetNumberOfPoints() == 0)
        throw InputError(file.string() + ": holds no points; export the hull again");
    return data;
}

/// The readers pass the files' connectivity on unchecked.
void check_connectivity(const fs::path& file, vtkPolyData* data) {
    for (vtkCellArray* cells : {data->GetPolys(), data->GetStrips()}) {
        const vtkIdType points = data->GetNumberOfPoints();
        if (!cells->IsValid()) throw InputError(file.string() + ": its faces are inconsistent; export the hull again");
        for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
            vtkIdType n = 0;
            const vtkIdType* ids = nullptr;
            cells->GetCellAtId(c, n, ids);
            for (vtkIdType k = 0; k < n; ++k)
                if (ids[k] < 0 || ids[k] >= points)
                    throw InputError(file.string() + ": face " + std::to_string(c) + " uses point " +
                                     std::to_string(ids[k]) + " of " + std::to_string(points) +
                                     "; export the hull again");
        }
    }
}

Surface from_vtk(const fs::path& file, vtkPolyData* data) {
    check_connectivity(file, data);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->PassVertsOff();
    triangles->PassLinesOff();
    triangles->SetInputData(data);
    triangles->Update();
    vtkPolyData* cut = triangles->GetOutput();
    Surface surface;
    surface.points.resize(static_cast<std::size_t>(cut->GetNumberOfPoints()));
    for (std::size_t i = 0; i < surface.points.size(); ++i)
        cut->GetPoint(static_cast<vtkIdType>(i), surface.points[i].data());
    for (vtkIdType c = 0; c < cut->GetPolys()->GetNumberOfCells(); ++c) {
        vtkIdType n = 0;
        const vtkIdType* ids = nullptr;
        cut->GetPolys()->GetCellAtId(c, n, ids);
        if (n == 3)
            surface.triangles.push_back({static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2])});
    }
    return surface;
}

Surface read_vtp(const fs::path& file, const fs::path& readable) {
    const auto read = [&]() -> vtkSmartPointer<vtkPointSet> {
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(readable.c_str());
        vtkNew<vtkTriangleFilter> polygons;  // strips become polygons, too
        polygons->PassVertsOff();
        polygons->PassLinesOff();
        reader->Update();
        check_connectivity(file, reader->GetOutput());
        polygons->SetInputData(reader->GetOutput());
        polygons->Update();
        return polygons->GetOutput();
    };
    try {
        return from_vtk(file, surface_of(read_by_vtk(read, true)));
    } catch (const InputError& e) {
        const std::string fault = e.what();
        throw InputError(fault.starts_with(file.string()) ? fault : file.string() + ": cannot be read: " + fault);
    }
}

/// The corners that no triangle has, of the file's other solids, left out.
Surface without_unused_points(Surface surface) {
    std::vector<int> place(surface.points.size(), -1);
    std::vector<Vec3> points;
    for (auto& triangle : surface.triangles)
        for (int& corner : triangle) {
            int& to = place[static_cast<std::size_t>(corner)];
            if (to < 0)
                to = static_cast<int>(points.size()),
                points.push_back(surface.points[static_cast<std::size_t>(corner)]);
            corner = to;
        }
    surface.points = std::move(points);
    return surface;
}

Surface read_by_type(const fs::path& file, std::string_view unit, const std::string& name) {
    OpenedSurface opened = opened_surface(file);
    const std::string& type = opened.type;
    if (opened.drawing() && unit != "m")
        throw InputError(file.string() + ": names its own unit, " + unit_of_drawing(file) + ", and unit = \"" +
                         std::string(unit) + "\" is given beside it; leave the unit out");
    if (!name.empty() && !opened.names_solids())
        throw InputError(file.string() +
                         (type == ".stl" ? ": a binary STL file names no solids"
                                         : ": solids are not taken by name from this kind of file") +
                         "; leave #" + name + " out, or export the bodies as STEP, OBJ or ascii STL");
    if (opened.drawing())
        return welded(from_vtk(file, read_cad(file, opened.readable, opened.iges(), name)), metres_apart_in_drawings);
    if (type == ".obj") {
        if (!name.empty()) opened.go_on_with(only_named_in_obj(file, opened.content, name));
        check_obj(file, opened.content);
        Surface all = from_vtk(file, read_obj(file, opened.readable));
        return name.empty() ? all : without_unused_points(std::move(all));
    }
    if (type == ".ply") { return from_vtk(file, read_ply(file, opened.content)); }
    if (type == ".vtp") {
        check_vtk_xml(file, opened.content, "PolyData");
        return read_vtp(file, opened.readable);
    }
    if (!name.empty()) opened.content = only_named_in_stl(file, opened.content, name);
    return is_ascii_stl(opened.content) ? read_ascii_stl(file, opened.content) : read_binary_stl(file, opened.content);
}

}  // namespace

Surface read_surface(const fs::path& path, std::string_view unit, std::string_view axes) {
    const auto [file, name] = named_solid(path);
    if (name.empty() && file != path)
        throw InputError(path.string() + ": nothing stands behind #; expected the name of a solid in " + file.string());
    const double scale = metres_per(unit);
    const Eigen::Matrix3d turn = axis_turn(axes);
    Surface surface = welded(read_by_type(file, unit, name));
    if (surface.triangles.empty())
        throw InputError(file.string() + ": holds no triangles; export the hull as a surface mesh");
    for (Vec3& p : surface.points) {
        if (!p.allFinite())
            throw InputError(file.string() +
                             ": a corner is not a finite number (NaN or infinite); export the hull again");
        p *= scale;
    }
    turn_axes(surface, turn);
    return surface;
}

}  // namespace tw
