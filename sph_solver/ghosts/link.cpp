#include "sph_solver/ghosts/link.h"

namespace tw {

namespace {

constexpr unsigned low = 1, high = 2, moved = 4;

unsigned number(unsigned on_axis, std::size_t axis) { return on_axis << (3 * axis); }
unsigned on_axis(std::size_t number, std::size_t axis) { return static_cast<unsigned>(number >> (3 * axis)) & 7u; }

}  // namespace

LinkMaps::LinkMaps(const Mirrors& mirrors, const Box& domain, const Quanta& quanta) {
    for (std::size_t n = 0; n < maps_.size(); ++n) {
        LinkMap& m = maps_[n];
        for (std::size_t a = 0; a < 3; ++a) {
            const unsigned face = on_axis(n, a) & (low | high);
            if (face == 0) continue;
            const auto axis = static_cast<int>(a);
            const std::int64_t at_low = quanta.wide(domain.min[axis], axis),
                               at_high = quanta.wide(domain.max[axis], axis);
            if ((on_axis(n, a) & moved) != 0) {
                m.offset[a] = face == low ? at_low - at_high : at_high - at_low;
                m.repeats[a] = true;
                continue;
            }
            m.offset[a] = 2 * (face == low ? at_low : at_high);
            m.turn[a] = -1;
            m.sign[a] = -1;
            m.held[a] *= -1;
            if (mirrors.holding[a][face == low ? 0 : 1])
                for (std::size_t along = 0; along < 3; ++along)
                    if (along != a) m.held[along] *= -1;
        }
    }
}

std::vector<Link> find_images(const Mirrors& mirrors, const Box& domain, const Particles& p, double reach) {
    std::vector<Link> images;
    const std::vector<double>* coordinate[3] = {&p.x, &p.y, &p.z};
    for (std::size_t i = 0; i < p.size(); ++i) {
        unsigned choices[3][3], count[3];
        for (std::size_t a = 0; a < 3; ++a) {
            const double x = (*coordinate[a])[i];
            choices[a][0] = 0;
            count[a] = 1;
            const auto axis = static_cast<int>(a);
            const bool near_low = x - domain.min[axis] < reach, near_high = domain.max[axis] - x < reach;
            if (mirrors.periodic[a]) {
                if (near_high) choices[a][count[a]++] = low | moved;
                if (near_low) choices[a][count[a]++] = high | moved;
                continue;
            }
            if (mirrors.on[a][0] && near_low) choices[a][count[a]++] = low;
            if (mirrors.on[a][1] && near_high) choices[a][count[a]++] = high;
        }
        for (unsigned c = 0; c < count[2]; ++c)
            for (unsigned b = 0; b < count[1]; ++b)
                for (unsigned a = 0; a < count[0]; ++a) {
                    const unsigned map = number(choices[0][a], 0) | number(choices[1][b], 1) | number(choices[2][c], 2);
                    if (map) images.push_back({static_cast<std::int32_t>(i), static_cast<std::uint16_t>(map)});
                }
    }
    return images;
}

}  // namespace tw
