#pragma once
#include <optional>
#include <vector>

#include "meshes/health.h"
#include "meshes/surface.h"

namespace tw {

/// Whether a closed or open surface is the half of a hull on one side of y = 0: it touches that plane and is open
/// there, or has a flat face in it and is not symmetric about its own middle, as a whole hull beside the plane is.
bool is_half(const Surface& surface);

/// Makes such a half whole by its mirror image, joined in the plane y = 0, and returns what is to be said of it; leaves
/// every other surface as it is.
std::optional<Finding> mirror_half(Surface& surface);

/// Surfaces that are read in other axes than their file has (`lying`: up is y, or the hull lies on its side; `across`:
/// its length is along y) or that stand upside down (`upside_down`), with the `axes` that would mend it. Judged by
/// where the centre of volume lies between the surface's faces: in the middle across a plane of symmetry, towards the
/// deck along a hull's height. Hulls that are symmetric in both ways, such as boxes and torpedoes, have no findings.
std::vector<Finding> check_axes(const Surface& closed_surface);

}  // namespace tw
