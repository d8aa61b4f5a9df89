#include "sph_solver/bodies/wall_pushes.h"

namespace tw {

WallPushes wall_pushes(const Bodies& bodies, const Particles& p, std::span<const std::int32_t> near, double dp,
                       double mass) {
    WallPushes all;
    for (const std::int32_t index : near) {  // in order: the sums keep their bits
        const auto i = static_cast<std::size_t>(index);
        const PackedWallNormal& n = p.wall_normal[i];
        const std::size_t b = p.wall_body[i];
        const double pressing = bodies[b]->pressing(double(n.distance), dp);
        if (pressing <= 0) continue;
        const Vec3 force = pressing * Vec3(n.x, n.y, n.z);
        const Eigen::Vector3f acceleration = (force / mass).cast<float>();
        all.by.push_back(index);
        all.accelerations.push_back({acceleration.x(), acceleration.y(), acceleration.z()});
        all.pushes.push_back({b, p.wall_triangle[i], Vec3(p.x[i], p.y[i], p.z[i]), -force});
    }
    return all;
}

}  // namespace tw
