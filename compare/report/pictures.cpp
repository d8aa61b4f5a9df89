#include "compare/report/pictures.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "compare/metrics/raster_columns.h"
#include "compare/report/drawn_solids.h"
#include "compare/report/egl_window.h"
#include "record/record_numbers.h"
#include "record/vtk_surface.h"

namespace tw {

namespace {

constexpr int window_width = 900, window_height = 560;

void paint_by_height(vtkPolyData* surface, const ColourScale& scale) {
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
        const Rgb c = scale(surface->GetPoint(i)[2]);
        colours->InsertNextTuple3(255 * c[0], 255 * c[1], 255 * c[2]);
    }
    surface->GetPointData()->SetScalars(colours);
}

/// Surface where the water share is one half, by the same filter for every source; lightly smoothed, coloured by
/// height.
vtkSmartPointer<vtkPolyData> free_surface(const RunRecord& record, const ColourScale& scale) {
    const RasterGrid grid(record.raster);
    const RasterFrame& frame = record.frames.back();
    const bool mirror = number_of_text(record, "symmetry_factor", 1) > 1;
    const bool flat = grid.ny == 1;  // a two-dimensional run is drawn as a slab
    const int mirrored = mirror ? grid.ny : 0, ny = flat ? 2 : grid.ny + mirrored;
    vtkNew<vtkImageData> image;
    image->SetDimensions(grid.nx, ny, grid.nz);
    image->SetSpacing(grid.spec.voxel, flat ? 0.2 * grid.nx * grid.spec.voxel : grid.spec.voxel, grid.spec.voxel);
    image->SetOrigin(grid.x(0), mirror ? -grid.y(grid.ny - 1) : grid.y(0), grid.z_low(0) + 0.5 * grid.spec.voxel);
    vtkNew<vtkFloatArray> share;
    share->SetNumberOfTuples(static_cast<vtkIdType>(grid.nx) * ny * grid.nz);
    vtkIdType n = 0;
    for (int k = 0; k < grid.nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < grid.nx; ++i) {
                const int row = flat ? 0 : !mirror ? j : j < mirrored ? mirrored - 1 - j : j - mirrored;
                share->SetValue(n++, grid.over_bed(frame.water, i, row, k) / 255.0f);
            }
    image->GetPointData()->SetScalars(share);
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(image);
    contour->SetValue(0, 0.5);
    contour->ComputeNormalsOff();
    contour->ComputeScalarsOff();
    contour->Update();
    if (contour->GetOutput()->GetNumberOfCells() == 0) return contour->GetOutput();  // all wet or all dry
    vtkNew<vtkWindowedSincPolyDataFilter> smooth;
    smooth->SetInputConnection(contour->GetOutputPort());
    smooth->SetNumberOfIterations(12);
    smooth->SetPassBand(0.12);
    smooth->BoundarySmoothingOff();
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(smooth->GetOutputPort());
    normals->SplittingOff();
    normals->Update();
    vtkSmartPointer<vtkPolyData> surface = normals->GetOutput();
    paint_by_height(surface, scale);
    return surface;
}

vtkSmartPointer<vtkActor> actor(vtkPolyData* data) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetColorModeToDirectScalars();
    auto a = vtkSmartPointer<vtkActor>::New();
    a->SetMapper(mapper);
    a->GetProperty()->SetAmbient(0.25);
    a->GetProperty()->SetDiffuse(0.75);
    return a;
}

/// Leaves out the side of the water on which the eye is, up to the middle of the bodies: they stand below the surface.
void cut_open(vtkActor* water, const std::vector<Surface>& bodies) {
    double middle = 0;
    for (const Surface& body : bodies) middle += (body.bounds().min.y() + body.bounds().max.y()) / 2;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0, middle / static_cast<double>(bodies.size()), 0);
    plane->SetNormal(0, -1, 0);
    water->GetMapper()->AddClippingPlane(plane);
}

/// Hull's bounds, or the raster's where there is no hull.
Box subject(const RunRecord& record) {
    Box b;
    if (record.hull.points.empty()) {
        const RasterGrid grid(record.raster);
        b.min = record.raster.origin;
        b.max = b.min + grid.spec.voxel * Vec3(grid.nx, grid.ny, grid.nz);
        return b;
    }
    b.min = b.max = record.hull.points.front();
    for (const Vec3& p : record.hull.points) {
        b.min = b.min.cwiseMin(p);
        b.max = b.max.cwiseMax(p);
    }
    return b;
}

bool can_be_drawn(const RunRecord& record) {
    return !record.frames.empty() && record.raster.voxel > 0 && record.raster.count[0] > 1 &&
           record.raster.count[1] > 0 && record.raster.count[2] > 1;
}

