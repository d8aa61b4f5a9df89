#pragma once
// Sorting places into the order of neighbours/pencils.h, with their images and in clusters, as a device does it: plain
// data for kernels, as in tasks.h. The order is a function of the places alone, whoever came first.
#include <cstddef>
#include <cstdint>

#include "sph_solver/fields/field_list.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/cross.h"
#include "sph_solver/loops/link_map.h"
#include "sph_solver/neighbours/pencil_grid.h"
#include "sph_solver/pair_loops/clusters.h"

namespace tw::cuda {

/// A pencil cut into bins of some height: sorted within a bin, and bin by bin, places are sorted within a pencil.
struct Bins {
    Pencils pencils;
    std::int64_t height;  ///< [fixed-point units]
    int in_pencil;

    int count() const { return pencils.count() * in_pencil; }
    int of(const WidePlace& p) const {
        const int slab = pencils.slab(p.z);
        const std::int64_t bin = (p.z - (pencils.z0 + slab * pencils.height)) / height;
        const int in = p.z < pencils.z0 || bin < 0 ? 0 : bin >= in_pencil ? in_pencil - 1 : static_cast<int>(bin);
        return pencils.of(p) * in_pencil + in;
    }
};

// --- sorting

/// Gives each place a slot in its bin, in the order of whoever comes; those that have left get none.
struct CountInBins {
    Bins bins;
    const WidePlace* wide;
    const std::uint8_t* left;  ///< null: nobody has
    int *bin, *slot, *count;

    template <class AddOne>
    void operator()(std::size_t k, const AddOne& add_one) const {
        bin[k] = -1;
        if (left && left[k]) return;
        bin[k] = bins.of(wide[k]);
        slot[k] = add_one(count + bin[k]);
    }
};
struct PutInBins {
    const int *bin, *slot, *start;
    int* member;

    void operator()(std::size_t k) const {
        if (bin[k] >= 0) member[start[bin[k]] + slot[k]] = static_cast<int>(k);
    }
};
/// Where each place comes in its bin: by z, x, y, and of the same place by `tie`.
struct RankInBins {
    const WidePlace* wide;
    const std::int64_t* tie;  ///< null: the index
    const int *bin, *start, *member;
    int* order;

    bool first(int a, int b) const {
        const WidePlace &p = wide[a], &q = wide[b];
        if (p.z != q.z) return p.z < q.z;
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        return tie ? tie[a] < tie[b] : a < b;
    }
    void operator()(std::size_t k) const {
        if (bin[k] < 0) return;
        const int self = static_cast<int>(k), from = start[bin[k]], end = start[bin[k] + 1];
        int rank = 0;
        for (int m = from; m < end; ++m) rank += first(member[m], self);
        order[from + rank] = self;
    }
};

/// What stays with the particles, in their new order.
struct Reorder {
    const int* order;
    FieldsView from, to;

    void operator()(std::size_t k) const { to.copy(k, from, static_cast<std::size_t>(order[k])); }
};

// --- images

struct CountImages {
    StateView p;
    ImagesNear near;
    int* count;

    void operator()(std::size_t i) const {
        int n = 0;
        near(p.x[i], p.y[i], p.z[i], [&](unsigned) { ++n; });
        count[i] = n;
    }
};
struct FindImages {
    StateView p;
    ImagesNear near;
    const LinkMap* maps;
    ToFixedPoint to_fixed_point;
    const int* first;
    Link* links;
    WidePlace* wide;

    void operator()(std::size_t i) const {
        int k = first[i];
        const WidePlace own = to_fixed_point.wide(p.x[i], p.y[i], p.z[i]);
        near(p.x[i], p.y[i], p.z[i], [&](unsigned number) {
            links[k] = {static_cast<std::int32_t>(i), static_cast<std::uint16_t>(number)};
            wide[k++] = maps[number].place(own);
        });
    }
};
struct ReorderLinks {
    const int* order;
    const Link* from;
    Link* to;

    void operator()(std::size_t k) const { to[k] = from[order[k]]; }
};

// --- clusters

constexpr int lanes_of_cluster = 8;

struct CountClusters {
    const int* start;  ///< of bins
    int in_pencil;
    const char* wanted;  ///< of each pencil; null: all are
    int* count;

    void operator()(std::size_t c) const {
        if (wanted && !wanted[c]) {
            count[c] = 0;
            return;
        }
        const auto of = [&](std::size_t pencil) { return start[pencil * static_cast<std::size_t>(in_pencil)]; };
        count[c] = (of(c + 1) - of(c) + lanes_of_cluster - 1) / lanes_of_cluster;
    }
};
struct MakeClusters {
    const int* start;
    int in_pencil;
    const char* wanted;  ///< as of CountClusters
    const int* first;    ///< cluster of each pencil
    Cluster* clusters;
    int* pencil;  ///< of each cluster

    void operator()(std::size_t c) const {
        if (wanted && !wanted[c]) return;
        const int end = start[(c + 1) * static_cast<std::size_t>(in_pencil)];
        int at = start[c * static_cast<std::size_t>(in_pencil)];
        for (int g = first[c]; at < end; ++g, at += lanes_of_cluster) {
            Cluster cluster;
            cluster.first = at, cluster.size = end - at < lanes_of_cluster ? end - at : lanes_of_cluster;
            clusters[g] = cluster, pencil[g] = static_cast<int>(c);
        }
    }
};

/// A box round a cluster [fixed-point units].
struct ClusterBox {
    std::int64_t lo[3], hi[3];
};
inline ClusterBox box_of(const PackedPlace* places, const Cluster& g, const WidePlace& from) {
    const auto in_full = [](std::int32_t x, std::int64_t near) {
        return near + difference(x, static_cast<std::int32_t>(near));
    };
    ClusterBox box;
    const auto widen = [&](int a, std::int64_t x, bool first) {
        if (first || x < box.lo[a]) box.lo[a] = x;
        if (first || x > box.hi[a]) box.hi[a] = x;
    };
    for (int k = 0; k < g.size; ++k) {
        const PackedPlace& p = places[g.first + k];
        widen(0, in_full(p.x, from.x), k == 0);
        widen(1, in_full(p.y, from.y), k == 0);
        widen(2, in_full(p.z, from.z), k == 0);
    }
    return box;
}
struct CentreClusters {
    Pencils pencils;
    const PackedPlace* places;
    const int* pencil;
    Cluster* clusters;

    void operator()(std::size_t n) const {
        Cluster& g = clusters[n];
        const ClusterBox box = box_of(places, g, pencils.centre(pencil[n]));
        g.x = static_cast<std::int32_t>((box.lo[0] + box.hi[0]) / 2);
        g.y = static_cast<std::int32_t>((box.lo[1] + box.hi[1]) / 2);
        g.z = static_cast<std::int32_t>((box.lo[2] + box.hi[2]) / 2);
    }
};

// Sums of all before, in three steps: of blocks, of these, and within them (kernels.cpp).
struct ScanBlocks {
    const int* of;
    int* sums;
    int n;
};
struct ScanSums {
    int* sums;
    int n;
};
struct ScanFill {
    const int *of, *sums;
    int* before;
    int n;
};

// What the card can do at most (peaks.h).
struct PeakArithmetic {
    float* result;
    int rounds;
};
struct PeakCache {
    float* result;
    const PackedPlace* array;
    int length, rounds;
};

}  // namespace tw::cuda
