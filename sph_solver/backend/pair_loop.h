#pragma once
// The loop over the neighbours of a group, for files that are compiled once per instruction set (TW_ISA names it).
// Everything here has internal linkage and calls no inline function of the standard library: the linker would be free
// to keep one file's AVX-512 copy for the whole program.
#include "sph_solver/backend/pass_data.h"
#include "sph_solver/backend/simd.h"
#include "sph_solver/equations/pair.h"
#include "sph_solver/equations/tension_control.h"

namespace tw {
namespace TW_ISA {
namespace {

using simd::lanes;
using simd::Real;
using Met = Pair<Real>;
struct Math {
    static Real quotient(const Real& a, const Real& b) { return simd::quotient(a, b); }
};

/// Lengths in 2h, and volumes as G V, see Kernel.
struct Frame {
    float length;  ///< per quantum
    float volume;  ///< per m3
};
inline Frame frame_of(const Kernel& kernel, float quantum) { return {quantum * kernel.inv_support, kernel.G}; }

/// A chunk of neighbours as the pair loop loads them, broadcast.
struct alignas(64) Chunk {
    static constexpr int capacity = 256;
    static constexpr int ahead = 3;  // by so many pairs the distances run ahead
    float xyz[capacity + ahead][4];  // relative to the group's centre [2h]; the fourth is G V
    Real t[capacity + ahead];        // closeness of each lane
    std::int32_t index[capacity + 16];
};

typedef std::int32_t I4 __attribute__((vector_size(16), may_alias));
typedef std::uint32_t U4 __attribute__((vector_size(16)));
typedef float F4 __attribute__((vector_size(16), may_alias));

/// Loads n neighbours, and zeros for the places beyond them whose distances are made and not used.
inline void load_chunk(Chunk& chunk, const PlaceRecord* place, int n, const Group& g, const Frame& frame) {
    for (int k = n; k < n + Chunk::ahead; ++k) *reinterpret_cast<F4*>(chunk.xyz[k]) = F4{};
    const U4 centre = (U4)I4{g.x, g.y, g.z, 0};
    for (int k = 0; k < n; ++k) {
        const PlaceRecord& r = place[chunk.index[k]];
        const I4 raw = *reinterpret_cast<const I4*>(&r);
        F4 relative = __builtin_convertvector((I4)((U4)raw - centre), F4) * frame.length;
        relative[3] = r.volume * frame.volume;
        *reinterpret_cast<F4*>(chunk.xyz[k]) = relative;
    }
}

/// The particle in a lane; lanes beyond the group's size repeat the last one.
inline int in_lane(const Group& g, int l) { return g.first + (l < g.size ? l : g.size - 1); }

/// Places of the group's own particles, from its centre [2h].
inline V3<Real> own_places(const PlaceRecord* place, const Group& g, const Frame& frame) {
    V3<Real> r{};
    for (int l = 0; l < lanes; ++l) {
        const PlaceRecord& a = place[in_lane(g, l)];
        r.x[l] = static_cast<float>(difference(a.x, g.x)) * frame.length;
        r.y[l] = static_cast<float>(difference(a.y, g.y)) * frame.length;
        r.z[l] = static_cast<float>(difference(a.z, g.z)) * frame.length;
    }
    return r;
}
/// Their velocities [m/s] or another vector of such records.
inline V3<Real> own_velocities(const VelocityDensityRecord* motion, const Group& g) {
    V3<Real> u{};
    for (int l = 0; l < lanes; ++l) {
        const VelocityDensityRecord& r = motion[in_lane(g, l)];
        u.x[l] = r.u, u.y[l] = r.v, u.z[l] = r.w;
    }
    return u;
}
/// Any number of each of them: `value(i)`.
template <class Value>
[[gnu::always_inline]] inline Real own(const Group& g, Value&& value) {
    Real r{};
    for (int l = 0; l < lanes; ++l) r[l] = value(in_lane(g, l));
    return r;
}
inline V3<float> velocity(const VelocityDensityRecord& r) { return {r.u, r.v, r.w}; }
inline V3<float> in_lane(const V3<Real>& a, int l) { return {a.x[l], a.y[l], a.z[l]}; }

inline V3<Real> separation(const V3<Real>& x_i, const float* xyz) {
    return {xyz[0] - x_i.x, xyz[1] - x_i.y, xyz[2] - x_i.z};
}

/// 1 - |r_ji| / 2h, cut off at the support.
inline Real closeness(const V3<Real>& x_i, const float* xyz) {
    const V3<Real> r_ji = separation(x_i, xyz);
    return simd::positive_part(1.0f - simd::root(dot(r_ji, r_ji)));
}

/// Which places of a block a loop visits: all live ones, or of these those at the free surface.
struct Live {
    std::uint32_t operator()(const NeighbourBlock& b) const { return b.live; }
};
struct AtSurface {
    const std::uint32_t* surface;
    std::uint32_t operator()(const NeighbourBlock& b) const {
        const std::uint32_t* word = surface + b.first / 32;
        const std::uint64_t both = word[0] | std::uint64_t{word[1]} << 32;
        return static_cast<std::uint32_t>(both >> (b.first % 32)) & b.live;
    }
};

/// Calls `body(j, ij)` for the neighbours on a list that `which` names. The distances run ahead: a
/// root takes as long as ten other operations, and the processor itself looks ahead by two or three pairs only.
///
/// Inlined whatever the compiler thinks: GCC 12.2 at -O2 with AVX drops a call, and so the sums, of a function that
/// gets a closure by value and changes things only through the references in it (seen here, and in 25 lines).
template <class Body, class Which = Live>
[[gnu::always_inline]] inline void for_each_neighbour(const PlaceRecord* place, const Lists& lists, const ListRef& ref,
                                                      const Group& g, const Frame& frame, const V3<Real>& x_i,
                                                      Body&& body, Which which = {}) {
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
            body(chunk.index[m], meet(separation(x_i, chunk.xyz[m]), chunk.t[m], chunk.xyz[m][3]));
        }
    }
}

/// A group's list for sums that only its particles' rates want: empty where none of them follows the equations. Guards,
/// carried particles and those of inlet and outlet are a quarter to a half of all beside a hull.
inline ListRef list_for_rates(const PassData& d, const Group& g) {
    bool moved = d.kind == nullptr;
    for (int l = 0; l < g.size && !moved; ++l) moved = follows_the_equations(d.kind[g.first + l]);
    return moved ? g.list : ListRef{};
}

/// What stands for the particles' pressures, see tension_control.h.
inline void control_tension(const PassData& d, const Group& g, Real& p_i) {
    if (d.tension_control_from > 1.5f || g.wall_list.size > 0) return;
    for (int l = 0; l < lanes; ++l)
        p_i[l] = tension_controlled(p_i[l], d.shift[in_lane(g, l)].support, d.tension_control_from);
}

/// Calls `f(part, slot, body)` for every body that the group has in reach: its part of the wall list, and the index of
/// its WallLoad (-1: none).
template <class Function>
[[gnu::always_inline]] inline void for_each_body(const PassData& d, const Group& g, Function&& f) {
    const NeighbourBlock* const walls = d.wall_list.blocks(g.wall_list);
    const std::int32_t size = g.wall_list.size;
    std::int32_t slot = g.wall_load, body = 0;
    for (std::int32_t k = 0, end = 0; k < size; k = end) {
        while (body + 1 < d.bodies && walls[k].first >= d.body_end[body]) ++body;
        if (body + 1 == d.bodies)
            end = size;
        else
            while (end < size && walls[end].first < d.body_end[body]) ++end;
        f(ListRef{g.wall_list.chunk, g.wall_list.first + k, end - k}, slot, body);
        if (slot >= 0) ++slot;
    }
}

/// Sum of the accelerations a of a group's active particles by the walls of a body, and of their moments about its
/// centre.
inline WallLoad load_of(const PassData& d, const Group& g, const V3<Real>& x_i, const V3<Real>& a, std::int32_t body) {
    const V3<Real> m = cross(d.kernel.support_length * x_i, a);
    WallLoad sum;
    sum.body = body;
    for (int l = 0; l < g.size; ++l) {
        if (d.kind && !is_active(d.kind[g.first + l])) continue;
        sum.ax += a.x[l], sum.ay += a.y[l], sum.az += a.z[l];
        sum.mx += m.x[l], sum.my += m.y[l], sum.mz += m.z[l];
    }
    return sum;
}

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
