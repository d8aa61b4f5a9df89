#include "record/water_surface.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

#include "meshes/part_of.h"
#include "record/raster_grid.h"
#include "record/vtk_surface.h"

namespace tw {

namespace {

/// Mean share of a block of voxels, 0..1; beyond the raster's end the last voxel is taken again.
float block_share(const RasterGrid& grid, const RasterFrame& frame, int edge, int i, int j, int k) {
    const int depth = grid.ny == 1 ? 1 : edge;
    int sum = 0;
    for (int c = k * edge; c < (k + 1) * edge; ++c)
        for (int b = j * depth; b < (j + 1) * depth; ++b)
            for (int a = i * edge; a < (i + 1) * edge; ++a)
                sum += grid.over_bed(frame.water, std::min(a, grid.nx - 1), std::min(b, grid.ny - 1),
                                     std::min(c, grid.nz - 1));
    return static_cast<float>(sum) / (255.0f * static_cast<float>(edge * depth * edge));
}

/// The raster as an image of point values; a half model gets its other side, so that nothing ends on y = 0.
vtkSmartPointer<vtkImageData> share_image(const RasterGrid& grid, const RasterFrame& frame, int edge, bool mirror) {
    const bool flat = grid.ny == 1;  // a two-dimensional run is drawn as a slab
    const auto blocks = [&](int n) { return (n + edge - 1) / edge; };
    const int nx = blocks(grid.nx), rows = flat ? 1 : blocks(grid.ny), nz = blocks(grid.nz);
    const int mirrored = mirror && !flat ? rows : 0, ny = flat ? 2 : rows + mirrored;
    const double d = edge * grid.spec.voxel;
    const Vec3 first = grid.spec.origin + Vec3::Constant(0.5 * d);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(nx, ny, nz);
    image->SetSpacing(d, flat ? 0.2 * grid.nx * grid.spec.voxel : d, d);
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
    Surface half = part_of(whole, [&](const std::array<int, 3>& t) {
        return std::max({at(t[0]), at(t[1]), at(t[2])}) > 1e-6 * voxel;
    });
    for (Vec3& p : half.points) p.y() = std::max(p.y(), 0.0);
    return half;
}

bool half_model(const RunRecord& record) {
    const auto factor = record.attributes.find("symmetry_factor");
    return factor != record.attributes.end() && factor->second == "2";
}

}  // namespace

Surface water_surface(const RunRecord& record, const RasterFrame& frame, int coarsening) {
    const RasterGrid grid(record.raster);
    if (grid.empty() || frame.water.size() != grid.voxels()) return {};
    const bool mirror = half_model(record);
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
    return mirror && grid.ny > 1 ? own_side(surface, grid.spec.voxel) : surface;
}

}  // namespace tw
