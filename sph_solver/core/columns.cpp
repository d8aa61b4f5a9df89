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
    order.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        order[static_cast<std::size_t>(fill[static_cast<std::size_t>(column[i])]++)] =
            static_cast<std::int32_t>(begin + i);
    const auto before = [&](std::int32_t a, std::int32_t b) {
        const PlaceRecord &p = places[static_cast<std::size_t>(a)], &q = places[static_cast<std::size_t>(b)];
        if (p.z != q.z) return p.z < q.z;
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        return a < b;
    };
#pragma omp parallel for schedule(dynamic, 64)
    for (int c = 0; c < grid.count(); ++c)
        std::sort(order.begin() + start[static_cast<std::size_t>(c)],
                  order.begin() + start[static_cast<std::size_t>(c) + 1], before);
}

void make_groups(const std::vector<PlaceRecord>& places, const std::vector<std::int32_t>& start, std::size_t first,
                 std::vector<Group>& groups) {
    groups.clear();
    for (std::size_t c = 0; c + 1 < start.size(); ++c)
        for (std::int32_t i = start[c]; i < start[c + 1]; i += simd::lanes) {
            Group g;
            g.first = static_cast<std::int32_t>(first) + i;
            g.size = std::min(simd::lanes, start[c + 1] - i);
            std::int64_t lo[3] = {INT64_MAX, INT64_MAX, INT64_MAX}, hi[3] = {INT64_MIN, INT64_MIN, INT64_MIN};
            for (std::int32_t k = 0; k < g.size; ++k) {
                const PlaceRecord& p = places[static_cast<std::size_t>(g.first + k)];
                const std::int64_t xyz[3] = {p.x, p.y, p.z};
                for (int a = 0; a < 3; ++a) {
                    lo[a] = std::min(lo[a], xyz[a]);
                    hi[a] = std::max(hi[a], xyz[a]);
                }
            }
            g.x = static_cast<std::int32_t>((lo[0] + hi[0]) / 2);
            g.y = static_cast<std::int32_t>((lo[1] + hi[1]) / 2);
            g.z = static_cast<std::int32_t>((lo[2] + hi[2]) / 2);
            groups.push_back(g);
        }
}

namespace {

/// A box round a group and all within its reach [quanta].
struct Neighbourhood {
    std::int64_t lo[3] = {INT64_MAX, INT64_MAX, INT64_MAX}, hi[3] = {INT64_MIN, INT64_MIN, INT64_MIN};
};
Neighbourhood neighbourhood(const PlaceRecord* places, const Group& g, std::int64_t reach) {
    Neighbourhood r;
    for (std::int32_t k = 0; k < g.size; ++k) {
        const PlaceRecord& p = places[g.first + k];
        const std::int64_t xyz[3] = {p.x, p.y, p.z};
        for (int a = 0; a < 3; ++a) {
            r.lo[a] = std::min(r.lo[a], xyz[a] - reach);
            r.hi[a] = std::max(r.hi[a], xyz[a] + reach);
        }
    }
    return r;
}

/// Adds to `out` the places of a source within reach of the group's particles.
void collect(const ColumnGrid& grid, const Neighbourhood& box, const GroupReach& group, const Source& source,
             const Passes& pass, std::vector<NeighbourBlock>& out) {
    const int x1 = grid.column_x(box.hi[0]), y1 = grid.column_y(box.hi[1]);
    for (int cy = grid.column_y(box.lo[1]); cy <= y1; ++cy)
        for (int cx = grid.column_x(box.lo[0]); cx <= x1; ++cx) {
            const auto c = static_cast<std::size_t>(cy * grid.nx + cx);
            const PlaceRecord* end = source.places + (*source.start)[c + 1];
            const PlaceRecord* p = std::lower_bound(source.places + (*source.start)[c], end, box.lo[2],
                                                    [](const PlaceRecord& a, std::int64_t z) { return a.z < z; });
            for (; p < end && p->z <= box.hi[2]; p += 32) {
                const std::uint32_t there = end - p < 32 ? (1u << (end - p)) - 1 : ~0u;
                const Reached near = pass.reached(group, p, end, there);
                if (near.within == 0) continue;
                out.push_back({source.offset + static_cast<std::int32_t>(p - source.places), near.within,
                               near.within & ~near.surely});
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
                const Neighbourhood box =
                    neighbourhood(targets, groups[n], static_cast<std::int64_t>(std::ceil(reach_q)));
                const GroupReach group =
                    pass.reach_of(targets, groups[n], static_cast<float>(reach_q), static_cast<float>(sure_q));
                for (const Source& s : sources) collect(grid, box, group, s, pass, scratch);
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
