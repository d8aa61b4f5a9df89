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

/// Half extents of a group about its centre [quanta].
struct Extent {
    float x = 0, y = 0, z = 0;
};
Extent extent(const GroupPlaces& g) {
    Extent e;
    for (int l = 0; l < simd::lanes; ++l) {
        e.x = std::max(e.x, std::fabs(g.x[l]));
        e.y = std::max(e.y, std::fabs(g.y[l]));
        e.z = std::max(e.z, std::fabs(g.z[l]));
    }
    return e;
}

GroupPlaces places_of(const PlaceRecord* places, const Group& g) {
    GroupPlaces r;
    for (int l = 0; l < simd::lanes; ++l) {
        const PlaceRecord& p = places[g.first + std::min(l, g.size - 1)];
        r.x[l] = static_cast<float>(p.x - g.x);
        r.y[l] = static_cast<float>(p.y - g.y);
        r.z[l] = static_cast<float>(p.z - g.z);
    }
    return r;
}

/// Adds to `out` the places of a source within reach of the group's particles: first by its bounding box, then, a block
/// at a time, by the particles themselves, which leaves out another fifth.
void collect(const ColumnGrid& grid, const Group& g, const GroupPlaces& lanes, const Source& source, std::int64_t reach,
             const Passes& pass, std::vector<NeighbourBlock>& out, std::int64_t& found) {
    const Extent e = extent(lanes);
    const auto ex = static_cast<std::int64_t>(e.x) + reach, ey = static_cast<std::int64_t>(e.y) + reach,
               ez = static_cast<std::int64_t>(e.z) + reach;
    const float reach2 = static_cast<float>(reach) * static_cast<float>(reach);
    const PlaceRecord* first = nullptr;  // of the present block
    std::uint32_t mask = 0;
    const auto flush = [&] {
        if (mask != 0) mask = pass.reached(lanes, g, first, mask, reach2);
        if (mask == 0) return;
        found += __builtin_popcount(mask);
        out.push_back({source.offset + static_cast<std::int32_t>(first - source.places), mask});
        mask = 0;
    };
    const int x1 = grid.column_x(g.x + ex), y1 = grid.column_y(g.y + ey);
    for (int cy = grid.column_y(g.y - ey); cy <= y1; ++cy)
        for (int cx = grid.column_x(g.x - ex); cx <= x1; ++cx) {
            const auto c = static_cast<std::size_t>(cy * grid.nx + cx);
            const PlaceRecord* end = source.places + (*source.start)[c + 1];
            const PlaceRecord* p = std::lower_bound(source.places + (*source.start)[c], end, g.z - ez,
                                                    [](const PlaceRecord& a, std::int64_t z) { return a.z < z; });
            for (; p < end && p->z <= g.z + ez; ++p) {
                const float dx = std::max(0.0f, std::fabs(static_cast<float>(p->x - g.x)) - e.x);
                const float dy = std::max(0.0f, std::fabs(static_cast<float>(p->y - g.y)) - e.y);
                const float dz = std::max(0.0f, std::fabs(static_cast<float>(p->z - g.z)) - e.z);
                if (dx * dx + dy * dy + dz * dz > reach2) continue;
                if (mask == 0 || p - first >= 32) {
                    flush();
                    first = p;
                }
                mask |= 1u << (p - first);
            }
            flush();
        }
}

}  // namespace

void NeighbourLists::build(const ColumnGrid& grid, const Quanta& quanta, const PlaceRecord* targets,
                           std::vector<Group>& groups, const std::vector<Source>& sources, double reach, bool wall) {
    constexpr std::size_t per_chunk = 32;
    const std::size_t chunks = (groups.size() + per_chunk - 1) / per_chunk;
    chunks_.resize(chunks);
    candidates_ = 0;
    const Passes& pass = passes();
    const auto reach_q = static_cast<std::int64_t>(std::ceil(reach / quanta.size));
#pragma omp parallel
    {
        std::vector<NeighbourBlock> scratch;
        std::int32_t sizes[per_chunk];
        std::int64_t pairs = 0;
#pragma omp for schedule(dynamic, 4)
        for (std::size_t k = 0; k < chunks; ++k) {
            scratch.clear();
            const std::size_t first = k * per_chunk, last = std::min(groups.size(), first + per_chunk);
            for (std::size_t n = first; n < last; ++n) {
                const std::size_t before = scratch.size();
                const GroupPlaces lanes = places_of(targets, groups[n]);
                std::int64_t found = 0;
                for (const Source& s : sources) collect(grid, groups[n], lanes, s, reach_q, pass, scratch, found);
                pairs += found * groups[n].size;
                sizes[n - first] = static_cast<std::int32_t>(scratch.size() - before);
            }
            chunks_[k].assign(scratch.begin(), scratch.end());
            const NeighbourBlock* at = chunks_[k].data();
            for (std::size_t n = first; n < last; ++n) {
                (wall ? groups[n].wall_list : groups[n].list) = at;
                (wall ? groups[n].wall_size : groups[n].list_size) = sizes[n - first];
                at += sizes[n - first];
            }
        }
#pragma omp atomic
        candidates_ += pairs;
    }
}

std::size_t NeighbourLists::bytes() const {
    std::size_t n = 0;
    for (const auto& c : chunks_) n += c.capacity() * sizeof(NeighbourBlock);
    return n;
}

}  // namespace tw
