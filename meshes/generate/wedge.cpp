#include <cmath>

#include "meshes/generate/loft.h"
#include "meshes/generate/shapes.h"

namespace tw {
namespace {
/// The V lies in the x-z plane and the keel along y, so that a scene in two dimensions (the x-z plane) sees the wedge
/// of the water-entry theories (Wagner, Dobrovol'skaya).
Surface make_wedge(const std::map<std::string, double>& v) {
    const double half_width = v.at("width") / 2, half_span = v.at("span") / 2, sides = v.at("side_height");
    const double chine = half_width * std::tan(v.at("deadrise"));
    const auto section = [&](double x, double bottom) {
        return HalfSection{
            {x, 0, bottom}, {x, half_span, bottom}, {x, half_span, chine + sides}, {x, 0, chine + sides}};
    };
    return loft({section(-half_width, chine), section(0, 0), section(half_width, chine)});
}
}  // namespace

HullShape wedge_shape() {
    return {"wedge",
            "wedge of the water-entry theories: the V in the x-z plane, keel along y",
            {{"width", "m", "between the chines, along x", 1, 1e-4, 100},
             {"span", "m", "length of the keel, along y", 1, 1e-4, 500},
             {"deadrise", "rad", "angle of either face with the horizontal", 30 * degree, 1 * degree, 85 * degree},
             {"side_height", "m", "of the upright sides above the chines; 0: none", 0, 0, 100}},
            make_wedge};
}

}  // namespace tw