std::string surface_picture(EglWindow& window, const RunRecord& record, const Box& view, const ColourScale& scale) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    const auto water = free_surface(record, scale);
    const auto water_actor = actor(water);
    water_actor->GetProperty()->SetAmbient(0.5);
    water_actor->GetProperty()->SetDiffuse(0.6);
    water_actor->GetProperty()->SetSpecular(0.2);
    water_actor->GetProperty()->SetSpecularPower(30);
    renderer->AddActor(water_actor);
    const auto add_solid = [&](const Surface& surface) {
        const auto solid = actor(poly_data_of(surface));
        solid->GetProperty()->SetColor(0.62, 0.63, 0.65);
        renderer->AddActor(solid);
    };
    if (!record.hull.triangles.empty()) add_solid(record.hull);
    const std::vector<Surface> bodies = bodies_at(record, record.frames.back().time);
    for (const Surface& body : bodies) add_solid(body);
    if (!bodies.empty() && record.raster.count[1] > 1) cut_open(water_actor, bodies);
    const Vec3 size = view.size(), middle = 0.5 * (view.min + view.max);
    const double reach = std::max(size.x(), 2 * size.y());
    // From astern, to one side and above: the wake lies in front, the hull behind it.
    const Vec3 target = middle + Vec3(0.45 * size.x(), 0, -0.35 * size.z()),
               eye = target + reach * Vec3(1.25, 0.95, 0.75);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetFocalPoint(target.data());
    camera->SetPosition(eye.data());
    camera->SetViewUp(0, 0, 1);
    camera->SetViewAngle(32);
    if (record.hull.points.empty()) renderer->ResetCamera();  // a tank: all of its water
    renderer->ResetCameraClippingRange();
    return window.png(renderer);
}

std::string pressure_picture(EglWindow& window, const RunRecord& record, const ColourScale& scale) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    const auto data = poly_data_of(record.hull);
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    for (std::size_t t = 0; t < record.hull.triangles.size(); ++t) {
        const auto pressure = wet_pressure(record, t);
        const Rgb c = pressure ? scale(*pressure) : Rgb{0.80, 0.81, 0.83};
        colours->InsertNextTuple3(255 * c[0], 255 * c[1], 255 * c[2]);
    }
    data->GetCellData()->SetScalars(colours);
    const auto hull = actor(data);
    hull->GetProperty()->SetAmbient(0.8);  // colours are values: little shading
    hull->GetProperty()->SetDiffuse(0.2);
    renderer->AddActor(hull);
    const Box b = subject(record);
    const Vec3 middle = 0.5 * (b.min + b.max), eye = middle - Vec3(0, 0, 10 * b.size().x());
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(middle.data());
    camera->SetPosition(eye.data());
    camera->SetViewUp(0, -1, 0);  // stern on the right, as in the maps
    camera->SetParallelScale(1.08 * 0.5 * std::max(b.size().y(), b.size().x() * 300 / window_width));
    renderer->ResetCameraClippingRange();
    return window.png(renderer);
}

std::string png_bytes(vtkImageData* image) {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

}  // namespace

double elevation_half_range(const Comparison& comparison) {
    std::vector<float> sizes;
    double voxel = 0;
    for (std::size_t s = 0; s < comparison.analyses.size(); ++s) {
        voxel = std::max(voxel, comparison.sources[s].raster.voxel);
        for (const float z : comparison.analyses[s].mean_elevation)
            if (std::isfinite(z)) sizes.push_back(std::abs(z - static_cast<float>(comparison.analyses[s].still_level)));
    }
    if (sizes.empty()) return std::max(voxel, 1e-3);
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(sizes.size() - 1));
    std::ranges::nth_element(sizes, at);
    return std::max(static_cast<double>(*at), voxel);
}

Pictures render_pictures(const Comparison& comparison, const ColourScale& elevation) {
    Pictures pictures;
    pictures.free_surface.resize(comparison.sources.size());
    pictures.hull_pressure.resize(comparison.sources.size());
    try {
        EglWindow window(window_width, window_height);
        // The camera follows the first source with a subject, so all are seen alike.
        const Box view = subject(comparison.sources.front());
        const auto pressures = pressure_range(comparison);
        for (std::size_t s = 0; s < comparison.sources.size(); ++s)
            if (can_be_drawn(comparison.sources[s]))
                pictures.free_surface[s] = surface_picture(window, comparison.sources[s], view, elevation);
        if (!pressures) return pictures;
        pictures.pressure_low = pressures->low, pictures.pressure_high = pressures->high;
        const ColourScale scale = pressure_scale(pressures->low, pressures->high);
        EglWindow flat(window_width, 300);
        for (std::size_t s = 0; s < comparison.sources.size(); ++s)
            if (!comparison.sources[s].hull_pressure.empty())
                pictures.hull_pressure[s] = pressure_picture(flat, comparison.sources[s], scale);
    } catch (const RunError& e) { pictures.note = e.what(); }
    return pictures;
}

ElevationPicture elevation_picture(const RunRecord& record, const Analysis& analysis, const ColourScale& scale) {
    const RasterGrid grid(record.raster);
    ElevationPicture picture{};
    if (grid.empty() || analysis.mean_elevation.empty()) return picture;
    const bool mirror = number_of_text(record, "symmetry_factor", 1) > 1;
    const int rows = mirror ? 2 * grid.ny : grid.ny;
    vtkNew<vtkImageData> image;
    image->SetDimensions(grid.nx, rows, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const int row = !mirror ? j : j < grid.ny ? grid.ny - 1 - j : j - grid.ny;
            const float z = analysis.mean_elevation[grid.column(i, row)];
            auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0));
            const Rgb c = std::isfinite(z) ? scale(z) : Rgb{};
            for (std::size_t k = 0; k < 3; ++k) pixel[k] = static_cast<unsigned char>(std::lround(255 * c[k]));
            pixel[3] = std::isfinite(z) ? 255 : 0;
        }
    picture.png = png_bytes(image);
    picture.x_min = grid.spec.origin.x();
    picture.x_max = picture.x_min + grid.nx * grid.spec.voxel;
    picture.y_max = grid.spec.origin.y() + grid.ny * grid.spec.voxel;
    picture.y_min = mirror ? -picture.y_max : grid.spec.origin.y();
    return picture;
}

}  // namespace tw
