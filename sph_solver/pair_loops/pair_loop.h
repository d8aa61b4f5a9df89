#pragma once
// The loop over clusters and their neighbours, once for all pair loops, for files that are compiled once per variant
// (TW_ISA names it). Everything here has internal linkage and calls no inline function of the standard library: the
// linker would be free to keep one file's AVX-512 copy for the whole program.
//
// A pair loop is a struct that holds the sums of one cluster and reads like the right-hand side of an equation:
//
//   struct StrainRate {
//       StrainRate(const StrainRateData& d, const Own& i);    loads what the cluster's own particles bring
//       void meet(std::int32_t j, const Met& ij);             adds what neighbour j gives
//       void store(const Own& i);                             makes results of the sums and writes them
//   };
//   template <> void pass(const StrainRateData& d, const Cluster* g, int n) { run<StrainRate>(d, g, n); }
//
// What else a pair loop may have, in the order of the calls, see `run`:
//
//   ListRef list(const Cluster& g) const;                       another list than the cluster's whole one
//   void meet_at_surface(const Met& ij);                      the neighbours at the free surface, once more
//   void reach_walls(const Own& i);                           where a wall is near: loads what the walls' sums want,
//   void meet_beside_wall(const Met& ij);                     and the neighbours in the water once more
//   void meet_wall(std::int32_t j, const Met& ij);            a wall dummy
//   void meet_wall(std::int32_t j, const Met& ij, OfBody& of);   or body by body: the sums of one,
//   V3<Real> push(const OfBody& of);                          the acceleration by it, which goes to Data::wall_load
//   void sums(auto&& of) { of(a, b); }                        its sums over neighbours, but those that `push` makes
//
// The order of operations is part of the results: products are fused with sums in the order in which they stand.
#include "sph_solver/equations/pair.h"
#include "sph_solver/equations/tension_control.h"
#include "sph_solver/pair_loops/passes.h"
#ifdef TW_THREADS
#include "sph_solver/pair_loops/in_threads.h"
#else
#include "sph_solver/pair_loops/in_lanes.h"
#endif

