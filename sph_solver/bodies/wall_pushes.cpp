#include "sph_solver/bodies/wall_pushes.h"

namespace tw {

WallPushes add_wall_pushes(const Bodies& bodies, Particles& p, double dp, double mass) {
    WallPushes all;
    for (std::size_t i = 0; i < p.size(); ++i) {  // in order: the sums keep their bits
        const WallNormalRecord& n = p.wall_normal[i];
        if (double(n.distance) >= dp || p.kind[i] != Kind::fluid) continue;
        const std::size_t b = p.wall_body[i];
        const double pressing = bodies[b]->pressing(double(n.distance), dp);
        if (pressing <= 0) continue;
        const Vec3 force = pressing * Vec3(n.x, n.y, n.z);
        RateRecord& rate = p.rate[i];
        rate.ax += static_cast<float>(force.x() / mass);
        rate.ay += static_cast<float>(force.y() / mass);
        rate.az += static_cast<float>(force.z() / mass);
        all.by.push_back(i);
        all.pushes.push_back({b, p.wall_triangle[i], Vec3(p.x[i], p.y[i], p.z[i]), -force});
    }
    return all;
}

}  // namespace tw
