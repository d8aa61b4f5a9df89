#include "compare/metrics/wave_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "record/record_numbers.h"

namespace tw {

namespace {

/// Calls `visit` with each of the eight neighbours of column (i, j) that the grid has, and how far it is in voxels.
template <class Visit>
void neighbours(const RasterGrid& grid, int i, int j, Visit visit) {
    for (int b = std::max(j - 1, 0); b <= std::min(j + 1, grid.ny - 1); ++b)
        for (int a = std::max(i - 1, 0); a <= std::min(i + 1, grid.nx - 1); ++a)
            if (a != i || b != j) visit(grid.column(a, b), a != i && b != j ? std::numbers::sqrt2 : 1.0);
}

}  // namespace

std::vector<float> wave_surface(const RasterGrid& grid, const std::vector<float>& tops,
                                const std::vector<std::uint8_t>& covered, double level) {
    constexpr float unknown = std::numeric_limits<float>::infinity();
    const auto still = static_cast<float>(level);
    std::vector<float> top(grid.columns(), unknown), wave(grid.columns(), unknown);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const std::size_t c = grid.column(i, j);
            bool beside = covered[c];
            neighbours(grid, i, j, [&](std::size_t n, double) { beside = beside || covered[n]; });
            if (!beside) top[c] = std::isfinite(tops[c]) ? std::max(tops[c], still) : still;
        }
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const std::size_t c = grid.column(i, j);
            wave[c] = top[c];
            if (top[c] < unknown)
                neighbours(grid, i, j, [&](std::size_t n, double) { wave[c] = std::min(wave[c], top[n]); });
        }
    // The cone over every column, by two sweeps back and forth over neighbours (distances to 8 %).
    const double rise = std::tan(std::numbers::pi / 6) * grid.spec.voxel;
    const auto relax = [&](int i, int j) {
        float& here = wave[grid.column(i, j)];
        neighbours(grid, i, j,
                   [&](std::size_t n, double far) { here = std::min(here, wave[n] + static_cast<float>(rise * far)); });
    };
    for (int sweep = 0; sweep < 2; ++sweep) {
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) relax(i, j);
        for (int j = grid.ny - 1; j >= 0; --j)
            for (int i = grid.nx - 1; i >= 0; --i) relax(i, j);
    }
    for (float& w : wave)
        if (w == unknown) w = still;  // the hull covers everything
    return wave;
}

std::vector<float> surface_cells(const RunRecord& record) {
    const RasterGrid grid(record.raster);
    const double voxel = grid.spec.voxel;
    std::vector<float> cells(grid.columns(), static_cast<float>(voxel));
    if (text_of(record, "surface_cells").empty()) return cells;
    const char* largest = number_of(record, "dimensions", 3) == 2 ? "near_hull" : "spacing";
    std::ranges::fill(cells, static_cast<float>(std::max(voxel, number_of(record, largest, voxel))));
    std::istringstream boxes(text_of(record, "surface_cells"));
    boxes.imbue(std::locale::classic());
    double cell, x0, x1, y0, y1;
    while (boxes >> cell >> x0 >> x1 >> y0 >> y1)
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i) {
                float& here = cells[grid.column(i, j)];
                if (grid.x(i) > x0 && grid.x(i) < x1 && grid.y(j) > y0 && grid.y(j) < y1)
                    here = std::min(here, static_cast<float>(std::max(voxel, cell)));
            }
    return cells;
}

}  // namespace tw
