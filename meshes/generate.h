#pragma once
#include <map>
#include <string>
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// One parameter of a parametric hull: name as in the scene file, unit kind ("m", "rad", "-"), default, range.
struct HullParameter {
    std::string name, kind, meaning;
    double fallback, min, max;  ///< [SI of `kind`]
};
/// A parametric hull. Closed, outward normals, bow at negative x, stern (transom) at the largest x, symmetric about y =
/// 0, keel's lowest point at z = 0 before posing.
struct HullShape {
    std::string name, description;
    std::vector<HullParameter> parameters;
    Surface (*make)(const std::map<std::string, double>& values);
};
/// prismatic, fridsma, seaplane, wigley, wedge, plate, box, cylinder, sphere, torpedo.
const std::vector<HullShape>& hull_shapes();
/// Throws InputError for an unknown shape or parameter (naming the known ones) or a value out of range.
Surface make_hull(const std::string& shape, const std::map<std::string, double>& values);
/// A block as a closed surface, outward normals, where it stands.
Surface box_surface(const Box& box);

}  // namespace tw
