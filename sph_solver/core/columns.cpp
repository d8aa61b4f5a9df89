#include "sph_solver/core/columns.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sph_solver/core/simd.h"

namespace tw {

ColumnGrid::ColumnGrid(const Box& area, double dp, int dimensions, const Quanta& quanta) {
    const double edge = dimensions == 3 ? std::cbrt(double(simd::lanes)) * dp : std::sqrt(double(simd::lanes)) * dp;
    width = static_cast<std::int32_t>(edge / quanta.size);
    x0 = quanta.of(area.min.x(), 0);
    y0 = quanta.of(area.min.y(), 1);
    nx = std::max(1, static_cast<int>(std::ceil(area.size().x() / edge)));
    ny = dimensions == 3 ? std::max(1, static_cast<int>(std::ceil(area.size().y() / edge))) : 1;
}

void sort_by_column(const ColumnGrid& grid, const std::vector<PlaceRecord>& places, std::size_t begin, std::size_t end,
                    std::vector<std::int32_t>& order, std::vector<std::int32_t>& start) {
    const std::size_t n = end - begin;
    std::vector<std::int32_t> column(n);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) column[i] = grid.of(places[begin + i]);
    start.assign(static_cast<std::size_t>(grid.count()) + 1, 0);
    for (std::int32_t c : column) ++start[static_cast<std::size_t>(c) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::int32_t> fill(start.begin(), start.end() - 1);
    struct Key {
        std::int32_t z, x, y, index;
        auto operator<=>(const Key&) const = default;
    };
    std::vector<Key> keys(n);
    for (std::size_t i = 0; i < n; ++i) {
        const PlaceRecord& p = places[begin + i];
        keys[static_cast<std::size_t>(fill[static_cast<std::size_t>(column[i])]++)] = {
            p.z, p.x, p.y, static_cast<std::int32_t>(begin + i)};
    }
    order.resize(n);
#pragma omp parallel for schedule(dynamic, 64)
    for (int c = 0; c < grid.count(); ++c) {
        const auto first = static_cast<std::size_t>(start[static_cast<std::size_t>(c)]),
                   last = static_cast<std::size_t>(start[static_cast<std::size_t>(c) + 1]);
        std::sort(keys.begin() + static_cast<std::ptrdiff_t>(first), keys.begin() + static_cast<std::ptrdiff_t>(last));
        for (std::size_t k = first; k < last; ++k) order[k] = keys[k].index;
    }
}

namespace {

/// A box round a group [quanta].
struct Bounds {
    std::int64_t lo[3] = {INT64_MAX, INT64_MAX, INT64_MAX}, hi[3] = {INT64_MIN, INT64_MIN, INT64_MIN};
};
Bounds bounds(const PlaceRecord* places, const Group& g) {
    Bounds r;
    for (std::int32_t k = 0; k < g.size; ++k) {
        const PlaceRecord& p = places[g.first + k];
        const std::int64_t xyz[3] = {p.x, p.y, p.z};
        for (int a = 0; a < 3; ++a) {
            r.lo[a] = std::min(r.lo[a], xyz[a]);
            r.hi[a] = std::max(r.hi[a], xyz[a]);
        }
    }
    return r;
}

}  // namespace

void make_groups(const std::vector<PlaceRecord>& places, const std::vector<std::int32_t>& start, std::size_t first,
                 std::vector<Group>& groups) {
    groups.clear();
    for (std::size_t c = 0; c + 1 < start.size(); ++c)
        for (std::int32_t i = start[c]; i < start[c + 1]; i += simd::lanes) {
            Group g;
            g.first = static_cast<std::int32_t>(first) + i;
            g.size = std::min(simd::lanes, start[c + 1] - i);
            const Bounds box = bounds(places.data(), g);
            g.x = static_cast<std::int32_t>((box.lo[0] + box.hi[0]) / 2);
            g.y = static_cast<std::int32_t>((box.lo[1] + box.hi[1]) / 2);
            g.z = static_cast<std::int32_t>((box.lo[2] + box.hi[2]) / 2);
            groups.push_back(g);
        }
}

namespace {

/// Adds to `out` the places of a source within reach [quanta] of the group's particles.
void collect(const ColumnGrid& grid, const Bounds& box, const GroupReach& group, double reach, const Source& source,
             const Passes& pass, std::vector<NeighbourBlock>& out) {
    const auto r = static_cast<std::int64_t>(std::ceil(reach));
    const int x1 = grid.column_x(box.hi[0] + r), y1 = grid.column_y(box.hi[1] + r);
    const PlaceRecord* all_end = source.places + source.start->back();
    for (int cy = grid.column_y(box.lo[1] - r); cy <= y1; ++cy) {
        const double gap_y = grid.gap_y(cy, box.lo[1], box.hi[1]);
        for (int cx = grid.column_x(box.lo[0] - r); cx <= x1; ++cx) {
            const double gap_x = grid.gap_x(cx, box.lo[0], box.hi[0]);
            const double left2 = reach * reach - gap_x * gap_x - gap_y * gap_y;
            if (left2 < 0) continue;
            const auto up = static_cast<std::int64_t>(std::ceil(std::sqrt(left2)));
            const auto c = static_cast<std::size_t>(cy * grid.nx + cx);
            const PlaceRecord* end = source.places + (*source.start)[c + 1];
            const PlaceRecord* p = std::lower_bound(source.places + (*source.start)[c], end, box.lo[2] - up,
                                                    [](const PlaceRecord& a, std::int64_t z) { return a.z < z; });
            for (; p < end && p->z <= box.hi[2] + up; p += 32) {
                const std::uint32_t there = end - p < 32 ? (1u << (end - p)) - 1 : ~0u;
                const Reached near = pass.reached(group, p, all_end, there);
                if (near.within == 0) continue;
                out.push_back({source.offset + static_cast<std::int32_t>(p - source.places), near.within,
                               near.within & ~near.surely});
            }
        }
    }
}

}  // namespace

void NeighbourLists::build(const ColumnGrid& grid, const Quanta& quanta, const PlaceRecord* targets,
                           std::vector<Group>& groups, const std::vector<Source>& sources, double reach, double sure,
                           bool wall) {
    constexpr std::size_t per_chunk = 32;
    const std::size_t chunks = (groups.size() + per_chunk - 1) / per_chunk;
    chunks_.resize(chunks);
    const Passes& pass = passes();
    const double reach_q = reach / quanta.size, sure_q = sure / quanta.size;
#pragma omp parallel
    {
        std::vector<NeighbourBlock> scratch;
        std::int32_t sizes[per_chunk];
#pragma omp for schedule(dynamic, 4)
        for (std::size_t k = 0; k < chunks; ++k) {
            scratch.clear();
            const std::size_t first = k * per_chunk, last = std::min(groups.size(), first + per_chunk);
            for (std::size_t n = first; n < last; ++n) {
                const std::size_t before = scratch.size();
                const Bounds box = bounds(targets, groups[n]);
                const GroupReach group =
                    pass.reach_of(targets, groups[n], static_cast<float>(reach_q), static_cast<float>(sure_q));
                for (const Source& s : sources) collect(grid, box, group, reach_q, s, pass, scratch);
                sizes[n - first] = static_cast<std::int32_t>(scratch.size() - before);
            }
            chunks_[k].assign(scratch.begin(), scratch.end());
            NeighbourBlock* at = chunks_[k].data();
            for (std::size_t n = first; n < last; ++n) {
                (wall ? groups[n].wall_list : groups[n].list) = at;
                (wall ? groups[n].wall_size : groups[n].list_size) = sizes[n - first];
                at += sizes[n - first];
            }
        }
    }
}

std::size_t NeighbourLists::bytes() const {
    std::size_t n = 0;
    for (const auto& c : chunks_) n += c.capacity() * sizeof(NeighbourBlock);
    return n;
}

}  // namespace tw
