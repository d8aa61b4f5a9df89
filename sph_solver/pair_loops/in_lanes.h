#pragma once
// How the pair loops run on a processor: a cluster's particles stand in the lanes of a vector (simd.h), and a thread
// goes over the clusters one after another. Part of pair_loop.h.
//
// TW_SLICES = 4 shares the neighbours out among four sums, which are added at the end, as a device does that lets 32
// threads work on a cluster of eight (in_threads.h): the same numbers to the last bit, without the device.
#include "sph_solver/pair_loops/pair_loop_parts.h"
#include "sph_solver/pair_loops/simd.h"

#ifndef TW_SLICES
#define TW_SLICES 1
#endif

/// Of a function that is never inlined: which sums are fused with their products would depend on what stands before.
#define TW_ALONE [[gnu::noinline]]

namespace tw {
namespace TW_ISA {
namespace {

static constexpr int slices = TW_SLICES;
using simd::lanes;
using simd::Real;
using Met = Pair<Real>;
struct Math {
    static Real quotient(const Real& a, const Real& b) { return simd::quotient(a, b); }
};

inline int first_cluster() { return 0; }
inline int next_cluster(int n) { return n + 1; }

/// A cluster's own particles (or points), one in each lane.
struct Own {
    const Cluster& cluster;
    V3<Real> x;  ///< their places from the cluster's centre [2h]

