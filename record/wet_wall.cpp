#include "record/wet_wall.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace tw {

void WetWall::add(const Vec3& area, double pressure, bool wet, double gap) {
    const double size = area.norm();
    if (!(size > 0)) return;
    faces_.push_back({std::clamp(-area.z() / size, -1.0, 1.0), size, gap});
    if (!wet || pressure >= 0) return;
    suction_area_ += size;
    suction_force_ -= pressure * size;
}

double WetWall::angle_within(double gap) const {
    double wet_area = 0;
    for (const Face& face : faces_)
        if (face.gap <= gap) wet_area += face.area;
    if (!(wet_area > 0)) return 0;
    std::vector<Face> steepest_first = faces_;
    std::ranges::sort(steepest_first, [](const Face& a, const Face& b) { return a.down > b.down; });
    double area = 0;
    for (const Face& face : steepest_first)
        // half a face: up to its middle
        if (area += face.area; area - face.area / 2 >= wet_area) return std::acos(face.down);
    return pi;
}

double WetWall::leaving_angle() const {
    // Near enough for the law to hold and for the line to be still near, far enough to be told from no gap.
    constexpr double near = 0.2, far = 0.6;  // [spacings]
    const double at_near = angle_within(near), at_far = angle_within(far), ratio = std::pow(near / far, 0.4);
    return std::max(0.0, at_near - (at_far - at_near) * ratio / (1 - ratio));
}

}  // namespace tw
