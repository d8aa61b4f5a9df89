#pragma once
#include <vector>

#include "meshes/query/solid_column.h"

namespace tw {

/// A part of a gauge's vertical line and the share of it that is water [-]; NaN: not known, then as in the nearest part
/// of the same gap that is.
struct GaugePart {
    Stretch at;
    double water = 0;  ///< [-]
};

/// Elevation at a height probe [m], the same definition for every method. Solids cut the vertical line through the tank
/// into gaps. The gauge shows the water of the highest gap that holds any, as a capacitive wave gauge would that stands
/// on what is under it:
///
///   level = ground + integral over the gap of the share of water dz
///
/// the ground being the top of the solid below, or the floor of the tank. Water thrown over counts with its volume, and
/// a hollow counts as missing height. Where no gap holds water the gauge shows its lowest ground: the dry floor, slope or
/// weir. Where that water reaches up to a solid that lies on it, as under a floating body, there is no free surface: NaN;
/// as where solids take the whole line. A gap holds water from half a `size` [m] on, the size of particles or cells there,
/// and one that is narrower than that size is none.
double gauge_level(const Stretch& line, const std::vector<Stretch>& solid, const std::vector<GaugePart>& parts,
                   double size);

}  // namespace tw
