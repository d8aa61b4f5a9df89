#include "sph_solver/ghosts/link.h"

namespace tw {

namespace {

constexpr unsigned low = ImagesNear::low, high = ImagesNear::high, moved = ImagesNear::moved;

unsigned on_axis(std::size_t number, std::size_t axis) { return static_cast<unsigned>(number >> (3 * axis)) & 7u; }

}  // namespace

LinkMaps::LinkMaps(const Mirrors& mirrors, const Box& domain, const FixedPoint& fixed_point) {
    for (std::size_t n = 0; n < maps_.size(); ++n) {
        LinkMap& m = maps_[n];
        for (std::size_t a = 0; a < 3; ++a) {
            const unsigned face = on_axis(n, a) & (low | high);
            if (face == 0) continue;
            const auto axis = static_cast<int>(a);
            const std::int64_t at_low = fixed_point.wide(domain.min[axis], axis),
                               at_high = fixed_point.wide(domain.max[axis], axis);
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

Faces faces_of(const Mirrors& mirrors, const Box& domain) {
    Faces f;
    for (std::size_t a = 0; a < 3; ++a) {
        f.low[a] = domain.min[static_cast<int>(a)], f.high[a] = domain.max[static_cast<int>(a)];
        f.periodic[a] = mirrors.periodic[a];
        for (std::size_t side = 0; side < 2; ++side) f.mirror[a][side] = mirrors.on[a][side];
    }
    return f;
}

std::vector<Link> find_images(const Mirrors& mirrors, const Box& domain, const Particles& p, double reach) {
    std::vector<Link> images;
    const ImagesNear near{faces_of(mirrors, domain), reach};
    for (std::size_t i = 0; i < p.size(); ++i)
        near(p.x[i], p.y[i], p.z[i], [&](unsigned number) {
            images.push_back({static_cast<std::int32_t>(i), static_cast<std::uint16_t>(number)});
        });
    return images;
}

}  // namespace tw
