#pragma once
#include "sph_solver/pair_loops/reach.h"

// Who is within reach of a cluster's particles, on a device: a thread asks for one place of a block.
namespace tw {
namespace TW_ISA {
namespace {

/// Of the warp's cluster.
inline const ClusterReach& reach_of_warp(const PackedPlace* places, const Cluster& g, const Reaches& reaches) {
    ClusterReach& r = *device::room_of_warp<ClusterReach, 1>();
    device::sync_warp();
    if (const int l = device::thread(); l < lanes) note_lane(r, l, places[in_lane(g, l)], g);
    if (device::thread() == 0) note_reaches(r, g, reaches);
    device::sync_warp();
    return r;
}
inline float distance2(const ClusterReach& g, const PackedPlace& p) {
    return distance2(g, static_cast<float>(difference(p.x, g.x)), static_cast<float>(difference(p.y, g.y)),
                     static_cast<float>(difference(p.z, g.z)))
        .v;
}

}  // namespace

/// As that of search.h, which says more.
template <>
void pass(const PruneData& d, const Cluster* clusters, int count) {
    const int thread = device::thread();
    for (int n = first_cluster(); n < count; n = next_cluster(n)) {
        const Cluster& g = clusters[n];
        const ListRef& list = g.*d.list;
        if (list.size == 0) continue;
        const ClusterReach& own = reach_of_warp(d.of, g, Reaches{0, d.reach, 0});
        NeighbourBlock* const blocks = d.lists.blocks(list);
        for (int k = 0; k < list.size; ++k) {
            NeighbourBlock& b = blocks[k];
            const std::uint32_t maybe = b.maybe;
            if (maybe == 0) continue;
            const bool asked = (maybe >> thread & 1) != 0;
            const std::uint32_t within =
                device::threads_where(asked && distance2(own, d.place[b.first + thread]) < own.now2);
            if (thread == 0) b.live = (b.live & ~maybe) | within;
        }
    }
}

}  // namespace TW_ISA
}  // namespace tw
