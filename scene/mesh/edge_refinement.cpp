#include "scene/mesh/edge_refinement.h"

#include <algorithm>

namespace tw {

EdgeRefinement edge_refinement(const Scene& scene) {
    EdgeRefinement r;
    if (!scene.hull || scene.hull->section || scene.domain.dimensions != 3 || scene.motion.kind != Motion::Kind::stream)
        return r;
    // A planing hull wets its chine higher than still water: at the most by pi/2 - 1 of its depth (Wagner 1932).
    Box wet = scene.domain.box;
    wet.max.z() = std::min(wet.max.z(), 0.5 * scene.hull->draft);
    r.edges = shedding_edges(scene.hull->surface, wet);
    if (r.edges.empty()) return r;
    r.halvings = 1;
    r.reach = scene.resolution.near_hull;
    return r;
}

}  // namespace tw
