#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "meshes/generate/loft.h"
#include "meshes/generate/shapes.h"

namespace tw {
namespace {
/// The models of Fridsma's tank tests (A systematic study of the rough-water performance of planing boats, Davidson
/// Laboratory R-1275, 1969): a prismatic V-bottom with hard chines, and a bow one beam long whose plan and keel are
/// ellipses. With u from 0 at the bow's begin to 1 at the stem, b the beam and beta the deadrise,
///
///   y_chine = b/2 sqrt(1 - u^2),   z_keel = b/16 (1 - sqrt(1 - u^2)),   z_chine = z_keel + y_chine tan(beta)
///
/// Upright sides, flat deck, upright transom. The equations are those of a model generator, not seen in the report itself.
Surface make_fridsma(const std::map<std::string, double>& v) {
    const double length = v.at("length"), beam = v.at("beam"), height = v.at("height");
    const double slope = std::tan(v.at("deadrise"));
    if (!(beam < length))
        throw InputError("Fridsma's hull: its bow is one beam long, " + std::to_string(beam) +
                         " m, and the whole hull only " + std::to_string(length) + " m; lengthen it");
    if (!(std::max(beam / 16, beam / 2 * slope) < height))
        throw InputError("Fridsma's hull: its chines lie " + std::to_string(beam / 2 * slope) +
                         " m above the keel, at or above its deck at height = " + std::to_string(height) +
                         " m; raise the height or lower the deadrise");
    constexpr int stations = 40;
    std::vector<HalfSection> sections;
    const auto station = [&](double x, double ellipse) {
        const double y = beam / 2 * ellipse, keel = beam / 16 * (1 - ellipse);
        sections.push_back({{x, 0, keel}, {x, y, keel + y * slope}, {x, y, height}, {x, 0, height}});
    };
    for (int i = stations; i >= 0; --i) {
        const double angle = 0.5 * std::numbers::pi * i / stations;  // u = sin
        station(-length / 2 + beam * (1 - std::sin(angle)), i == stations ? 0 : std::cos(angle));
    }
    station(length / 2, 1);
    return loft(sections);
}
}  // namespace

HullShape fridsma_shape() {
    return {"fridsma",
            "Fridsma's planing hull: V-bottom with hard chines and a bow of elliptic plan, one beam long",
            {{"length", "m", "over all", 1.143, 1e-3, 500},
             {"beam", "m", "over the chines", 0.2286, 1e-3, 100},
             {"deadrise", "rad", "angle of the bottom with the horizontal", 20 * degree, 0, 50 * degree},
             {"height", "m", "from the keel to the deck", 0.142875, 1e-4, 100}},
            make_fridsma};
}

}  // namespace tw
