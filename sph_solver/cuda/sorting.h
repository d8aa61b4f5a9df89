#pragma once
// Sorting places into the order of neighbours/columns.h and finding neighbours in it, as a device does it: plain data for
// kernels, as in tasks.h. The order is a function of the places alone, whoever came first.
#include <cstddef>
#include <cstdint>

#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/cross.h"
#include "sph_solver/loops/link_map.h"
#include "sph_solver/loops/moving.h"
#include "sph_solver/neighbours/column_grid.h"
#include "sph_solver/sweeps/groups.h"

namespace tw::cuda {

/// A column cut into bins of some height: sorted within a bin, and bin by bin, places are sorted within a column.
struct Bins {
    Columns columns;
    std::int64_t height;  ///< [quanta]
    int in_column;

    int count() const { return columns.count() * in_column; }
    int of(const WidePlace& p) const {
        const int slab = columns.slab(p.z);
        const std::int64_t bin = (p.z - (columns.z0 + slab * columns.height)) / height;
        const int in = p.z < columns.z0 || bin < 0 ? 0 : bin >= in_column ? in_column - 1 : static_cast<int>(bin);
        return columns.of(p) * in_column + in;
    }
};

// --- particles at the domain's faces

/// Marks whom the inlet's plane has let in, and who has left.
struct Cross {
    CrossOpenings cross;
    const double* x;
    Kind* kind;
    int *entered, *gone;

    void operator()(std::size_t i) const {
        const CrossOpenings::Outcome outcome = cross(x[i], kind[i]);
        entered[i] = outcome == CrossOpenings::Outcome::enters;
        gone[i] = outcome == CrossOpenings::Outcome::leaves;
    }
};
/// The particle that takes the place of one that has entered, a buffer's length upstream.
struct Enter {
    MovingView on;
    const int *entered, *before;  ///< how many of those before have entered
    int* gone;
    std::size_t n;
    double buffer;
    std::int64_t next_id;

    void operator()(std::size_t i) const {
        if (!entered[i]) return;
        const std::size_t k = n + static_cast<std::size_t>(before[i]);
        on.copy(k, on, i);
        on.begin(k);
        on.p.x[k] -= buffer, on.p.v[k] = 0, on.p.w[k] = 0;
        on.kind[k] = Kind::inlet, on.id[k] = next_id + before[i], gone[k] = 0;
    }
};
/// Puts back what has crossed a mirror, takes what has left through an open top, and says where the others are.
struct PutBack {
    ReturnFromMirrors mirrors;
    double top;  ///< [m]
    bool open_top;
    ToQuanta to_quanta;
    const int* gone;  ///< null: nobody is
    WidePlace* wide;
    std::uint8_t* left;

