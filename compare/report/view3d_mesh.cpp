#include "compare/report/view3d_mesh.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/metrics/raster_columns.h"
#include "compare/read/record_numbers.h"
#include "compare/report/base64.h"

namespace tw {

namespace {

/// Mean share of a block of voxels, 0..1; beyond the raster's end the last voxel is taken again.
float block_share(const RasterGrid& grid, const RasterFrame& frame, int edge, int i, int j, int k) {
    const int depth = grid.ny == 1 ? 1 : edge;
    int sum = 0;
    for (int c = k * edge; c < (k + 1) * edge; ++c)
        for (int b = j * depth; b < (j + 1) * depth; ++b)
            for (int a = i * edge; a < (i + 1) * edge; ++a)
                sum += frame.water[grid.voxel(std::min(a, grid.nx - 1), std::min(b, grid.ny - 1),
                                              std::min(c, grid.nz - 1))];
    return static_cast<float>(sum) / (255.0f * static_cast<float>(edge * depth * edge));
}

/// The raster as an image of point values; a half model gets its other side, so that nothing ends on y = 0.
vtkSmartPointer<vtkImageData> share_image(const RasterGrid& grid, const RasterFrame& frame, int edge, bool mirror) {
    const bool flat = grid.ny == 1;  // a two-dimensional run is drawn as a slab
    const auto blocks = [&](int n) { return (n + edge - 1) / edge; };
    const int nx = blocks(grid.nx), rows = flat ? 1 : blocks(grid.ny), nz = blocks(grid.nz);
    const int mirrored = mirror && !flat ? rows : 0, ny = flat ? 2 : rows + mirrored;
    const double d = edge * grid.spec.spacing;
    const Vec3 first = grid.spec.origin + Vec3::Constant(0.5 * d);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(nx, ny, nz);
    image->SetSpacing(d, flat ? 0.2 * grid.nx * grid.spec.spacing : d, d);
    image->SetOrigin(first.x(), flat ? grid.y(0) : mirrored ? -(first.y() + (rows - 1) * d) : first.y(), first.z());
    vtkNew<vtkFloatArray> share;
    share->SetNumberOfTuples(static_cast<vtkIdType>(nx) * ny * nz);
    vtkIdType n = 0;
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                const int row = flat ? 0 : j < mirrored ? mirrored - 1 - j : j - mirrored;
                share->SetValue(n++, block_share(grid, frame, edge, i, row, k));
            }
    image->GetPointData()->SetScalars(share);
    return image;
}

Surface surface_of(vtkPolyData* data) {
    Surface surface;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) surface.points.emplace_back(data->GetPoint(i));
    vtkNew<vtkIdList> corners;
    vtkCellArray* cells = data->GetPolys();
    for (cells->InitTraversal(); cells->GetNextCell(corners);)
        if (corners->GetNumberOfIds() == 3)
            surface.triangles.push_back({static_cast<int>(corners->GetId(0)), static_cast<int>(corners->GetId(1)),
                                         static_cast<int>(corners->GetId(2))});
    return surface;
}

vtkSmartPointer<vtkPolyData> poly_data_of(const Surface& surface) {
    vtkNew<vtkPoints> points;
    for (const Vec3& p : surface.points) points->InsertNextPoint(p.data());
    vtkNew<vtkCellArray> cells;
    for (const auto& t : surface.triangles) {
        const vtkIdType corners[3] = {t[0], t[1], t[2]};
        cells->InsertNextCell(3, corners);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

/// Leaves the triangles that `keep` wants and the points they use.
template <class Keep>
Surface filtered(const Surface& surface, const Keep& keep) {
    Surface kept;
    std::vector<int> number(surface.points.size(), -1);
    for (auto t : surface.triangles) {
        if (!keep(t)) continue;
        for (int& corner : t) {
            int& n = number[static_cast<std::size_t>(corner)];
            if (n < 0) {
                n = static_cast<int>(kept.points.size());
                kept.points.push_back(surface.points[static_cast<std::size_t>(corner)]);
            }
            corner = n;
        }
        kept.triangles.push_back(t);
    }
    return kept;
}

/// Low-pass filter of Taubin 1995 (doi:10.1145/218380.218473): each point goes a share `out` towards the mean of its
/// neighbours, then a little more back, so that nothing shrinks: steps of the voxels go, waves longer than a dozen
/// edges stay. Planes stay exactly, and so do points on the rim.
void smooth(Surface& surface) {
    constexpr double out = 0.5, back = -0.532;  // 1 / out + 1 / back: the pass band, 0.12
    constexpr int rounds = 12;
    std::vector<std::vector<int>> next(surface.points.size());  // along the triangles' edges, one way
    for (const auto& t : surface.triangles)
        for (std::size_t k = 0; k < 3; ++k) next[static_cast<std::size_t>(t[k])].push_back(t[(k + 1) % 3]);
    std::vector<bool> rim(surface.points.size());  // an edge that no other triangle runs back along
    for (std::size_t i = 0; i < next.size(); ++i)
        for (const int n : next[i])
            if (std::ranges::find(next[static_cast<std::size_t>(n)], static_cast<int>(i)) ==
                next[static_cast<std::size_t>(n)].end())
                rim[i] = rim[static_cast<std::size_t>(n)] = true;
    std::vector<Vec3> before;
    for (int step = 0; step < 2 * rounds; ++step) {
        before = surface.points;
        for (std::size_t i = 0; i < next.size(); ++i) {
            if (rim[i] || next[i].empty()) continue;
            Vec3 towards = Vec3::Zero();
            for (const int n : next[i]) towards += before[static_cast<std::size_t>(n)] - before[i];
            surface.points[i] += (step % 2 == 0 ? out : back) / static_cast<double>(next[i].size()) * towards;
        }
    }
}

/// The side y >= 0 of a surface that is its own mirror image. The strip across y = 0 runs straight along y, so its far
/// corners move onto the plane without a change of shape.
Surface own_side(const Surface& whole, double voxel) {
    const auto at = [&](int corner) { return whole.points[static_cast<std::size_t>(corner)].y(); };
    Surface half = filtered(whole, [&](const std::array<int, 3>& t) {
        return std::max({at(t[0]), at(t[1]), at(t[2])}) > 1e-6 * voxel;
    });
    for (Vec3& p : half.points) p.y() = std::max(p.y(), 0.0);
    return half;
}

void append16(std::string& bytes, unsigned value) {
    bytes += static_cast<char>(value & 255);
    bytes += static_cast<char>(value >> 8 & 255);
}

}  // namespace

Surface water_surface(const RunRecord& record, const RasterFrame& frame, int coarsening) {
    const RasterGrid grid(record.raster);
    if (grid.empty() || frame.water.size() != grid.voxels()) return {};
    const bool mirror = number_of_text(record, "symmetry_factor", 1) > 1;
    const auto image = share_image(grid, frame, coarsening, mirror);
    const int* size = image->GetDimensions();
    if (size[0] < 2 || size[1] < 2 || size[2] < 2) return {};
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(image);
    contour->SetValue(0, 0.5);
    contour->ComputeNormalsOff();
    contour->ComputeScalarsOff();
    contour->Update();
    if (contour->GetOutput()->GetNumberOfCells() == 0) return {};
    Surface surface = surface_of(contour->GetOutput());
    smooth(surface);
    return mirror && grid.ny > 1 ? own_side(surface, grid.spec.spacing) : surface;
}

Surface light_surface(const Surface& surface, std::size_t most) {
    const Surface finite = filtered(surface, [&](const std::array<int, 3>& t) {
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
