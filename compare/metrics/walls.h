#pragma once
#include "compare/compare.h"

namespace tw {

/// Of every solid whose record says how hard its wall pulls at the water (columns suction_force_NAME and suction_area_NAME
/// of the table `samples`):
///   suction:NAME   mean over the record of the sum of -pressure times area, whatever the direction [N]
/// shown beside, with the mean area in the remark. Where the walls of a method hold water under tension (attribute
/// `walls`) and that is more than a twentieth of the force on the solid, a banner says that the water's clinging decides
/// the answer. And of every body that comes down into water (column leaving_angle_NAME):
///   leaving_angle:NAME   mean over the rows in which it is partly wet of the angle at which water leaves it [deg]
void add_walls(Comparison& comparison);

}  // namespace tw
