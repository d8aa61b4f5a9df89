#include "record/wet_wall.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace tw {

void WetWall::add(const Vec3& area, double pressure, bool wet) {
    const double size = area.norm();
    if (!(size > 0)) return;
    faces_.push_back({std::clamp(-area.z() / size, -1.0, 1.0), size});
    if (!wet) return;
    wet_area_ += size;
    if (pressure >= 0) return;
    suction_area_ += size;
    suction_force_ -= pressure * size;
}

double WetWall::leaving_angle() const {
    if (!(wet_area_ > 0)) return 0;
    std::vector<Face> steepest_first = faces_;
    std::ranges::sort(steepest_first, [](const Face& a, const Face& b) { return a.down > b.down; });
    double area = 0;
    for (const Face& face : steepest_first)
        // half a face: up to its middle
        if (area += face.area; area - face.area / 2 >= wet_area_) return std::acos(face.down);
    return pi;
}

}  // namespace tw
