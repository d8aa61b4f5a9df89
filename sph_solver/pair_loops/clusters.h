#pragma once
#include <cstdint>

namespace tw {

// Clusters of particles and whom they meet: plain data that may be copied and sent to another device.

/// Neighbours: of the 32 places from `first` on, those whose bit is set. Sorted places lie in runs, so that a neighbour
/// costs two bytes instead of an index's four and a list is a quarter as long.
struct NeighbourBlock {
    std::int32_t first;
    std::uint32_t live;   ///< what the pair loops visit: who is within reach now or might be
    std::uint32_t maybe;  ///< who may come and go before the lists are made anew; asked by the `prune` pass
};

/// Where a cluster's blocks are: `size` of them from `first` on in one chunk of Lists.
struct ListRef {
    std::int32_t chunk = 0, first = 0, size = 0;
};
/// The storage that ListRefs refer to.
struct Lists {
    NeighbourBlock* const* chunks = nullptr;
    NeighbourBlock* blocks(const ListRef& r) const { return r.size > 0 ? chunks[r.chunk] + r.first : nullptr; }
};

inline constexpr int most_lanes = 16;

/// A cluster of up to Passes::lanes particles that are neighbours in space and in memory.
struct Cluster {
    std::int32_t first = 0, size = 0;  ///< particles [first, first + size)
    ListRef list;                      ///< its neighbours among particles and mirror images
    ListRef wall_list;                 ///< its neighbours among the wall's dummy particles
    std::int32_t wall_load = -1;       ///< index of its first WallLoad; -1: no wall near
    std::int32_t x = 0, y = 0, z = 0;  ///< centre, in fixed-point units: pair coordinates are relative to it
};
static_assert(sizeof(Cluster) == 48);

/// Decides whether a place x is within reach of a cluster's particles x_l, all relative to its centre [fixed-point
/// units]: |x - x_l|^2 = |x|^2 + (n_l + a_l x + b_l y + c_l z), n = |x_l|^2, (a, b, c) = -2 x_l. Lanes beyond its size
/// repeat the last particle. Good to a millionth of the reach for a cluster of water; spray may stand hundreds of
/// spacings apart in one cluster, and then who is at the reach's rim, where the kernel vanishes, is known to 1e-4 of it
/// only.
struct alignas(64) ClusterReach {
    float n[most_lanes], a[most_lanes], b[most_lanes], c[most_lanes];
    std::int32_t x, y, z;     ///< the cluster's centre
    float far2, now2, sure2;  ///< squared reaches [fixed-point units^2]
};

/// Who is on a list: within `far`, so that the list lasts a while; live at first: within `now`; never asked again:
/// within `sure`, because nobody goes so far before the list is made anew. `stale`: how far the sources may have moved
/// since they were sorted. Lengths in whatever unit their user says.
struct Reaches {
    double far, now, sure, stale = 0;
    Reaches operator/(double unit) const { return {far / unit, now / unit, sure / unit, stale / unit}; }
};
struct Reached {
    std::uint32_t far, now, sure;
};

}  // namespace tw
