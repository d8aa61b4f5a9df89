#pragma once
// How the pair loops run on a device: the 32 threads of a warp work on one cluster of eight particles. Thread t has the
// particle in lane t % 8 and every fourth neighbour, from its slice t / 8 on; the four sums of a lane are added at the
// end, in an order of their own. So a neighbour is loaded once for eight threads and four neighbours stand side by
// side. Part of pair_loop.h; the same numbers on a processor: in_lanes.h with TW_SLICES = 4.
#include "sph_solver/device/language.h"
#include "sph_solver/pair_loops/pair_loop_parts.h"

#define TW_ALONE inline

namespace tw::simd {

static constexpr int lanes = 8;

/// A thread's own lane of what is a vector on a processor.
struct Real {
    float v = 0;
    constexpr Real() = default;
    constexpr Real(float x) : v(x) {}
    float& operator[](int) { return v; }
    float operator[](int) const { return v; }
    Real& operator+=(Real b) { return v += b.v, *this; }
    Real& operator-=(Real b) { return v -= b.v, *this; }
    Real& operator*=(Real b) { return v *= b.v, *this; }
    friend Real operator+(Real a, Real b) { return a.v + b.v; }
    friend Real operator-(Real a, Real b) { return a.v - b.v; }
    friend Real operator*(Real a, Real b) { return a.v * b.v; }
    friend Real operator/(Real a, Real b) { return a.v / b.v; }
    friend Real operator-(Real a) { return -a.v; }
    friend bool operator>(Real a, Real b) { return a.v > b.v; }
};

inline Real sqrt(Real x) { return device::exact_root(x.v); }
inline Real root(Real x) { return device::root(x.v); }
inline Real quotient(Real a, Real b) { return device::quotient(a.v, b.v); }
inline Real positive_part(Real x) { return x.v > 0 ? x.v : 0; }
inline Real min(Real x, Real y) { return x.v < y.v ? x.v : y.v; }
inline std::uint32_t bits_below(Real x, float limit) { return x.v < limit ? 1 : 0; }

}  // namespace tw::simd

namespace tw {
namespace TW_ISA {
namespace {

using simd::lanes;
using simd::Real;
using Met = Pair<Real>;
struct Math {
    static Real quotient(const Real& a, const Real& b) { return simd::quotient(a, b); }
};
static constexpr int slices = 4;
static_assert(lanes * slices == device::warp);

inline int first_cluster() { return device::warp_index(); }
inline int next_cluster(int n) { return n + device::warp_count(); }

/// As that of in_lanes.h, of which it says what is meant: here each thread does its lane's part.
struct Own {
    const Cluster& cluster;
    V3<Real> x;

    static int lane() { return device::thread() % lanes; }
    static int slice() { return device::thread() / lanes; }

    template <class Value>
    Real each(Value&& value) const {
        return value(in_lane(cluster, lane()));
    }
    template <class Value>
    V3<Real> each_vector(Value&& value) const {
        const V3<float> v = value(in_lane(cluster, lane()));
        return {v.x, v.y, v.z};
    }
    V3<Real> velocities(const PackedVelocityDensity* motion) const {
        return each_vector([&](int i) { return velocity(motion[i]); });
    }
    template <class Body>
    void for_every_lane(Body&& body) const {
        body(in_lane(cluster, lane()), lane());
    }
    template <class Body>
    void for_each(Body&& body) const {
        if (slice() == 0 && lane() < cluster.size) body(cluster.first + lane(), lane());
    }
    template <class Body>
    void once(Body&& body) const {
        if (device::thread() == 0) body();
    }
    template <class Value>
    float sum(Value&& value) const {
        float part = lane() < cluster.size ? static_cast<float>(value(cluster.first + lane(), lane())) : 0.0f;
        for (int half = lanes / 2; half > 0; half /= 2) part += device::from_thread_xor(part, half);
        return part;
    }
};

template <class Body, class Which>
inline void for_each_neighbour(const PackedPlace* place, const Lists& lists, const ListRef& ref, const Own& own,
                               const Frame& frame, Body&& body, Which which) {
    constexpr int capacity = 256;  // as in in_lanes.h: where a chunk ends decides who is in which slice
    const NeighbourBlock* const list = lists.blocks(ref);
    const Cluster& g = own.cluster;
    std::int32_t* const index = device::room_of_warp<std::int32_t, capacity>();
    const int thread = device::thread();
    const std::uint32_t before = (1u << thread) - 1;
    for (int k = 0; k < ref.size;) {
        int n = 0;
        for (; k < ref.size && n <= capacity - 32; ++k) {
            const NeighbourBlock b = list[k];
            const std::uint32_t mask = which(b);
            if (mask >> thread & 1) index[n + __builtin_popcount(mask & before)] = b.first + thread;
            n += __builtin_popcount(mask);
        }
        device::sync_warp();
        for (int m = own.slice(); m < n; m += slices) {
            const std::int32_t j = index[m];
            const PackedPlace r = place[j];
            const V3<Real> r_ji{static_cast<float>(difference(r.x, g.x)) * frame.length - own.x.x,
                                static_cast<float>(difference(r.y, g.y)) * frame.length - own.x.y,
                                static_cast<float>(difference(r.z, g.z)) * frame.length - own.x.z};
            const Real closeness = simd::positive_part(1.0f - simd::root(dot(r_ji, r_ji)));
            body(0, j, meet(r_ji, closeness, r.volume * frame.volume));
        }
        device::sync_warp();
    }
}

/// A thread's sums, of its slice of the neighbours; and those of all of them.
template <class Sum>
class Slices {
public:
    template <class... Arguments>
    explicit Slices(const Arguments&... a) : of_{a...} {}
    Sum& operator[](int) { return of_; }
    template <class Function>
    void each(Function&& f) {
        f(of_);
    }
    Sum& gathered() {
        each_part<Real>(of_, [](Real& part) {
            for (int half = slices / 2; half > 0; half /= 2) part += device::from_thread_xor(part.v, half * lanes);
        });
        return of_;
    }

private:
    Sum of_;
};

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
