#include "foam_cases/read/hull_patch.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "meshes/query.h"
#include "meshes/read/vtk_arrays.h"
#include "record/wetted_line.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

template <class Reader>
vtkSmartPointer<vtkPointSet> read_with(const fs::path& file) {
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetErrorCode() == 0 ? reader->GetOutput() : nullptr;
}

/// Broken files are an expected end of a killed solver.
std::optional<VtkArrays> read_poly_data(const fs::path& folder, const std::string& name) {
    const fs::path xml = folder / (name + ".vtp"), legacy = folder / (name + ".vtk");
    try {
        if (fs::exists(xml)) return read_by_vtk([&] { return read_with<vtkXMLPolyDataReader>(xml); }, false);
        if (fs::exists(legacy)) return read_by_vtk([&] { return read_with<vtkPolyDataReader>(legacy); }, false);
    } catch (const InputError&) {}
    return std::nullopt;
}

}  // namespace

std::optional<HullPatch> read_hull_patch(const fs::path& folder, const std::string& name) {
    const std::optional<VtkArrays> data = read_poly_data(folder, name);
    if (!data || data->count() == 0) return std::nullopt;
    const auto *p = data->find("p", false, 1), *alpha = data->find("alpha.water", false, 1),
               *shear = data->find("wallShearStress", false, 3);
    if (p == nullptr || alpha == nullptr) return std::nullopt;

    HullPatch patch;
    for (std::size_t i = 0; 3 * i < data->points.size(); ++i) patch.surface.points.push_back(data->point(i));
    for (std::size_t face_number = 0; face_number < data->count(); ++face_number) {
        const auto ids = data->cell(face_number);
        const std::size_t count = ids.size();
        const auto point = [&](std::size_t k) -> const Vec3& {
            return patch.surface.points[static_cast<std::size_t>(ids[k % count])];
        };
        HullPatch::Face face;
        Vec3 middle = Vec3::Zero();
        for (std::size_t k = 0; k < count; ++k) middle += point(k) / static_cast<double>(count);
        double weight = 0;
        for (std::size_t k = 0; k < count; ++k) {  // a fan round the middle: exact area vector, area-weighted centre
            const Vec3 part = 0.5 * (point(k) - middle).cross(point(k + 1) - middle);
            face.area += part;
            face.centre += part.norm() * (point(k) + point(k + 1) + middle) / 3;
            weight += part.norm();
        }
        face.centre = weight > 0 ? Vec3(face.centre / weight) : middle;
        face.pressure = (*p)[face_number];
        face.water = std::clamp((*alpha)[face_number], 0.0, 1.0);
        if (shear != nullptr) face.shear = Vec3(&(*shear)[3 * face_number]);
        for (std::size_t k = 1; k + 1 < count; ++k) {  // turned round: out of the hull
            patch.surface.triangles.push_back(
                {static_cast<int>(ids[0]), static_cast<int>(ids[k + 1]), static_cast<int>(ids[k])});
            patch.face_of_triangle.push_back(static_cast<int>(face_number));
        }
        patch.faces.push_back(face);
    }
    return patch;
}

WetWall wet_wall(const HullPatch& patch) {
    WetWall wall;
    for (const HullPatch::Face& f : patch.faces) wall.add(-f.area, f.pressure, f.water > 0.5, 1 - f.water);
    return wall;
}

double mesh_error(const HullPatch& patch, const Surface& hull, double y_min, double z_max) {
    const SurfaceQuery query(patch.surface);
    double error = 0;
    for (const Vec3& p : hull.points)
        if (p.y() >= y_min && p.z() <= z_max) error = std::max(error, std::abs(query.nearest(p).distance));
    return error;
}

WaterLoad& WaterLoad::operator+=(const WaterLoad& other) {
    pressure += other.pressure;
    viscous += other.viscous;
    viscous_mixture += other.viscous_mixture;
    air += other.air;
    moment += other.moment;
    return *this;
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
