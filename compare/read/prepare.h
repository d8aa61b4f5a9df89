#pragma once
#include "record/run_record.h"

namespace tw {

/// Leaves only raster columns that lie wholly inside the solved domain (numbers domain_x_min ...): in others a method's
/// outlet buffer or the missing half of a voxel would look like a wave. A record without these numbers, or one voxel
/// wide, stays as it is.
void crop_to_domain(RunRecord& record);

/// A half model whose hull surface holds only one side gets the other by reflection in y = 0, values included.
void complete_half_hull(RunRecord& record);

/// The record's moment reference (attribute moment_reference, "x y z") [m]; the origin where it has none.
Vec3 moment_reference_of(const RunRecord& record);
/// Moves the column forces/my to another reference point (bow up positive: my = sum (z - z0) fx - (x - x0) fz):
///   my' = my + (z0 - z0') fx - (x0 - x0') fz
/// and notes the new point. Nothing where my, fx or fz is absent.
void refer_moments_to(RunRecord& record, const Vec3& reference);

}  // namespace tw
