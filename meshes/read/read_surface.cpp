#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <new>
#include <optional>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "meshes/axis_turn.h"
#include "meshes/read/cad.h"
#include "meshes/read/drawing_unit.h"
#include "meshes/read/gzip.h"
#include "meshes/read/named_solid.h"
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

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Length of the mark with which editors begin a text in UTF-8, 0 where there is none; UTF-16 is refused. A binary STL may
/// begin with any bytes.
std::size_t byte_order_mark(const fs::path& file, const std::string& type, const std::string& content) {
    if (type == ".stl" && is_binary_stl(content)) return 0;
    if (content.starts_with("\xFF\xFE") || content.starts_with("\xFE\xFF"))
        throw InputError(
            file.string() +
            ":1: begins with the byte order mark of UTF-16; expected plain text: save it as UTF-8 or ASCII, "
            "or export the hull again");
    return content.starts_with("\xEF\xBB\xBF") ? 3 : 0;
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
    const bool packed = lower_case(file.extension().string()) == ".gz";
    const std::string type = lower_case((packed ? file.stem() : file.filename()).extension().string());
    const bool iges = type == ".igs" || type == ".iges", drawing = iges || type == ".stp" || type == ".step";
    const bool known = drawing || type == ".stl" || type == ".obj" || type == ".ply" || type == ".vtp";
    if (!known)
        throw InputError(file.string() +
                         ": surfaces are read from .stl, .obj, .ply, .vtp, .step and .iges files (also compressed, as "
                         ".stl.gz), not from \"" +
                         type + (packed ? ".gz\"" : "\""));
    std::error_code error;
    if (!fs::exists(file, error)) throw InputError(file.string() + ": no such file; check the name and the folder");
    if (!fs::is_regular_file(file, error)) throw InputError(file.string() + ": is not a file");
    if (drawing && unit != "m")
        throw InputError(file.string() + ": names its own unit, " + unit_of_drawing(file) + ", and unit = \"" +
                         std::string(unit) + "\" is given beside it; leave the unit out");
    constexpr std::uintmax_t largest = 4'000'000'000;  // 80 million STL triangles; indices are 32 bit
    if (fs::file_size(file, error) > largest)
        throw InputError(file.string() + ": larger than 4 GB; coarsen the surface first");
    std::string content = read_text(file);
    if (content.empty()) throw InputError(file.string() + ": the file is empty; export the hull again");

    fs::path readable = file;
    std::optional<MemoryFile> memory;
    if (packed) {
        // Text of surfaces shrinks to a tenth, of very regular ones to a fiftieth; what grows a thousandfold is no
        // hull.
        content = unpacked(file, content, std::min<std::size_t>(largest, 200 * content.size() + 1'000'000));
        if (content.empty()) throw InputError(file.string() + ": nothing is in it; export the hull again");
        readable = memory.emplace(content).path();
    }
    if (const std::size_t mark = byte_order_mark(file, type, content); mark > 0) {
        content.erase(0, mark);
        readable = memory.emplace(content).path();
    }
    if (!name.empty() && (drawing || type == ".ply" || type == ".vtp" || (type == ".stl" && !is_ascii_stl(content))))
        throw InputError(file.string() +
                         (type == ".stl" ? ": a binary STL file names no solids"
                                         : ": solids are not taken by name from this kind of file") +
                         "; leave #" + name + " out, or export the bodies as OBJ or ascii STL");
    if (type == ".obj") {
        if (!name.empty()) {
            content = only_named_in_obj(file, content, name);
            readable = memory.emplace(content).path();
            check_obj(file, content);
            return without_unused_points(from_vtk(file, read_obj(file, readable)));
        }
        check_obj(file, content);
        return from_vtk(file, read_obj(file, readable));
    }
    if (type == ".ply") { return from_vtk(file, read_ply(file, content)); }
    if (drawing) return welded(from_vtk(file, read_cad(file, readable, iges)), metres_apart_in_drawings);
    if (type == ".vtp") {
        check_vtk_xml(file, content, "PolyData");
        return read_vtp(file, readable);
    }
    if (!name.empty()) content = only_named_in_stl(file, content, name);
    return is_ascii_stl(content) ? read_ascii_stl(file, content) : read_binary_stl(file, content);
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
