#include "foam_cases/read/hull_patch.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>

#include "meshes/query.h"
#include "record/wetted_line.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

/// VTK prints about broken files; here they are an expected end of a killed solver.
struct QuietVtk {
    const int before = vtkObject::GetGlobalWarningDisplay();
    QuietVtk() { vtkObject::GlobalWarningDisplayOff(); }
    ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before); }
};

template <class Reader>
vtkSmartPointer<vtkPolyData> read_with(const fs::path& file) {
    const QuietVtk quiet;
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetErrorCode() == 0 ? reader->GetOutput() : nullptr;
}

vtkSmartPointer<vtkPolyData> read_poly_data(const fs::path& folder, const std::string& name) {
    const fs::path xml = folder / (name + ".vtp"), legacy = folder / (name + ".vtk");
    if (fs::exists(xml)) return read_with<vtkXMLPolyDataReader>(xml);
    if (fs::exists(legacy)) return read_with<vtkPolyDataReader>(legacy);
    return nullptr;
}

}  // namespace

std::optional<HullPatch> read_hull_patch(const fs::path& folder, const std::string& name) {
    const vtkSmartPointer<vtkPolyData> data = read_poly_data(folder, name);
    if (!data || data->GetNumberOfPolys() == 0) return std::nullopt;
    vtkCellData* cells = data->GetCellData();
    vtkDataArray* p = cells->GetArray("p");
    vtkDataArray* alpha = cells->GetArray("alpha.water");
    vtkDataArray* shear = cells->GetArray("wallShearStress");
    if (p == nullptr || alpha == nullptr) return std::nullopt;

    HullPatch patch;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
        const double* x = data->GetPoint(i);
        patch.surface.points.emplace_back(x[0], x[1], x[2]);
    }
    const auto polygons = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
    vtkIdType face_number = 0;
    for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell(), ++face_number) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        polygons->GetCurrentCell(count, ids);
        const auto point = [&](vtkIdType k) -> const Vec3& {
            return patch.surface.points[static_cast<std::size_t>(ids[k % count])];
        };
        HullPatch::Face face;
        Vec3 middle = Vec3::Zero();
        for (vtkIdType k = 0; k < count; ++k) middle += point(k) / static_cast<double>(count);
        double weight = 0;
        for (vtkIdType k = 0; k < count; ++k) {  // a fan round the middle: exact area vector, area-weighted centre
            const Vec3 part = 0.5 * (point(k) - middle).cross(point(k + 1) - middle);
            face.area += part;
            face.centre += part.norm() * (point(k) + point(k + 1) + middle) / 3;
            weight += part.norm();
        }
        face.centre = weight > 0 ? Vec3(face.centre / weight) : middle;
        face.pressure = p->GetTuple1(face_number);
        face.water = std::clamp(alpha->GetTuple1(face_number), 0.0, 1.0);
        if (shear != nullptr) face.shear = Vec3(shear->GetTuple3(face_number));
        for (vtkIdType k = 1; k + 1 < count; ++k) {  // turned round: out of the hull
            patch.surface.triangles.push_back(
                {static_cast<int>(ids[0]), static_cast<int>(ids[k + 1]), static_cast<int>(ids[k])});
            patch.face_of_triangle.push_back(static_cast<int>(face_number));
        }
        patch.faces.push_back(face);
    }
    return patch;
}

Suction suction(const HullPatch& patch) {
    Suction s;
    for (const HullPatch::Face& f : patch.faces) {
        if (f.water <= 0.5 || f.pressure >= 0) continue;
        s.area += f.area.norm();
        s.force -= f.pressure * f.area.norm();
    }
    return s;
}

double mesh_error(const HullPatch& patch, const Surface& hull, double y_min, double z_max) {
    const SurfaceQuery query(patch.surface);
    double error = 0;
    for (const Vec3& p : hull.points)
        if (p.y() >= y_min && p.z() <= z_max) error = std::max(error, std::abs(query.nearest(p).distance));
    return error;
}

WaterLoad water_load(const HullPatch& patch, double density, double density_air, const Vec3& reference) {
    WaterLoad load;
    double half_beam = 0, looking_down = 0, water_below = 0;
    for (const auto& f : patch.faces) half_beam = std::max(half_beam, std::abs(f.centre.y()));
    WettedLine line(2 * half_beam);
    for (const auto& f : patch.faces) {
        const double area = f.area.norm();
        const Vec3 pressing = f.pressure * f.area;
        // wallShearStress is the wall's kinematic stress on the fluid; on the hull it acts the other way.
        const Vec3 mixture = -(f.water * density + (1 - f.water) * density_air) * area * f.shear;
        if (f.water > 0.05) {
            load.pressure += pressing;
            load.viscous_mixture += mixture;
            load.moment += (f.centre - reference).cross(pressing);
            if (f.area.z() > 0.3 * area) {  // area points into the hull: up where the hull looks down
                looking_down += area;
                water_below += area * f.water;
            }
        } else {
            load.air += pressing + mixture;
        }
        if (f.water > 0.5) {
            const Vec3 friction = -density * area * f.shear;
            load.viscous += friction;
            load.moment += (f.centre - reference).cross(friction);
            load.wetted_area += area;
            line.add_wet(f.centre);
        }
    }
    load.wetted_length = line.longest();
    load.ventilation = looking_down > 0 ? 1 - water_below / looking_down : 0;
    return load;
}

}  // namespace tw
