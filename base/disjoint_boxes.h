#pragma once
#include <span>
#include <vector>

#include "base/vec3.h"

namespace tw {

/// The space that boxes fill together, as groups of boxes that touch and do not overlap: what touched or overlapped
/// before is one group, divided anew into the boxes whose thinnest is thickest. A box that touches none is a group of
/// its own and stays as it is. The result does not depend on the order of the boxes, but for the order of the groups.
///
/// `gap`: boxes nearer to each other than this along an axis touch; both then reach half way [m]. Faces within a
/// thousandth of it are one. `dimensions` 2: y counts for nothing. Throws InputError where boxes that touch have so
/// many different faces that they cannot be divided.
std::vector<std::vector<Box>> disjoint_groups(std::span<const Box> boxes, int dimensions, double gap);

/// The boxes of all groups.
std::vector<Box> disjoint_boxes(std::span<const Box> boxes, int dimensions, double gap);

}  // namespace tw
