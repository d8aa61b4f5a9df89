#pragma once
#include <cstdint>
#include <vector>

#include "record/raster_grid.h"
#include "record/run_record.h"

namespace tw {

/// Height of the smooth wave in each column [m]: the highest surface below `tops` that nowhere leaves still water by a
/// slope above that of the steepest gravity wave,
///
///   wave(x) = min over x' of ( max(top(x'), level) + tan(30 deg) |x - x'| )
///
/// 30 degrees: the crest of Stokes' limiting wave encloses 120 (Stokes 1880); what is steeper is spray, a sheet or a
/// breaker. Tops count with the lowest of their eight neighbours, since over one voxel no slope is known. Columns that
/// the hull covers, and those beside them, which it part-fills, say nothing of the wave; it is carried on over them.
/// Dry columns stand at the level. `tops`: sheet_tops(); `covered`: under_hull().
std::vector<float> wave_surface(const RasterGrid& grid, const std::vector<float>& tops,
                                const std::vector<std::uint8_t>& covered, double level);

/// Edge of the largest cell that still water meets in each column of the raster, at least a voxel [m]: water that a
/// mesh smears over its surface cell is no splash. From the record's numbers `spacing` and `near_hull` and its attribute
/// `surface_cells` (scene/new_record.cpp), which both methods' records have; a voxel in records without it.
std::vector<float> surface_cells(const RunRecord& record);

}  // namespace tw
