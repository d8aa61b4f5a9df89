#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "record/raster_spec.h"

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
    /// Water of a voxel, 0 to 255, for drawing a surface: the bed may cut the lowest voxels, so those have at least what
    /// the ones above have. The bed is no surface of the water then.
    std::uint8_t over_bed(const std::vector<std::uint8_t>& water, int i, int j, int k) const {
        const std::uint8_t own = water[voxel(i, j, k)];
        return k == 0 && nz > 1 ? std::max(own, water[voxel(i, j, 1)]) : own;
    }
    std::size_t columns() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    std::size_t voxels() const { return columns() * static_cast<std::size_t>(nz); }
    double x(int i) const { return spec.origin.x() + (i + 0.5) * spec.voxel; }
    double y(int j) const { return spec.origin.y() + (j + 0.5) * spec.voxel; }
    double z_low(int k) const { return spec.origin.z() + k * spec.voxel; }
    bool empty() const { return nx < 1 || ny < 1 || nz < 1 || !(spec.voxel > 0); }
};

}  // namespace tw
