#include "compare/report/view3d.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <stdexcept>

#include "compare/report/escape.h"
#include "meshes/part_of.h"
#include "record/vtk_surface.h"

namespace tw {

namespace {

constexpr std::size_t most_points = 65536;  ///< that 16 bits number

/// Differences of 16-bit numbers, as they are stored.
void append_row(std::string& bytes, const std::vector<std::uint16_t>& numbers) {
    std::string low, high;
    std::uint16_t before = 0;
    for (const std::uint16_t number : numbers) {
        const auto change = static_cast<std::int16_t>(static_cast<std::uint16_t>(number - before));
        const auto folded = static_cast<std::uint16_t>((change << 1) ^ (change >> 15));
        low += static_cast<char>(folded & 255);
        high += static_cast<char>(folded >> 8);
        before = number;
    }
    bytes += low + high;
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string out(size, '\0');
    const int state = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
    if (state != Z_OK) throw std::bad_alloc();  // all else is room enough
    out.resize(size);
    return out;
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
    const auto fits = [&] { return light.triangles.size() <= most && light.points.size() <= most_points; };
    if (fits()) return light;
    // Points in one cell of a lattice become one, where the planes of their triangles meet: chines stay sharp. Linear
    // in the number of triangles, which may be millions.
    double area = 0;
    for (int t = 0; t < static_cast<int>(light.triangles.size()); ++t) area += 0.5 * light.area_vector2(t).norm();
    const auto data = poly_data_of(light);
    double cell = std::max(std::sqrt(area / static_cast<double>(most)), 1e-3 * length);
    for (; !fits(); cell *= 1.2) {
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

void SurfacePack::add(const Surface& surface) {
    if (surface.points.size() > most_points) throw std::length_error("more points than 16 bits can number");
    points_.push_back(surface.points.size());
    triangles_.push_back(surface.triangles.size());
    std::vector<std::uint16_t> row(surface.points.size());
    for (int axis = 0; axis < 3; ++axis) {
        const double edge = box_.size()[axis];
        std::ranges::transform(surface.points, row.begin(), [&](const Vec3& p) {
            const double share = edge > 0 ? (p[axis] - box_.min[axis]) / edge : 0;
            return static_cast<std::uint16_t>(std::lround(steps_ * std::clamp(share, 0.0, 1.0)));
        });
        append_row(places_, row);
    }
    row.clear();
    for (const auto& t : surface.triangles)
        for (const int corner : t) row.push_back(static_cast<std::uint16_t>(corner));
    append_row(corners_, row);
}

std::string SurfacePack::block() const { return base64(deflated(places_ + corners_)); }

}  // namespace tw
