#include "sph_solver/bodies/group_loads.h"

namespace tw {

void add_group_loads(std::span<const Group> groups, std::span<const WallLoad> of_groups,
                     const std::function<Vec3(const Group&)>& arm, std::span<PushSum> of_bodies) {
    std::size_t slot = 0;
    for (std::size_t n = 0, next = 0; n < groups.size(); n = next) {
        for (next = n + 1; next < groups.size() && groups[next].wall_load < 0;) ++next;
        const Group& g = groups[n];
        if (g.wall_load < 0) continue;
        // its slots end where those of the next group with walls begin
        const std::size_t end =
            next < groups.size() ? static_cast<std::size_t>(groups[next].wall_load) : of_groups.size();
        const Vec3 centre = arm(g);
        for (; slot < end; ++slot) {
            const WallLoad& w = of_groups[slot];
            PushSum& sum = of_bodies[static_cast<std::size_t>(w.body)];
            sum.add(Vec3(w.ax, w.ay, w.az), centre);
            sum.turn += Vec3(w.mx, w.my, w.mz);
        }
    }
}

}  // namespace tw
