#pragma once
// The loop over groups and their neighbours, once for all sweeps, for files that are compiled once per variant (TW_ISA
// names it). Everything here has internal linkage and calls no inline function of the standard library: the linker
// would be free to keep one file's AVX-512 copy for the whole program.
//
// A sweep is a struct that holds the sums of one group and reads like the right-hand side of an equation:
//
//   struct StrainRate {
//       StrainRate(const StrainRateData& d, const Own& i);    loads what the group's own particles bring
//       void meet(std::int32_t j, const Met& ij);             adds what neighbour j gives
//       void store(const Own& i);                             makes results of the sums and writes them
//   };
//   template <> void pass(const StrainRateData& d, const Group* g, int n) { run<StrainRate>(d, g, n); }
//
// What else a sweep may have, in the order of the calls, see `run`:
//
//   ListRef list(const Group& g) const;                       another list than the group's whole one
//   void meet_at_surface(const Met& ij);                      the neighbours at the free surface, once more
//   void reach_walls(const Own& i);                           where a wall is near: loads what the walls' sums want,
//   void meet_beside_wall(const Met& ij);                     and the neighbours in the water once more
//   void meet_wall(std::int32_t j, const Met& ij);            a wall dummy
//   void meet_wall(std::int32_t j, const Met& ij, V3<Real>& force);   or body by body: the sum of one,
//   V3<Real> push(const V3<Real>& force);                     the acceleration by it, which goes to Data::wall_load
//
// The order of operations is part of the results: products are fused with sums in the order in which they stand.
#include "sph_solver/equations/pair.h"
#include "sph_solver/equations/tension_control.h"
#include "sph_solver/sweeps/passes.h"
#include "sph_solver/sweeps/simd.h"
#include "sph_solver/sweeps/views.h"

namespace tw {
namespace TW_ISA {

/// The sweep of a view; specialised beside each sweep.
template <class View>
void pass(const View&, const Group*, int count);

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
inline V3<float> in_lane(const V3<Real>& a, int l) { return {a.x[l], a.y[l], a.z[l]}; }
inline V3<float> velocity(const VelocityDensityRecord& r) { return {r.u, r.v, r.w}; }

/// A group's own particles (or points), one in each lane.
struct Own {
    const Group& group;
    V3<Real> x;  ///< their places from the group's centre [2h]

