#include "compare/reference/planing_plate.h"

#include <fmt/format.h>

#include <cmath>

#include "compare/read/record_numbers.h"
#include "compare/reference/prismatic_hull.h"
#include "record/planing_plate.h"

namespace tw {

std::vector<Reference> planing_plate_references(const RunRecord& record) {
    const double depth = number_of(record, "depth", 0);
    if (number_of(record, "dimensions", 3) != 2 || number_of(record, "gravity", 9.81) != 0 || !(depth > 0)) return {};
    const std::optional<PrismaticHull> hull = prismatic_hull(record);
    constexpr double flat = 0.01;  // [rad]
    if (!hull || hull->state.deadrise > flat) return {};
    const PlaningState& s = hull->state;
    const std::optional<PlaningPlate> plate = planing_plate_at(s.trim, -hull->draft / depth);
    if (!plate) return {};
    const double N = plate->force * s.density * s.speed * s.speed * depth;
    const std::string remark =
        fmt::format("exact for an endless plate, without air; jet {:.4g} m thick", plate->delta * depth);
    const auto reference = [&](const char* quantity, double value) {
        return Reference{quantity, "N/m", "free streamlines", value, 0, remark, true};
    };
    return {reference("lift", N * std::cos(s.trim)), reference("drag", N * std::sin(s.trim))};
}

}  // namespace tw
