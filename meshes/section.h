#pragma once
#include "meshes/surface.h"

namespace tw {

/// The section of a closed surface with the plane y = 0 as a solid of its own: the section drawn out to `span` [m]
/// across that plane, half of it to each side, closed by flat ends, normals outward. Corners that lie in the plane
/// count as if they stood just beside it, at y > 0, so that a keel in the plane cuts like any other place.
/// Throws InputError: the surface does not cross the plane, it is not closed there, or its section has a loop inside
/// another one.
Surface section_prism(const Surface& closed, double span = 1);

/// A prism of section_prism with another span [m].
Surface with_span(const Surface& prism, double span);

/// A span so large that the ends of the prism are nowhere near the plane y = 0 compared with its sides [m].
double endless_span(const Surface& prism);

}  // namespace tw
