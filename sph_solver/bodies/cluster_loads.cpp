#include "sph_solver/bodies/cluster_loads.h"

namespace tw {

void add_cluster_loads(std::span<const Cluster> clusters, std::span<const WallLoad> of_clusters,
                       const std::function<Vec3(const Cluster&)>& arm, std::span<PushSum> of_bodies) {
    std::size_t slot = 0;
    for (std::size_t n = 0, next = 0; n < clusters.size(); n = next) {
        for (next = n + 1; next < clusters.size() && clusters[next].wall_load < 0;) ++next;
        const Cluster& g = clusters[n];
        if (g.wall_load < 0) continue;
        // its slots end where those of the next cluster with walls begin
        const std::size_t end =
            next < clusters.size() ? static_cast<std::size_t>(clusters[next].wall_load) : of_clusters.size();
        const Vec3 centre = arm(g);
        for (; slot < end; ++slot) {
            const WallLoad& w = of_clusters[slot];
            PushSum& sum = of_bodies[static_cast<std::size_t>(w.body)];
            sum.add(Vec3(w.ax, w.ay, w.az), centre);
            sum.turn += Vec3(w.mx, w.my, w.mz);
        }
    }
}

}  // namespace tw