    /// Any number of each of them: `value(i)`.
    template <class Value>
    Real each(Value&& value) const {
        Real r{};
        for (int l = 0; l < lanes; ++l) r[l] = value(in_lane(group, l));
        return r;
    }
    template <class Value>
    V3<Real> each_vector(Value&& value) const {
        V3<Real> r{};
        for (int l = 0; l < lanes; ++l) {
            const V3<float> v = value(in_lane(group, l));
            r.x[l] = v.x, r.y[l] = v.y, r.z[l] = v.z;
        }
        return r;
    }
    V3<Real> velocities(const VelocityDensityRecord* motion) const {
        return each_vector([&](int i) { return velocity(motion[i]); });
    }
    /// Calls `body(i, l)` for each of them and its lane.
    template <class Body>
    void for_each(Body&& body) const {
        for (int l = 0; l < group.size; ++l) body(group.first + l, l);
    }
};
inline Own own_places(const PlaceRecord* place, const Group& g, const Frame& frame) {
    Own own{g, {}};
    own.x = own.each_vector([&](int i) {
        const PlaceRecord& a = place[i];
        return V3<float>{static_cast<float>(difference(a.x, g.x)) * frame.length,
                         static_cast<float>(difference(a.y, g.y)) * frame.length,
                         static_cast<float>(difference(a.z, g.z)) * frame.length};
    });
    return own;
}

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

/// Calls `f(part, slot, body)` for every body that the group has in reach: its part of the wall list, and the index of
/// its WallLoad (-1: none).
template <class Function>
[[gnu::always_inline]] inline void for_each_body(const WallView& d, const Group& g, Function&& f) {
    const std::int32_t size = d.place ? g.wall_list.size : 0;
    const NeighbourBlock* const walls = size > 0 ? d.list.blocks(g.wall_list) : nullptr;
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
inline WallLoad load_of(const WaterView& d, const Own& own, const V3<Real>& a, std::int32_t body) {
    const V3<Real> m = cross(d.kernel.support_length * own.x, a);
    WallLoad sum;
    sum.body = body;
    own.for_each([&](int i, int l) {
        if (d.kind && !is_active(d.kind[i])) return;
        sum.ax += a.x[l], sum.ay += a.y[l], sum.az += a.z[l];
        sum.mx += m.x[l], sum.my += m.y[l], sum.mz += m.z[l];
    });
    return sum;
}

/// A group's list for sums that only its particles' rates want: empty where none of them follows the equations. Guards,
/// carried particles and those of inlet and outlet are a quarter to a half of all beside a hull.
inline ListRef list_for_rates(const WaterView& d, const Group& g) {
    bool moved = d.kind == nullptr;
    for (int l = 0; l < g.size && !moved; ++l) moved = follows_the_equations(d.kind[g.first + l]);
    return moved ? g.list : ListRef{};
}

/// What stands for the particles' pressures, see tension_control.h.
inline void control_tension(float from, const ShiftSupportRecord* shift, const Own& own, Real& p_i) {
    if (from > 1.5f || own.group.wall_list.size > 0) return;
    for (int l = 0; l < lanes; ++l) p_i[l] = tension_controlled(p_i[l], shift[in_lane(own.group, l)].support, from);
}

/// The groups' own places, whom they meet, and the lists of these.
template <class Data>
struct Meeting {
    const PlaceRecord *own, *place;
    Lists lists;
    explicit Meeting(const Data& d) : own(d.water.place), place(d.water.place), lists(d.water.list) {
        if constexpr (requires { d.at; }) own = d.at;
        if constexpr (requires { d.other.place; }) place = d.other.place;
        if constexpr (requires { d.list; }) lists = d.list;
    }
};

/// Lets every group meet its neighbours. All that is called in it is inlined: sums stay in registers, and do not depend
/// on the compiler's mood.
template <class Sweep, class Data>
[[gnu::flatten]] void run(const Data& d, const Group* groups, int count) {
    const Frame frame = frame_of(d.water.kernel, d.water.quantum);
    const Meeting meeting(d);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Own own = own_places(meeting.own, g, frame);
        const auto in_water = [&](const ListRef& list, auto&& meet, auto which) {
            for_each_neighbour(meeting.place, meeting.lists, list, g, frame, own.x, meet, which);
        };
        const auto at_walls = [&](const WallView& walls, const ListRef& list, auto&& meet) {
            for_each_neighbour(walls.place, walls.list, list, g, frame, own.x, meet);
        };
        Sweep sweep(d, own);
        ListRef list = g.list;
        if constexpr (requires { sweep.list(g); }) list = sweep.list(g);
        in_water(
            list, [&](std::int32_t j, const Met& ij) { sweep.meet(j, ij); }, Live{});
        if constexpr (requires(const Met& ij) { sweep.meet_at_surface(ij); })
            in_water(
                g.list, [&](std::int32_t, const Met& ij) { sweep.meet_at_surface(ij); }, AtSurface{d.water.surface});
        if constexpr (requires { sweep.reach_walls(own); })
            if (g.wall_list.size > 0) sweep.reach_walls(own);
        if constexpr (requires(const Met& ij) { sweep.meet_beside_wall(ij); })
            if (g.wall_list.size > 0)
                in_water(
                    g.list, [&](std::int32_t, const Met& ij) { sweep.meet_beside_wall(ij); }, Live{});
        if constexpr (requires(const Met& ij) { sweep.meet_wall(0, ij); })
            at_walls(d.walls, g.wall_list, [&](std::int32_t j, const Met& ij) { sweep.meet_wall(j, ij); });
        if constexpr (requires { &Sweep::push; })
            for_each_body(d.walls, g, [&](const ListRef& part, std::int32_t slot, std::int32_t body) {
                V3<Real> force{};
                at_walls(d.walls, part, [&](std::int32_t j, const Met& ij) { sweep.meet_wall(j, ij, force); });
                const V3<Real> a = sweep.push(force);
                if (slot >= 0) d.wall_load[slot] = load_of(d.water, own, a, body);
            });
        sweep.store(own);
    }
}

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