    void operator()(std::size_t i) const {
        mirrors(i);
        const StateView& p = mirrors.p;
        left[i] = (gone && gone[i]) || (open_top && p.z[i] > top);
        wide[i] = to_quanta.wide(p.x[i], p.y[i], p.z[i]);
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
    MovingView from, to;

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
    ToQuanta to_quanta;
    const int* first;
    Link* links;
    WidePlace* wide;

    void operator()(std::size_t i) const {
        int k = first[i];
        const WidePlace own = to_quanta.wide(p.x[i], p.y[i], p.z[i]);
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

// --- groups

constexpr int lanes_of_group = 8;

struct CountGroups {
    const int* start;  ///< of bins
    int in_column;
    int* count;

    void operator()(std::size_t c) const {
        const auto of = [&](std::size_t column) { return start[column * static_cast<std::size_t>(in_column)]; };
        count[c] = (of(c + 1) - of(c) + lanes_of_group - 1) / lanes_of_group;
    }
};
struct MakeGroups {
    const int* start;
    int in_column;
    const int* first;  ///< group of each column
    Group* groups;
    int* column;  ///< of each group

    void operator()(std::size_t c) const {
        const int end = start[(c + 1) * static_cast<std::size_t>(in_column)];
        int at = start[c * static_cast<std::size_t>(in_column)];
        for (int g = first[c]; at < end; ++g, at += lanes_of_group) {
            Group group;
            group.first = at, group.size = end - at < lanes_of_group ? end - at : lanes_of_group;
            groups[g] = group, column[g] = static_cast<int>(c);
        }
    }
};

/// A box round a group [quanta].
struct GroupBox {
    std::int64_t lo[3], hi[3];
};
inline GroupBox box_of(const PlaceRecord* places, const Group& g, const WidePlace& from) {
    const auto in_full = [](std::int32_t x, std::int64_t near) {
        return near + difference(x, static_cast<std::int32_t>(near));
    };
    GroupBox box;
    const auto widen = [&](int a, std::int64_t x, bool first) {
        if (first || x < box.lo[a]) box.lo[a] = x;
        if (first || x > box.hi[a]) box.hi[a] = x;
    };
    for (int k = 0; k < g.size; ++k) {
        const PlaceRecord& p = places[g.first + k];
        widen(0, in_full(p.x, from.x), k == 0);
        widen(1, in_full(p.y, from.y), k == 0);
        widen(2, in_full(p.z, from.z), k == 0);
    }
    return box;
}
struct CentreGroups {
    Columns columns;
    const PlaceRecord* places;
    const int* column;
    Group* groups;

    void operator()(std::size_t n) const {
        Group& g = groups[n];
        const GroupBox box = box_of(places, g, columns.centre(column[n]));
        g.x = static_cast<std::int32_t>((box.lo[0] + box.hi[0]) / 2);
        g.y = static_cast<std::int32_t>((box.lo[1] + box.hi[1]) / 2);
        g.z = static_cast<std::int32_t>((box.lo[2] + box.hi[2]) / 2);
    }
};

// --- neighbours

/// Sorted places in which neighbours are looked for.
struct DeviceSource {
    const PlaceRecord* places;
    const int* start;  ///< first place of each column (times `stride`)
    int stride;
    std::int32_t offset;  ///< index of the first place in the sweeps' index space

    int first_of(int column) const { return start[std::int64_t{column} * stride]; }
};

/// Who is within reach of each group's particles, block by block as Search in neighbours/columns.cpp finds them. A first
/// run counts the blocks, a second one writes them.
struct SearchNeighbours {
    Columns columns;            ///< of the sources
    Columns of_groups;          ///< the same, or others over the same box
    const PlaceRecord* places;  ///< of the groups
    const int* column;          ///< of each group
    Group* groups;
    const DeviceSource* sources;
    int source_count;
    double reach;     ///< [quanta], with what the sources may have moved
    Reaches reaches;  ///< [quanta]
    bool write;       ///< the second run
    int* count;       ///< of blocks; in the second run the first of each group's
    NeighbourBlock* blocks;
    ListRef Group::*list;

    /// `ask(first, end, count, top)`: who of so many places is near, and not above a height, as Passes::reached says.
    template <class Ask, class Once>
    void operator()(std::size_t n, const Ask& ask, const Once& once) const {
        const Group g = groups[n];
        const WidePlace centre = of_groups.centre(column[n]);
        const GroupBox box = box_of(places, g, centre);
        const std::int64_t group_z = centre.z + difference(g.z, static_cast<std::int32_t>(centre.z));
        const int first = write ? count[n] : 0;
        int found = 0;
        for (int s = 0; s < source_count; ++s) search(sources[s], box, group_z, ask, once, first, found);
        once([&] {
            if (write)
                groups[n].*list = {0, first, found};
            else
                count[n] = found;
        });
    }

private:
    template <class Ask, class Once>
    void search(const DeviceSource& source, const GroupBox& box, std::int64_t group_z, const Ask& ask, const Once& once,
                int first, int& found) const {
        const auto r = whole_above(reach);
        const PlaceRecord* const all_end = source.places + source.first_of(columns.count());
        const int x0 = columns.column_x(box.lo[0] - r), x1 = columns.column_x(box.hi[0] + r),
                  y0 = columns.column_y(box.lo[1] - r), y1 = columns.column_y(box.hi[1] + r),
                  z1 = columns.slab(box.hi[2] + r);
        for (int cz = columns.slab(box.lo[2] - r); cz <= z1; ++cz) {
            const std::int64_t middle = columns.middle_of_slab(cz);
            const auto height = [&](const PlaceRecord& p) {
                return std::int64_t{difference(p.z, static_cast<std::int32_t>(middle))} + middle;
            };
            for (int cy = y0; cy <= y1; ++cy) {
                const double gap_y = columns.gap_y(cy, box.lo[1], box.hi[1]);
                for (int cx = x0; cx <= x1; ++cx) {
                    const double gap_x = columns.gap_x(cx, box.lo[0], box.hi[0]);
                    const double left2 = reach * reach - gap_x * gap_x - gap_y * gap_y;
                    if (left2 < 0) continue;
                    const std::int64_t up = whole_above(std::sqrt(left2)), top = box.hi[2] + up;
                    const int c = columns.column(cx, cy, cz);
                    const PlaceRecord* p = source.places + source.first_of(c);
                    const PlaceRecord* const end = source.places + source.first_of(c + 1);
                    for (std::int64_t left = end - p; left > 0;) {  // the first that is not below
                        const std::int64_t half = left / 2;
                        if (height(p[half]) < box.lo[2] - up)
                            p += half + 1, left -= half + 1;
                        else
                            left = half;
                    }
                    for (; p < end && height(*p) < top + 1; p += 32) {
                        const int n = end - p < 32 ? static_cast<int>(end - p) : 32;
                        const Reached near = ask(p, all_end, n, top - group_z);
                        if (near.far == 0) continue;
                        if (write)
                            once([&] {
                                blocks[first + found] = {source.offset + static_cast<std::int32_t>(p - source.places),
                                                         near.now, near.far & ~near.sure};
                            });
                        ++found;
                    }
                }
            }
        }
    }
    static std::int64_t whole_above(double x) {
        const auto whole = static_cast<std::int64_t>(x);
        return static_cast<double>(whole) < x ? whole + 1 : whole;
    }
};

// --- groups at walls

/// How many bodies each group has in reach, each of which gets a slot for its load.
struct CountWallLoads {
    const Group* groups;
    const NeighbourBlock* blocks;
    const std::int32_t* body_end;
    int bodies;
    int *loads, *at_wall;

    void operator()(std::size_t n) const {
        const Group& g = groups[n];
        int count = 0;
        for (std::int32_t k = 0, body = -1; k < g.wall_list.size; ++k) {
            int of = 0;
            while (of + 1 < bodies && blocks[g.wall_list.first + k].first >= body_end[of]) ++of;
            count += of != body;
            body = of;
        }
        loads[n] = count, at_wall[n] = count > 0;
    }
};
/// A group at a wall, and its centre [m].
struct GroupAtWall {
    Group group;
    double x, y, z;
};
struct ListGroupsAtWalls {
    Columns columns;
    const int* column;
    const int *first_load, *at_wall, *before;
    double origin[3], quantum;
    Group* groups;
    GroupAtWall* list;

    void operator()(std::size_t n) const {
        Group& g = groups[n];
        g.wall_load = at_wall[n] ? first_load[n] : -1;
        if (!at_wall[n]) return;
        const WidePlace c = columns.centre(column[n]);
        const auto metres = [&](std::int32_t q, std::int64_t near, double from) {
            return from + quantum * static_cast<double>(near + difference(q, static_cast<std::int32_t>(near)));
        };
        list[before[n]] = {g, metres(g.x, c.x, origin[0]), metres(g.y, c.y, origin[1]), metres(g.z, c.z, origin[2])};
    }
};
/// Where a particle is that may be near a wall.
struct NearWall {
    double x, y, z;
    float u, v, w;
    std::int32_t index;  ///< -1: none
    Kind kind;
};
struct TakeNearWalls {
    StateView p;
    const Kind* kind;
    const GroupAtWall* list;
    NearWall* to;

    void operator()(std::size_t k) const {
        const Group& g = list[k / lanes_of_group].group;
        const int l = static_cast<int>(k % lanes_of_group);
        NearWall& near = to[k];
        near.index = l < g.size ? g.first + l : -1;
        if (near.index < 0) return;
        const auto i = static_cast<std::size_t>(near.index);
        near.x = p.x[i], near.y = p.y[i], near.z = p.z[i];
        near.u = p.u[i], near.v = p.v[i], near.w = p.w[i];
        near.kind = kind[i];
    }
};
struct NoWalls {
    WallNormalRecord* wall;
    LeavingRecord* leaving;
    std::uint16_t* body;  ///< null: none moves

    void operator()(std::size_t i) const {
        wall[i] = no_wall, leaving[i] = {0, 0, 0, 0};
        if (body) body[i] = 0;
    }
};
/// What the host has found of them.
struct WallFound {
    std::int32_t index;
    WallNormalRecord wall;
    LeavingRecord leaving;
    std::uint16_t body;
};
struct PutWalls {
    const WallFound* found;
    WallNormalRecord* wall;
    LeavingRecord* leaving;
    std::uint16_t* body;  ///< null: none moves

    void operator()(std::size_t k) const {
        const WallFound& f = found[k];
        if (f.index < 0) return;
        wall[f.index] = f.wall, leaving[f.index] = f.leaving;
        if (body) body[f.index] = f.body;
    }
};

}  // namespace tw::cuda
