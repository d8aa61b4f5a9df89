#pragma once
#include "sph_solver/pair_loops/reach.h"

// Who is within reach of a cluster's particles: for lists that are made, and for those that hold already.
namespace tw {
namespace TW_ISA {

ClusterReach reach_of(const PackedPlace* places, const Cluster& g, const Reaches& reaches) {
    ClusterReach r;
    for (int l = 0; l < lanes; ++l) note_lane(r, l, places[in_lane(g, l)], g);
    note_reaches(r, g, reaches);
    return r;
}

namespace {

/// As many places as there are lanes, as three vectors.
typedef std::int32_t Ints __attribute__((vector_size(4 * lanes)));
typedef std::uint32_t Words __attribute__((vector_size(4 * lanes)));
struct Places {
    Ints x, y, z;
};
typedef std::int32_t I8 __attribute__((vector_size(32)));
struct Places8 {
    I8 x, y, z;
};
inline Places8 transposed(I4 r0, I4 r1, I4 r2, I4 r3, I4 r4, I4 r5, I4 r6, I4 r7) {
    const I8 a = __builtin_shufflevector(r0, r4, 0, 1, 2, 3, 4, 5, 6, 7),
             b = __builtin_shufflevector(r1, r5, 0, 1, 2, 3, 4, 5, 6, 7),
             c = __builtin_shufflevector(r2, r6, 0, 1, 2, 3, 4, 5, 6, 7),
             d = __builtin_shufflevector(r3, r7, 0, 1, 2, 3, 4, 5, 6, 7);
    const I8 ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13),
             cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13),
             ab_z = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15),
             cd_z = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(ab_z, cd_z, 0, 1, 8, 9, 4, 5, 12, 13)};
}
/// `place(k)`: the k-th of them.
template <class PlaceOf>
[[gnu::always_inline]] inline Places gathered(const PlaceOf& place) {
    const auto eight = [&](int k) {
        return transposed(place(k), place(k + 1), place(k + 2), place(k + 3), place(k + 4), place(k + 5), place(k + 6),
                          place(k + 7));
    };
    const Places8 low = eight(0);
#if TW_LANES == 8
    return {low.x, low.y, low.z};
#else
    const Places8 high = eight(8);
    const auto joined = [](const I8& a, const I8& b) {
        return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    };
    return {joined(low.x, high.x), joined(low.y, high.y), joined(low.z, high.z)};
#endif
}

/// Squared distance of places from the nearest of the cluster's particles [fixed-point units^2].
inline Real distance2(const ClusterReach& g, const Places& q) {
    const auto from = [](const Ints& a, std::int32_t b) {
        return __builtin_convertvector((Ints)((Words)a - static_cast<std::uint32_t>(b)), Real);
    };
    return distance2(g, from(q.x, g.x), from(q.y, g.y), from(q.z, g.z));
}

}  // namespace

Reached reached(const ClusterReach& g, const PackedPlace* first, const PackedPlace* end, int count, std::int64_t top) {
    Reached r{0, 0, 0};
    for (int k = 0; k < count && difference(first[k].z, g.z) <= top; k += lanes) {
        PackedPlace last[lanes];
        const PackedPlace* p = first + k;
        if (end - p < lanes) {
            for (int m = 0; m < lanes; ++m) last[m] = p + m < end ? p[m] : p[0];
            p = last;
        }
        const I4* v = reinterpret_cast<const I4*>(p);
        const Real d2 = distance2(g, gathered([&](int m) { return v[m]; }));
        r.far |= simd::bits_below(d2, g.far2) << k;
        r.now |= simd::bits_below(d2, g.now2) << k;
        r.sure |= simd::bits_below(d2, g.sure2) << k;
    }
    const std::uint32_t there = count < 32 ? (1u << count) - 1 : ~0u;
    return {r.far & there, r.now & there, r.sure & there};
}

/// Asks the doubtful places only, gathered from their blocks, and hands the answers back to the blocks' bits.
template <>
void pass(const PruneData& d, const Cluster* clusters, int count) {
    constexpr int capacity = 256;
    std::int32_t index[capacity + 16];
    unsigned char within[capacity / 8 + 8];
    for (int n = 0; n < count; ++n) {
        const Cluster& g = clusters[n];
        const ListRef& list = g.*d.list;
        if (list.size == 0) continue;
        const ClusterReach own = reach_of(d.of, g, Reaches{0, d.reach, 0});
        const auto place = [&](int k) { return *reinterpret_cast<const I4*>(d.place + index[k]); };
        NeighbourBlock *block = d.lists.blocks(list), *const end = block + list.size;
        while (block != end) {
            NeighbourBlock* const first = block;
            int doubtful = 0;
            for (; block != end && doubtful <= capacity - 32; ++block)
                doubtful = simd::append_set_bits(block->first, block->maybe, index, doubtful);
            if (doubtful == 0) continue;
            for (int k = 0; k < lanes - 1; ++k) index[doubtful + k] = index[0];
            for (int k = 0; k < doubtful; k += lanes) {
                const Real d2 = distance2(own, gathered([&](int m) { return place(k + m); }));
                const std::uint32_t bits = simd::bits_below(d2, own.now2);
                __builtin_memcpy(within + k / 8, &bits, lanes / 8);
            }
            int at = 0;
            for (NeighbourBlock* b = first; b != block; ++b) {
                std::uint64_t answers;
                __builtin_memcpy(&answers, within + at / 8, 8);
                b->live = (b->live & ~b->maybe) |
                          simd::deposit_bits(static_cast<std::uint32_t>(answers >> (at % 8)), b->maybe);
                at += __builtin_popcount(b->maybe);
            }
        }
    }
}

}  // namespace TW_ISA
}  // namespace tw