    /// Any number of each of them: `value(i)`.
    template <class Value>
    Real each(Value&& value) const {
        Real r{};
        for (int l = 0; l < lanes; ++l) r[l] = value(in_lane(cluster, l));
        return r;
    }
    template <class Value>
    V3<Real> each_vector(Value&& value) const {
        V3<Real> r{};
        for (int l = 0; l < lanes; ++l) {
            const V3<float> v = value(in_lane(cluster, l));
            r.x[l] = v.x, r.y[l] = v.y, r.z[l] = v.z;
        }
        return r;
    }
    V3<Real> velocities(const PackedVelocityDensity* motion) const {
        return each_vector([&](int i) { return velocity(motion[i]); });
    }
    /// Calls `body(i, l)` for every lane, those beyond the cluster's size with its last particle.
    template <class Body>
    void for_every_lane(Body&& body) const {
        for (int l = 0; l < lanes; ++l) body(in_lane(cluster, l), l);
    }
    /// Calls `body(i, l)` for each of them and its lane.
    template <class Body>
    void for_each(Body&& body) const {
        for (int l = 0; l < cluster.size; ++l) body(cluster.first + l, l);
    }
    /// Calls `body()` for all of them together.
    template <class Body>
    void once(Body&& body) const {
        body();
    }
    /// The sum of `value(i, l)` over them: in order, or as a tree where a device makes one.
    template <class Value>
    float sum(Value&& value) const {
        if constexpr (slices == 1) {
            float sum = 0;
            for (int l = 0; l < cluster.size; ++l) sum += value(cluster.first + l, l);
            return sum;
        }
        float part[lanes] = {};
        for (int l = 0; l < cluster.size; ++l) part[l] = value(cluster.first + l, l);
        for (int half = lanes / 2; half > 0; half /= 2)
            for (int l = 0; l < half; ++l) part[l] += part[l + half];
        return part[0];
    }
};

inline V3<Real> separation(const V3<Real>& x_i, const float* xyz) {
    return {xyz[0] - x_i.x, xyz[1] - x_i.y, xyz[2] - x_i.z};
}

/// 1 - |r_ji| / 2h, cut off at the support.
inline Real closeness(const V3<Real>& x_i, const float* xyz) {
    const V3<Real> r_ji = separation(x_i, xyz);
    return simd::positive_part(1.0f - simd::root(dot(r_ji, r_ji)));
}

/// A chunk of neighbours as the pair loop loads them, broadcast.
struct alignas(64) Chunk {
    static constexpr int capacity = 256;
    static constexpr int ahead = 4;  // by so many pairs the distances run ahead
    float xyz[capacity + ahead][4];  // relative to the cluster's centre [2h]; the fourth is G V
    Real t[capacity + ahead];        // closeness of each lane
    std::int32_t index[capacity + 16];
};

typedef std::int32_t I4 __attribute__((vector_size(16), may_alias));
typedef std::uint32_t U4 __attribute__((vector_size(16)));
typedef float F4 __attribute__((vector_size(16), may_alias));

/// Loads n neighbours, and zeros for the places beyond them whose distances are made and not used.
inline void load_chunk(Chunk& chunk, const PackedPlace* place, int n, const Cluster& g, const Frame& frame) {
    for (int k = n; k < n + Chunk::ahead; ++k) *reinterpret_cast<F4*>(chunk.xyz[k]) = F4{};
    const U4 centre = (U4)I4{g.x, g.y, g.z, 0};
    for (int k = 0; k < n; ++k) {
        const PackedPlace& r = place[chunk.index[k]];
        const I4 raw = *reinterpret_cast<const I4*>(&r);
        F4 relative = __builtin_convertvector((I4)((U4)raw - centre), F4) * frame.length;
        relative[3] = r.volume * frame.volume;
        *reinterpret_cast<F4*>(chunk.xyz[k]) = relative;
    }
}

/// Calls `body(slice, j, ij)` for the neighbours on a list that `which` names. The distances run ahead: a
/// root takes as long as ten other operations, and the processor itself looks ahead by two or three pairs only.
///
/// Inlined whatever the compiler thinks: GCC 12.2 at -O2 with AVX drops a call, and so the sums, of a function that
/// gets a closure by value and changes things only through the references in it (seen here, and in 25 lines).
template <class Body, class Which>
[[gnu::always_inline]] inline void for_each_neighbour(const PackedPlace* place, const Lists& lists, const ListRef& ref,
                                                      const Own& own, const Frame& frame, Body&& body, Which which) {
    const Cluster& g = own.cluster;
    const V3<Real>& x_i = own.x;
    const NeighbourBlock* const list = lists.blocks(ref);
    Chunk chunk;
    for (int k = 0; k < ref.size;) {
        int n = 0;
        for (; k < ref.size && n <= Chunk::capacity - 32; ++k)
            n = simd::append_set_bits(list[k].first, which(list[k]), chunk.index, n);
        if (n == 0) continue;
        load_chunk(chunk, place, n, g, frame);
        for (int m = 0; m < Chunk::ahead; ++m) chunk.t[m] = closeness(x_i, chunk.xyz[m]);
        for (int m = 0; m < n; ++m) {
            chunk.t[m + Chunk::ahead] = closeness(x_i, chunk.xyz[m + Chunk::ahead]);
            body(m % slices, chunk.index[m], meet(separation(x_i, chunk.xyz[m]), chunk.t[m], chunk.xyz[m][3]));
        }
    }
}

/// A pair loop, or another sum over neighbours, once for each slice.
template <class Sum>
class Slices {
public:
    template <class... Arguments>
    explicit Slices(const Arguments&... a) requires(slices == 1) : of_{Sum{a...}} {}
    template <class... Arguments>
    explicit Slices(const Arguments&... a) requires(slices == 4) : of_{Sum{a...}, Sum{a...}, Sum{a...}, Sum{a...}} {}

    Sum& operator[](int slice) { return of_[slice]; }
    template <class Function>
    void each(Function&& f) {
        for (Sum& sum : of_) f(sum);
    }
    /// That of all neighbours; called once.
    Sum& gathered() {
        if constexpr (slices > 1) {
            Real* parts[slices][most_parts];
            int n = 0;
            for (int k = 0; k < slices; ++k) {
                n = 0;
                each_part<Real>(of_[k], [&](Real& part) { parts[k][n++] = &part; });
            }
            for (int half = slices / 2; half > 0; half /= 2)
                for (int k = 0; k < half; ++k)
                    for (int m = 0; m < n; ++m) *parts[k][m] += *parts[k + half][m];
        }
        return of_[0];
    }

private:
    static constexpr int most_parts = 64;
    Sum of_[slices];
};

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
