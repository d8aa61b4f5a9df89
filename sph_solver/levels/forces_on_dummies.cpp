#include "sph_solver/levels/forces_on_dummies.h"

#include <bit>

#include "sph_solver/backend/for_particles.h"

namespace tw {

std::vector<Vec3> forces_on_dummies(Level& level, std::size_t body) {
    const WaterView water = level.water_view();
    const WallView walls = level.wall_view();
    const Walls::Part& part = level.walls().parts()[body];
    const auto end = static_cast<std::size_t>(level.walls().body_end()[body]);
    const auto own = static_cast<std::int32_t>(level.particles().size());
    const double quantum = level.quanta().size;
    const Lists lists = part.water.view();
    std::vector<Vec3> forces(end - part.first, Vec3::Zero());
    const auto force_on = [&](std::size_t j, const Group& g) {
        const PlaceRecord& at = walls.place[j];
        Vec3 sum = Vec3::Zero();
        const NeighbourBlock* const blocks = lists.blocks(g.list);
        for (std::int32_t b = 0; b < g.list.size; ++b)
            for (std::uint32_t bits = blocks[b].live; bits != 0; bits &= bits - 1) {
                const std::int32_t i = blocks[b].first + std::countr_zero(bits);
                if (i >= own) continue;
                const PlaceRecord& of = water.place[i];
                const Vec3 r = quantum * Vec3(difference(at.x, of.x), difference(at.y, of.y), difference(at.z, of.z));
                const double r2 = r.squaredNorm(), support = water.kernel.support();
                if (r2 >= support * support) continue;
                sum += double(of.volume) * (double(water.stress[i].p) + double(walls.p[j])) *
                       water.kernel.F(std::sqrt(r2)) * r;
            }
        return Vec3(double(at.volume) * sum);
    };
    for_groups(part.near_water, [&](const Group& g) {
        for (std::int32_t l = 0; l < g.size; ++l) {
            const auto k = static_cast<std::size_t>(g.first + l);
            forces[k] = force_on(part.first + k, g);
        }
    });
    // each by the rank whose column it stands in, nothing on the others
    std::vector<double> sums(3 * forces.size());
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = forces[k / 3][static_cast<int>(k % 3)];
    level.ranks().take_from_owners(std::span(sums));
    for (std::size_t k = 0; k < sums.size(); ++k) forces[k / 3][static_cast<int>(k % 3)] = sums[k];
    return forces;
}

}  // namespace tw
