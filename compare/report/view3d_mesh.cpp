#include "compare/report/view3d_mesh.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/report/base64.h"
#include "meshes/part_of.h"
#include "record/vtk_surface.h"

namespace tw {

namespace {

void append16(std::string& bytes, unsigned value) {
    bytes += static_cast<char>(value & 255);
    bytes += static_cast<char>(value >> 8 & 255);
}

}  // namespace

Surface light_surface(const Surface& surface, std::size_t most) {
    const Surface finite = part_of(surface, [&](const std::array<int, 3>& t) {
        return std::ranges::all_of(
            t, [&](int corner) { return surface.points[static_cast<std::size_t>(corner)].allFinite(); });
    });
    const Box box = finite.bounds();
    const double length = box.size().maxCoeff();
    if (!std::isfinite(length)) return {};
    Surface light = welded(finite, 1e-6 * length);
    if (light.triangles.size() <= most) return light;
    // Points in one cell of a lattice become one, where the planes of their triangles meet: chines stay sharp. Linear
    // in the number of triangles, which may be millions.
    double area = 0;
    for (int t = 0; t < static_cast<int>(light.triangles.size()); ++t) area += 0.5 * light.area_vector2(t).norm();
    const auto data = poly_data_of(light);
    double cell = std::max(std::sqrt(area / static_cast<double>(most)), 1e-3 * length);
    for (; light.triangles.size() > most; cell *= 1.2) {
        const auto cells = [&](int axis) {
            return std::clamp(static_cast<int>(std::ceil(box.size()[axis] / cell)), 1, 500);
        };
        vtkNew<vtkQuadricClustering> cluster;
        cluster->SetInputData(data);
        cluster->AutoAdjustNumberOfDivisionsOff();
        cluster->SetNumberOfDivisions(cells(0), cells(1), cells(2));
        cluster->Update();
        light = welded(surface_of(cluster->GetOutput()));
    }
    return light;
}

std::string packed_points(const Surface& surface, const Box& box) {
    std::string bytes;
    bytes.reserve(6 * surface.points.size());
    for (const Vec3& p : surface.points)
        for (int axis = 0; axis < 3; ++axis) {
            const double edge = box.size()[axis], share = edge > 0 ? (p[axis] - box.min[axis]) / edge : 0;
            append16(bytes, static_cast<unsigned>(std::lround(65535 * std::clamp(share, 0.0, 1.0))));
        }
    return base64(bytes);
}

std::string packed_triangles(const Surface& surface) {
    if (surface.points.size() > 65536) throw std::length_error("more points than 16 bits can number");
    std::string bytes;
    bytes.reserve(6 * surface.triangles.size());
    for (const auto& t : surface.triangles)
        for (const int corner : t) append16(bytes, static_cast<unsigned>(corner));
    return base64(bytes);
}

}  // namespace tw
