#include "record/water_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "record/raster_grid.h"

namespace tw {
namespace water_surface_test {

/// Still water to z = 0 over a bed at z = `bed`, in voxels of 0.1 m from z = -0.4 m.
RunRecord still_water(double bed) {
    RunRecord record;
    record.raster = {{0, 0, -0.4}, 0.1, {8, 6, 6}};
    const RasterGrid grid(record.raster);
    RasterFrame frame;
    for (int k = 0; k < grid.nz; ++k)
        for (int n = 0; n < grid.nx * grid.ny; ++n) {
            const double wet = std::min(grid.z_low(k) + 0.1, 0.0) - std::max(grid.z_low(k), bed);
            frame.water.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(wet / 0.1, 0.0, 1.0))));
        }
    record.frames.push_back(frame);
    return record;
}

TEST(WaterSurface, TheBedIsNoSurfaceOfTheWater) {
    for (const double bed : {-0.4, -0.37, -0.32}) {  // cuts the lowest voxels
        const RunRecord record = still_water(bed);
        for (const int coarsening : {1, 2}) {
            const Surface surface = water_surface(record, record.frames.front(), coarsening);
            ASSERT_FALSE(surface.points.empty());
            for (const Vec3& p : surface.points) EXPECT_NEAR(p.z(), 0, 0.06 * coarsening) << bed;
        }
    }
}

}  // namespace water_surface_test
}  // namespace tw