namespace tw {
namespace TW_ISA {

/// The pair loop of a view; specialised beside each pair loop.
template <class View>
void pass(const View&, const Cluster*, int count);

namespace {

/// Calls `f(part, slot, body)` for every body that the cluster has in reach: its part of the wall list, and the index
/// of its WallLoad (-1: none).
template <class Function>
[[gnu::always_inline]] inline void for_each_body(const WallView& d, const Cluster& g, Function&& f) {
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

/// Sum of the accelerations a of a cluster's active particles by the walls of a body, and of their moments about its
/// centre.
inline WallLoad load_of(const WaterView& d, const Own& own, const V3<Real>& a, std::int32_t body) {
    const V3<Real> m = cross(d.kernel.support_length * own.x, a);
    const auto sum = [&](const Real& of) {
        return own.sum([&](int i, int l) { return d.kind && !is_active(d.kind[i]) ? 0.0f : of[l]; });
    };
    return {sum(a.x), sum(a.y), sum(a.z), sum(m.x), sum(m.y), sum(m.z), body};
}

/// A cluster's list for sums that only its particles' rates want: empty where none of them follows the equations.
/// Buffer, slave particles and those of inlet and outlet are a quarter to a half of all beside a hull.
inline ListRef list_for_rates(const WaterView& d, const Cluster& g) {
    bool moved = d.kind == nullptr;
    for (int l = 0; l < g.size && !moved; ++l) moved = follows_the_equations(d.kind[g.first + l]);
    return moved ? g.list : ListRef{};
}

/// What stands for the particles' pressures, see tension_control.h.
inline void control_tension(float from, const PackedShiftSupport* shift, const Own& own, Real& p_i) {
    if (from > 1.5f || own.cluster.wall_list.size > 0) return;
    own.for_every_lane([&](int i, int l) { p_i[l] = tension_controlled(p_i[l], shift[i].support, from); });
}

inline Own own_places(const PackedPlace* place, const Cluster& g, const Frame& frame) {
    Own own{g, {}};
    own.x = own.each_vector([&](int i) {
        const PackedPlace& a = place[i];
        return V3<float>{static_cast<float>(difference(a.x, g.x)) * frame.length,
                         static_cast<float>(difference(a.y, g.y)) * frame.length,
                         static_cast<float>(difference(a.z, g.z)) * frame.length};
    });
    return own;
}

/// The clusters' own places, whom they meet, and the lists of these.
template <class Data>
struct Meeting {
    const PackedPlace *own, *place;
    Lists lists;
    explicit Meeting(const Data& d) : own(d.water.place), place(d.water.place), lists(d.water.list) {
        if constexpr (requires { d.at; }) own = d.at;
        if constexpr (requires { d.other.place; }) place = d.other.place;
        if constexpr (requires { d.list; }) lists = d.list;
    }
};

/// Lets every cluster meet its neighbours. All that is called in it is inlined: sums stay in registers, and do not
/// depend on the compiler's mood.
template <class PairLoop, class Data>
[[gnu::flatten]] void run(const Data& d, const Cluster* clusters, int count) {
    const Frame frame = frame_of(d.water.kernel, d.water.unit);
    const Meeting meeting(d);
    for (int n = first_cluster(); n < count; n = next_cluster(n)) {
        const Cluster& g = clusters[n];
        const Own own = own_places(meeting.own, g, frame);
        const auto in_water = [&](const ListRef& list, auto&& meet, auto which) {
            for_each_neighbour(meeting.place, meeting.lists, list, own, frame, meet, which);
        };
        const auto at_walls = [&](const WallView& walls, const ListRef& list, auto&& meet) {
            for_each_neighbour(walls.place, walls.list, list, own, frame, meet, Live{});
        };
        Slices<PairLoop> pair_loop(d, own);
        ListRef list = g.list;
        if constexpr (requires { pair_loop[0].list(g); }) list = pair_loop[0].list(g);
        in_water(
            list, [&](int slice, std::int32_t j, const Met& ij) { pair_loop[slice].meet(j, ij); }, Live{});
        if constexpr (requires(const Met& ij) { pair_loop[0].meet_at_surface(ij); })
            in_water(
                g.list, [&](int slice, std::int32_t, const Met& ij) { pair_loop[slice].meet_at_surface(ij); },
                AtSurface{d.water.surface});
        if constexpr (requires { pair_loop[0].reach_walls(own); })
            if (g.wall_list.size > 0) pair_loop.each([&](PairLoop& s) { s.reach_walls(own); });
        if constexpr (requires(const Met& ij) { pair_loop[0].meet_beside_wall(ij); })
            if (g.wall_list.size > 0)
                in_water(
                    g.list, [&](int slice, std::int32_t, const Met& ij) { pair_loop[slice].meet_beside_wall(ij); },
                    Live{});
        if constexpr (requires(const Met& ij) { pair_loop[0].meet_wall(0, ij); })
            at_walls(d.walls, g.wall_list,
                     [&](int slice, std::int32_t j, const Met& ij) { pair_loop[slice].meet_wall(j, ij); });
        PairLoop& all = pair_loop.gathered();
        if constexpr (requires { &PairLoop::push; })
            for_each_body(d.walls, g, [&](const ListRef& part, std::int32_t slot, std::int32_t body) {
                Slices<typename PairLoop::OfBody> by;
                at_walls(d.walls, part, [&](int slice, std::int32_t j, const Met& ij) {
                    pair_loop[slice].meet_wall(j, ij, by[slice]);
                });
                const V3<Real> a = all.push(by.gathered());
                if (slot < 0) return;
                const WallLoad load = load_of(d.water, own, a, body);
                own.once([&] { d.wall_load[slot] = load; });
            });
        all.store(own);
    }
}

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
