#include "scene/solids/walls_met.h"

#include <cmath>

namespace tw {

std::vector<MetWall> walls_met(const MovingBody& body, const Scene& scene) {
    static constexpr const char* names[3][2] = {{"the wall at low x", "the wall at high x"},
                                                {"the wall at low y", "the wall at high y"},
                                                {"the floor", "the lid"}};
    if (!body.free_and_rigid() || scene.motion.kind != Motion::Kind::none) return {};
    const Domain& d = scene.domain;
    const Side sides[3][2] = {{d.x_min, d.x_max}, {d.y_min, d.y_max}, {d.z_min, d.z_max}};
    std::vector<MetWall> met;
    for (int a = 0; a < 3; ++a)
        for (const bool high : {false, true}) {
            if (sides[a][high] != Side::slip_wall) continue;
            const Vec3 normal = (high ? -1 : 1) * Vec3::Unit(a);
            met.push_back({names[a][high], {normal, high ? -d.box.max[a] : d.box.min[a]}, a, high});
        }
    return met;
}

double touching(const Scene& scene) { return 1e-6 * scene.domain.box.size().maxCoeff(); }

std::vector<MetWall> walls_touched(const MovingBody& body, const Scene& scene) {
    const Box at = body.surface.bounds();
    std::vector<MetWall> touched;
    for (const MetWall& wall : walls_met(body, scene)) {
        const Vec3& nearest = wall.high ? at.max : at.min;
        if (std::abs(wall.plane.normal.dot(nearest) - wall.plane.offset) <= touching(scene)) touched.push_back(wall);
    }
    return touched;
}

}  // namespace tw
