#pragma once
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// Half a cross-section: points with y >= 0 from the keel (y = 0) up to the top (y = 0).
using HalfSection = std::vector<Vec3>;

/// A closed surface symmetric about y = 0 through half-sections of equal length, from bow to stern: skinned, mirrored,
/// closed by flat ends (convex ones), with outward normals. Sections may collapse to a line or a point, and two
/// sections at the same place make a step.
Surface loft(const std::vector<HalfSection>& sections);

/// Turns a closed surface outward if its volume is negative.
Surface outward(Surface surface);

}  // namespace tw
