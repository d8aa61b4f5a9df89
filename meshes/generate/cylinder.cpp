#include <cmath>
#include <numbers>

#include "meshes/generate/loft.h"
#include "meshes/generate/shapes.h"

namespace tw {
namespace {
/// The outline is a regular polygon inscribed in the circle; its area is sin(2 pi / n) / (2 pi / n) of the circle's.
Surface make_cylinder(const std::map<std::string, double>& v) {
    const double radius = v.at("diameter") / 2, half_span = v.at("span") / 2;
    const int half_turn = static_cast<int>(v.at("segments")) / 2;
    std::vector<HalfSection> sections;
    for (int i = 0; i <= half_turn; ++i) {
        // sin and cos of exact fractions: the ends collapse to a line and the polygon is symmetric to the last bit
        const int mirrored = std::min(i, half_turn - i);
        const double angle = std::numbers::pi * mirrored / half_turn;
        const double x = radius * std::cos(angle) * (i <= half_turn - i ? -1 : 1), h = radius * std::sin(angle);
        sections.push_back({{2 * i == half_turn ? 0 : x, 0, radius - h},
                            {2 * i == half_turn ? 0 : x, half_span, radius - h},
                            {2 * i == half_turn ? 0 : x, half_span, radius + h},
                            {2 * i == half_turn ? 0 : x, 0, radius + h}});
    }
    return loft(sections);
}
}  // namespace

HullShape cylinder_shape() {
    return {"cylinder",
            "circular cylinder lying across the stream, axis along y",
            {{"diameter", "m", "", 0.05, 1e-4, 100},
             {"span", "m", "along y", 0.2, 1e-4, 500},
             {"segments", "-", "sides of the polygon", 128, 8, 4096}},
            make_cylinder};
}

}  // namespace tw
