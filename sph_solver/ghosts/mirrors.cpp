#include "sph_solver/ghosts/mirrors.h"

namespace tw {

std::vector<MirrorImage> make_mirror_images(const Mirrors& mirrors, const Box& domain, const Particles& p,
                                            double reach) {
    std::vector<MirrorImage> images;
    const std::vector<double>* coordinate[3] = {&p.x, &p.y, &p.z};
    for (std::size_t i = 0; i < p.size(); ++i) {
        int choices[3][3], count[3];
        for (int a = 0; a < 3; ++a) {
            const double x = (*coordinate[a])[i];
            choices[a][0] = 0;
            count[a] = 1;
            const auto axis = static_cast<std::size_t>(a);
            const bool near_low = x - domain.min[a] < reach, near_high = domain.max[a] - x < reach;
            if (mirrors.periodic[axis]) {
                if (near_high) choices[a][count[a]++] = 1 | 4;
                if (near_low) choices[a][count[a]++] = 2 | 4;
                continue;
            }
            if (mirrors.on[axis][0] && near_low) choices[a][count[a]++] = 1;
            if (mirrors.on[axis][1] && near_high) choices[a][count[a]++] = 2;
        }
        for (int c = 0; c < count[2]; ++c)
            for (int b = 0; b < count[1]; ++b)
                for (int a = 0; a < count[0]; ++a) {
                    const int planes = choices[0][a] | choices[1][b] << 3 | choices[2][c] << 6;
                    if (planes) images.push_back({static_cast<std::int32_t>(i), static_cast<std::uint16_t>(planes)});
                }
    }
    return images;
}

MirrorPlanes::MirrorPlanes(const Box& domain, const Quanta& quanta) {
    for (std::size_t planes = 0; planes < maps_.size(); ++planes) {
        const MirrorImage image{0, static_cast<std::uint16_t>(planes)};
        Map& m = maps_[planes];
        for (int a = 0; a < 3; ++a) {
            if (image.plane(a) == 0) continue;
            const std::int64_t low = quanta.wide(domain.min[a], a), high = quanta.wide(domain.max[a], a);
            const bool at_low = image.plane(a) == 1;
            if (image.moved(a)) {
                m.offset[a] = at_low ? low - high : high - low;
            } else {
                m.offset[a] = 2 * (at_low ? low : high);
                m.turn[a] = -1;
            }
        }
    }
}

std::int64_t return_from_mirrors(const Mirrors& mirrors, const Box& domain, Particles& p) {
    std::vector<double>* coordinate[3] = {&p.x, &p.y, &p.z};
    std::vector<float>* velocity[3] = {&p.u, &p.v, &p.w};
    std::int64_t returned = 0;
    for (int a = 0; a < 3; ++a) {
        if (mirrors.periodic[static_cast<std::size_t>(a)])
            for (double& x : *coordinate[a]) {
                const double length = domain.max[a] - domain.min[a];
                const double back = x < domain.min[a] ? length : x >= domain.max[a] ? -length : 0;
                x += back;
                returned += back != 0;
            }
        for (int side = 0; side < 2; ++side) {
            if (!mirrors.on[static_cast<std::size_t>(a)][static_cast<std::size_t>(side)]) continue;
            const double plane = side == 0 ? domain.min[a] : domain.max[a];
            for (std::size_t i = 0; i < p.size(); ++i) {
                double& x = (*coordinate[a])[i];
                if (side == 0 ? x >= plane : x <= plane) continue;
                x = 2 * plane - x;
                (*velocity[a])[i] = -(*velocity[a])[i];
                ++returned;
            }
        }
    }
    return returned;
}

}  // namespace tw
