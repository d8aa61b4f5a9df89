#pragma once
#include <cstdint>
#include <vector>

#include "record/run_record.h"

namespace tw {

/// Index arithmetic of a raster, x fastest.
struct RasterGrid {
    explicit RasterGrid(const RasterSpec& s) : spec(s), nx(s.count[0]), ny(s.count[1]), nz(s.count[2]) {}
    const RasterSpec& spec;
    int nx, ny, nz;
    std::size_t voxel(int i, int j, int k) const {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(nx) +
               static_cast<std::size_t>(i);
    }
    std::size_t column(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
    }
    std::size_t columns() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    std::size_t voxels() const { return columns() * static_cast<std::size_t>(nz); }
    double x(int i) const { return spec.origin.x() + (i + 0.5) * spec.spacing; }
    double y(int j) const { return spec.origin.y() + (j + 0.5) * spec.spacing; }
    double z_low(int k) const { return spec.origin.z() + k * spec.spacing; }
    bool empty() const { return nx < 1 || ny < 1 || nz < 1 || !(spec.spacing > 0); }
};

/// 1 for each voxel of the main water body: water share >= 1/2, in the largest set connected through faces, edges or
/// corners (26 neighbours).
std::vector<std::uint8_t> main_body(const RasterGrid& grid, const RasterFrame& frame);

/// Per column the top of the highest water of the main body [m]: lower face of its voxel + share x edge. NaN where
/// there is none.
std::vector<float> sheet_tops(const RasterGrid& grid, const RasterFrame& frame, const std::vector<std::uint8_t>& body);

/// Per column the height of its connected water [m]: raster floor + edge x sum of shares over the main body and over
/// the part-filled voxels that touch it from above. A hollow counts as missing height. NaN where there is none.
std::vector<float> elevations(const RasterGrid& grid, const RasterFrame& frame, const std::vector<std::uint8_t>& body);

/// 1 for each column whose centre lies in the hull's plan view (both sides of y = 0).
std::vector<std::uint8_t> under_hull(const RasterGrid& grid, const Surface& hull);

}  // namespace tw
