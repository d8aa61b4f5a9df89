#include "compare/metrics/numerical_drag.h"

#include <algorithm>
#include <cmath>

#include "compare/read/record_numbers.h"

namespace tw {

std::optional<NumericalDrag> numerical_drag(const RunRecord& record) {
    const double speed = number_of(record, "speed", 0), dp = number_of(record, "near_hull", 0);
    const bool flat = number_of(record, "dimensions", 3) == 2;  // a section has no frontal area
    if (flat || !(speed > 0) || !(dp > 0) || record.hull.triangles.empty()) return {};
    const Box hull = record.hull.bounds();
    if (hull.max.z() >= 0) return {};
    NumericalDrag d;
    d.spacings = std::min(hull.size().y(), hull.size().z()) / dp;
    if (!(d.spacings > 0)) return {};
    d.coefficient = 1.65 / d.spacings;
    double area = 0;  // what faces the stream
    for (int t = 0; t < static_cast<int>(record.hull.triangles.size()); ++t)
        area += std::max(0.0, -record.hull.area_vector2(t).x() / 2);
    d.force = d.coefficient * 0.5 * number_of(record, "density", 1000) * speed * speed * area;
    return d;
}

}  // namespace tw
