#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "meshes/generate/loft.h"
#include "meshes/generate/shapes.h"

namespace tw {
namespace {
/// A body of revolution about x: half-ellipsoid head, cylinder, conical tail with a flat end. The lines of the torpedo
/// in the water-entry study of Cai et al. 2024 (doi:10.3390/app14114441) are not public. Length and diameter are
/// theirs; the tail is chosen so that the volume is that of their weight (1.848 kN: 0.1884 m3 of water), less than a
/// hemisphere and a cylinder.
Surface make_torpedo(const std::map<std::string, double>& v) {
    const double length = v.at("length"), radius = v.at("diameter") / 2, head = v.at("head_length"),
                 tail = v.at("tail_length"), end_radius = v.at("tail_diameter") / 2;
    if (!(head + tail < length))
        throw InputError("torpedo: head_length + tail_length = " + std::to_string(head + tail) +
                         " m; expected less than its length, " + std::to_string(length) + " m");
    if (!(end_radius <= radius)) throw InputError("torpedo: tail_diameter is larger than its diameter");
    constexpr int head_rows = 16, body_rows = 24, tail_rows = 12, half_turn = 24;
    std::vector<std::pair<double, double>> outline;  // (x from the nose, radius)
    for (int i = 0; i < head_rows; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / head_rows;
        outline.emplace_back(head * (1 - std::cos(angle)), radius * std::sin(angle));
    }
    const double body = length - head - tail;
    for (int i = 0; i < body_rows; ++i) outline.emplace_back(head + body * i / body_rows, radius);
    for (int i = 0; i <= tail_rows; ++i)
        outline.emplace_back(head + body + tail * i / tail_rows, radius + (end_radius - radius) * i / tail_rows);

    std::vector<HalfSection> sections;
    for (const auto& [x, r] : outline) {
        HalfSection section;
        for (int k = 0; k <= half_turn; ++k) {
            const double angle = std::numbers::pi * k / half_turn;
            const bool on_axis_plane = k == 0 || k == half_turn;
            section.emplace_back(x - length / 2, on_axis_plane ? 0 : r * std::sin(angle), radius - r * std::cos(angle));
        }
        sections.push_back(std::move(section));
    }
    return loft(sections);
}
}  // namespace

HullShape torpedo_shape() {
    return {"torpedo",
            "torpedo with the main dimensions of a published water-entry study; a stand-in, its lines are not public",
            {{"length", "m", "", 2.79, 1e-2, 100},
             {"diameter", "m", "", 0.32, 1e-3, 50},
             {"head_length", "m", "of the half-ellipsoid head; half the diameter: hemisphere", 0.16, 1e-3, 50},
             {"tail_length", "m", "of the conical tail", 0.722, 1e-3, 50},
             {"tail_diameter", "m", "of the tail's flat end", 0.096, 1e-3, 50}},
            make_torpedo};
}

}  // namespace tw
