#pragma once
#include <cstdint>

#include "sph_solver/neighbours/wide_place.h"

namespace tw {

/// Upright pencils of square cross-section over a box, cut into slabs where the box is taller than 4096 dp; what lies
/// outside belongs to the nearest pencil. Within a pencil places are compared by their 32 bits, from its centre.
struct Pencils {
    std::int64_t x0 = 0, y0 = 0, z0 = 0, width = 1, height = 1;  ///< [fixed-point units]
    int nx = 1, ny = 1, nz = 1;

    int count() const { return nx * ny * nz; }
    int pencil_x(std::int64_t x) const { return clamp((x - x0) / width, nx); }
    int pencil_y(std::int64_t y) const { return clamp((y - y0) / width, ny); }
    int slab(std::int64_t z) const { return clamp((z - z0) / height, nz); }
    int pencil(int cx, int cy, int cz) const { return (cz * ny + cy) * nx + cx; }
    int of(const WidePlace& p) const { return pencil(pencil_x(p.x), pencil_y(p.y), slab(p.z)); }
    WidePlace centre(int pencil) const {
        return {x0 + (pencil % nx) * width + width / 2, y0 + (pencil / nx % ny) * width + width / 2,
                middle_of_slab(pencil / nx / ny)};
    }
    std::int64_t middle_of_slab(int cz) const { return z0 + cz * height + height / 2; }

    /// Distance between a pencil, or a row of pencils, and an interval [fixed-point units]; those at the rim reach to
    /// infinity.
    double gap_x(int cx, std::int64_t lo, std::int64_t hi) const { return gap(cx, nx, lo - x0, hi - x0); }
    double gap_y(int cy, std::int64_t lo, std::int64_t hi) const { return gap(cy, ny, lo - y0, hi - y0); }

private:
    double gap(int c, int n, std::int64_t lo, std::int64_t hi) const {
        const std::int64_t begin = c * width, end = begin + width;
        if (c > 0 && hi < begin) return double(begin - hi);
        if (c < n - 1 && lo > end) return double(lo - end);
        return 0;
    }
    static int clamp(std::int64_t i, int n) { return i < 0 ? 0 : i >= n ? n - 1 : static_cast<int>(i); }
};

}  // namespace tw
