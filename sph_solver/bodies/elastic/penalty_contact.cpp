#include "sph_solver/bodies/elastic/penalty_contact.h"

#include "sph_solver/bodies/elastic/elastic_body.h"

namespace tw {

std::vector<WallPush> add_penalty_contact(const std::vector<Body>& bodies, const Particles& p, Records& records,
                                          double dp, double mass) {
    std::vector<WallPush> pushes;
    for (std::size_t i = 0; i < p.size(); ++i) {  // in order: the sums keep their bits
        const WallNormalRecord& n = records.wall_normal[i];
        const double penetration = Coupling::reach(dp) - double(n.distance);
        if (penetration <= 0 || p.kind[i] != Kind::fluid) continue;
        const std::size_t b = records.wall_body[i];
        const ElasticBody* const body = bodies[b].elastic();
        if (!body || body->setup().coupling.kind != Coupling::Kind::penalty) continue;
        const Vec3 place(p.x[i], p.y[i], p.z[i]),
            force = body->setup().coupling.force(penetration, dp) * Vec3(n.x, n.y, n.z);
        RateRecord& rate = records.rate[i];
        rate.ax += static_cast<float>(force.x() / mass);
        rate.ay += static_cast<float>(force.y() / mass);
        rate.az += static_cast<float>(force.z() / mass);
        pushes.push_back({b, records.wall_triangle[i], place, -force});
    }
    return pushes;
}

}  // namespace tw
