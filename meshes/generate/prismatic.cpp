#include <cmath>

#include "base/errors.h"
#include "meshes/generate/loft.h"
#include "meshes/generate/shapes.h"

namespace tw {
namespace {
/// The same V-section all along, as in Savitsky's planing formula (Marine Technology 1(1), 1964): straight keel, hard
/// chines, upright sides, flat deck, upright transom; the flat bow is upright or raked with its deck edge foremost.
Surface make_prismatic(const std::map<std::string, double>& v) {
    const double length = v.at("length"), half_beam = v.at("beam") / 2, height = v.at("height");
    const double chine = half_beam * std::tan(v.at("deadrise")), overhang_per_height = std::tan(v.at("rake"));
    if (!(chine < height))
        throw InputError("prismatic hull: its chines lie " + std::to_string(chine) +
                         " m above the keel, at or above its deck at height = " + std::to_string(height) +
                         " m; raise the height or lower the deadrise");
    if (!(height * overhang_per_height < 0.9 * length))
        throw InputError(
            "prismatic hull: a bow raked that much takes more than nine tenths of the length; lower the rake");
    const std::array<std::pair<double, double>, 4> section{
        {{0, 0}, {half_beam, chine}, {half_beam, height}, {0, height}}};
    HalfSection bow, transom;
    for (const auto& [y, z] : section) {
        bow.emplace_back(-length / 2 + (height - z) * overhang_per_height, y, z);
        transom.emplace_back(length / 2, y, z);
    }
    return loft({bow, transom});
}
}  // namespace

HullShape prismatic_shape() {
    return {"prismatic",
            "prismatic planing hull: V-bottom, hard chines, upright sides and transom",
            {{"length", "m", "over all", 4, 1e-3, 500},
             {"beam", "m", "over the chines", 1, 1e-3, 100},
             {"deadrise", "rad", "angle of the bottom with the horizontal", 20 * degree, 0, 50 * degree},
             {"height", "m", "from the keel to the deck", 0.75, 1e-4, 100},
             {"rake", "rad", "of the bow, deck edge foremost; 0: upright", 0, 0, 70 * degree}},
            make_prismatic};
}

}  // namespace tw
