#pragma once
#include <cstdint>
#include <vector>

#include "meshes/query.h"
#include "record/body_pose.h"
#include "record/raster_grid.h"

namespace tw {

/// What the voxels of a raster are to a body that stands somewhere in it.
enum class VoxelKind : std::uint8_t {
    far,     ///< farther than two voxel edges from its surface
    beside,  ///< outside, between one and two edges from it
    body     ///< inside, or nearer than an edge
};

/// Voxels that a body takes and those beside it, and where its axis is at each height.
struct BodyVoxels {
    std::vector<VoxelKind> kind;
    std::vector<double> axis_x,
        axis_y;  ///< per layer [m]; of the nearest layer that the body crosses; NaN: it is outside
};
BodyVoxels body_voxels(const RasterGrid& grid, const SurfaceQuery& shape, const Box& bounds, const BodyPose& pose);

/// The air of one frame: 0 water or body, 1 closed, 2 open (see entry.h).
enum class Air : std::uint8_t { none, closed, open };
std::vector<Air> air_of_frame(const RasterGrid& grid, const RasterFrame& frame, const BodyVoxels& body);

/// The voxels of the body's cavity below layer `surface`, the first one above still water; closed air above it too.
std::vector<std::size_t> cavity_voxels(const RasterGrid& grid, const std::vector<Air>& air, const BodyVoxels& body,
                                       int surface);

}  // namespace tw
