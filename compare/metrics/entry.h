#pragma once
#include "compare/compare.h"

namespace tw {

/// What a body that enters water leaves behind it and throws up, in every raster frame: the same for any source,
/// because only the common raster and the body's recorded place are read. A table "entry_NAME", one row per frame.
///
/// Kinds of closure as Aristoff & Bush 2009 (doi:10.1017/S0022112008004382) name them; what is seen on photographs
/// there is counted in voxels here:
///
///   air      a voxel with a water share below 1/2 whose centre is more than a voxel edge outside the body: narrower
///            gaps are not seen
///   open     air that hangs together, through the faces of air, with the top of the raster
///   cavity   air below still water that hangs together with air beside the body (within a further voxel edge of it);
///            closed air goes on above still water, under a dome. Closed pockets of less than 2^d voxels, d the number
///            of dimensions, are noise
///
///   open_volume, closed_volume   of the cavity [m3], or [m3/m]
///   open_depth     of the cavity's deepest open voxel's lower face below still water [m]; 0: none is open
///   closed_top     of the closed air's highest voxel's upper face above still water [m]; NaN: none is closed. At or
///                  above 0 the seal is at the surface (a dome), below 0 it is deep
///   cavity_low_x, cavity_high_x   volume of the cavity on the sides of smaller and larger x than the body's axis,
///                  which is at each height the mean place of the body's voxels there
///   waterline_low_x, waterline_high_x   highest water of the main body (main_body()) beside the body, on these sides,
///                  within a voxel of the plane y = that of the axis, above still water [m]; NaN: none
///   crown_height   highest water of the main body above still water (sheet_tops()) [m]; crown_low_x, crown_high_x the
///                  same on either side of the axis
///   crown_volume   water more than a surface cell (surface_cells()) above still water, attached or not
///
/// No height is better than half a voxel, no time better than half the interval between two frames.
Table entry_series(const RunRecord& record, const BodyShape& body, double still_level);

/// When and where the cavity closed, from entry_series. Times lie midway between two frames.
struct CavityClosure {
    double seal = NAN, seal_depth = NAN;  ///< first frame with closed air: [s]; depth of its top below still water [m]
    double closed = NAN;     ///< no open air is deeper than `noise` any more, for the first time after the deepest [s]
    double deepest = 0;      ///< of the open cavity over the whole run [m]
    double half_step = NAN;  ///< half the interval between the frames of the earlier event [s]
};
/// `noise`: a cavity counts once its open depth exceeds twice this, a voxel edge [m].
CavityClosure closure_of(const Table& entry, double noise);

/// Of every body that enters water: cavity_seal:NAME, cavity_seal_depth:NAME, cavity_closure:NAME, cavity_depth:NAME,
/// cavity_asymmetry:NAME, crown_height:NAME, crown_time:NAME, crown_volume:NAME and crown_volume_time:NAME. Nothing is
/// added where in no source a cavity opened by more than two voxels or a crown rose by as much.
void add_entries(Comparison& comparison);

}  // namespace tw
