#include "sph_solver/neighbours/pencils.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/errors.h"
#include "sph_solver/backend/for_particles.h"

namespace tw {

PencilGrid::PencilGrid(const Box& area, double dp, int dimensions, const FixedPoint& fixed_point, int lanes) {
    constexpr double tallest = 4096;
    const double edge = dimensions == 3 ? std::cbrt(double(lanes)) * dp : std::sqrt(double(lanes)) * dp;
    const auto pencils = [](double length, double each) { return std::max(1.0, std::ceil(length / each)); };
    const double x = pencils(area.size().x(), edge), y = dimensions == 3 ? pencils(area.size().y(), edge) : 1,
                 z = pencils(area.size().z(), tallest * dp);
    if (x * y * z > 1e9)
        throw InputError("the domain has more than 10^9 columns of particles; often a spacing far too small");
    width = static_cast<std::int64_t>(edge / fixed_point.size);
    height = static_cast<std::int64_t>(std::ceil(area.size().z() / z / fixed_point.size)) + 1;
    x0 = fixed_point.wide(area.min.x(), 0);
    y0 = dimensions == 3 ? fixed_point.wide(area.min.y(), 1) : -width / 2;
    z0 = fixed_point.wide(area.min.z(), 2);
    nx = static_cast<int>(x), ny = static_cast<int>(y), nz = static_cast<int>(z);
}

PencilGrid PencilGrid::scaled(double factor) const {
    PencilGrid to = *this;
    to.width = std::max<std::int64_t>(1, std::llround(double(width) * factor));
    const auto pencils = [&](int n) { return n == 1 ? 1 : static_cast<int>((n * width + to.width - 1) / to.width); };
    to.nx = pencils(nx), to.ny = pencils(ny);
    return to;
}

void sort_by_pencil(const PencilGrid& grid, const std::vector<WidePlace>& places, std::vector<std::int32_t>& order,
                    std::vector<std::int32_t>& start) {
    const std::size_t n = places.size();
    std::vector<std::int32_t> pencil(n);
    for_particles(n, [&](std::size_t i) { pencil[i] = grid.of(places[i]); });
    start.assign(static_cast<std::size_t>(grid.count()) + 1, 0);
    for (std::int32_t c : pencil) ++start[static_cast<std::size_t>(c) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::int32_t> fill(start.begin(), start.end() - 1);
    struct Key {
        std::int32_t z, x, y, index;
        auto operator<=>(const Key&) const = default;
    };
    std::vector<Key> keys(n);
    for (std::size_t i = 0; i < n; ++i) {
        const WidePlace &p = places[i], from = grid.centre(pencil[i]);
        keys[static_cast<std::size_t>(fill[static_cast<std::size_t>(pencil[i])]++)] = {
            static_cast<std::int32_t>(p.z - from.z), static_cast<std::int32_t>(p.x - from.x),
            static_cast<std::int32_t>(p.y - from.y), static_cast<std::int32_t>(i)};
    }
    order.resize(n);
    constexpr std::size_t per_piece = 64;
    const auto pencils = static_cast<std::size_t>(grid.count());
    for_pieces((pencils + per_piece - 1) / per_piece, [&](std::size_t piece) {
        for (std::size_t c = piece * per_piece; c < std::min(pencils, (piece + 1) * per_piece); ++c) {
            std::sort(keys.begin() + start[c], keys.begin() + start[c + 1]);
            for (auto k = static_cast<std::size_t>(start[c]); k < static_cast<std::size_t>(start[c + 1]); ++k)
                order[k] = keys[k].index;
        }
    });
}

namespace {

/// A box round a cluster [fixed-point units].
struct Bounds {
    std::int64_t lo[3] = {INT64_MAX, INT64_MAX, INT64_MAX}, hi[3] = {INT64_MIN, INT64_MIN, INT64_MIN};
};
/// `from`: the centre of the cluster's pencil.
Bounds bounds(const PackedPlace* places, const Cluster& g, const WidePlace& from) {
    const auto in_full = [](std::int32_t x, std::int64_t near) {
        return near + difference(x, static_cast<std::int32_t>(near));
    };
    Bounds r;
    for (std::int32_t k = 0; k < g.size; ++k) {
        const PackedPlace& p = places[g.first + k];
        const std::int64_t xyz[3] = {in_full(p.x, from.x), in_full(p.y, from.y), in_full(p.z, from.z)};
        for (int a = 0; a < 3; ++a) {
            r.lo[a] = std::min(r.lo[a], xyz[a]);
            r.hi[a] = std::max(r.hi[a], xyz[a]);
        }
    }
    return r;
}

}  // namespace

void order_coincident(const std::vector<WidePlace>& places, const std::vector<std::int32_t>& start,
                      const std::function<std::int64_t(std::int32_t)>& id, std::vector<std::int32_t>& order) {
    const auto same = [&](std::int32_t a, std::int32_t b) {
        const WidePlace &p = places[static_cast<std::size_t>(a)], &q = places[static_cast<std::size_t>(b)];
        return p.x == q.x && p.y == q.y && p.z == q.z;
    };
    for_particles(start.size() - 1, [&](std::size_t c) {
        const auto end = order.begin() + start[c + 1];
        for (auto first = order.begin() + start[c]; first != end;) {
            auto last = first + 1;
            while (last != end && same(*first, *last)) ++last;
            if (last - first > 1) std::sort(first, last, [&](auto a, auto b) { return id(a) < id(b); });
            first = last;
        }
    });
}

void make_clusters(const Source& source, int lanes, std::vector<Cluster>& clusters,
                   const std::function<bool(int pencil)>& wanted) {
    const std::vector<std::int32_t>& start = *source.start;
    clusters.clear();
    std::vector<int> pencil;
    for (std::size_t c = 0; c + 1 < start.size(); ++c) {
        if (wanted && !wanted(static_cast<int>(c))) continue;
        for (std::int32_t i = start[c]; i < start[c + 1]; i += lanes) {
            Cluster g;
            g.first = i;
            g.size = std::min(lanes, start[c + 1] - i);
            clusters.push_back(g);
            pencil.push_back(static_cast<int>(c));
        }
    }
    for_particles(clusters.size(), [&](std::size_t n) {
        Cluster& g = clusters[n];
        const Bounds box = bounds(source.places, g, source.grid->centre(pencil[n]));
        g.x = static_cast<std::int32_t>((box.lo[0] + box.hi[0]) / 2);
        g.y = static_cast<std::int32_t>((box.lo[1] + box.hi[1]) / 2);
        g.z = static_cast<std::int32_t>((box.lo[2] + box.hi[2]) / 2);
    });
}

namespace {

/// Looks for a cluster's neighbours pencil by pencil, for one cluster after another up a pencil: then what was too low
/// for one cluster is too low for the next, and no pencil is searched from its ends again.
class Search {
public:
    Search(double reach, const Source& source)
        : grid_(*source.grid), source_(source), reach_(reach), cursors_(static_cast<std::size_t>(grid_.count())) {}

    /// What comes next is not above what came last.
    void start_anew() { ++run_; }

    /// Adds to `out` the places within reach of the cluster's particles. `own`: a height in full near the cluster's.
    void collect(const Bounds& box, std::int64_t own, const ClusterReach& cluster, const Passes& pass,
                 std::vector<NeighbourBlock>& out) {
        const auto r = static_cast<std::int64_t>(std::ceil(reach_));
        const std::int64_t cluster_z = own + difference(cluster.z, static_cast<std::int32_t>(own));
        const int z1 = grid_.slab(box.hi[2] + r);
        for (int cz = grid_.slab(box.lo[2] - r); cz <= z1; ++cz)
            collect_in_slab(cz, r, box, cluster_z, cluster, pass, out);
    }

private:
    void collect_in_slab(int cz, std::int64_t r, const Bounds& box, std::int64_t cluster_z, const ClusterReach& cluster,
                         const Passes& pass, std::vector<NeighbourBlock>& out) {
        const int x0 = grid_.pencil_x(box.lo[0] - r), x1 = grid_.pencil_x(box.hi[0] + r),
                  y1 = grid_.pencil_y(box.hi[1] + r);
        const std::int64_t middle = grid_.middle_of_slab(cz);
        const auto below = [from = static_cast<std::int32_t>(middle)](const PackedPlace& p, std::int64_t z) {
            return difference(p.z, from) < z;
        };
        const PackedPlace* all_end = source_.places + source_.start->back();
        for (int cy = grid_.pencil_y(box.lo[1] - r); cy <= y1; ++cy) {
            const double gap_y = grid_.gap_y(cy, box.lo[1], box.hi[1]);
            for (int cx = x0; cx <= x1; ++cx) {
                const double gap_x = grid_.gap_x(cx, box.lo[0], box.hi[0]);
                const double left2 = reach_ * reach_ - gap_x * gap_x - gap_y * gap_y;
                if (left2 < 0) continue;
                const auto up = static_cast<std::int64_t>(std::ceil(std::sqrt(left2)));
                const auto c = static_cast<std::size_t>(grid_.pencil(cx, cy, cz));
                const PackedPlace* end = source_.places + (*source_.start)[c + 1];
                const PackedPlace* p = lowest(c, end, box.lo[2] - r - middle, below);
                while (p < end && below(*p, box.lo[2] - up - middle)) ++p;
                const std::int64_t top = box.hi[2] + up;
                for (; p < end && below(*p, top + 1 - middle); p += 32) {
                    const int count = end - p < 32 ? static_cast<int>(end - p) : 32;
                    const Reached near = pass.reached(cluster, p, all_end, count, top - cluster_z);
                    if (near.far == 0) continue;
                    out.push_back({source_.offset + static_cast<std::int32_t>(p - source_.places), near.now,
                                   near.far & ~near.sure});
                }
            }
        }
    }

    /// The pencil's first place not below z.
    template <class Below>
    const PackedPlace* lowest(std::size_t pencil, const PackedPlace* end, std::int64_t z, const Below& below) {
        Cursor& cursor = cursors_[pencil];
        const PackedPlace* p;
        if (cursor.run == run_) {
            p = source_.places + cursor.at;
            while (p < end && below(*p, z)) ++p;
        } else {
            p = std::lower_bound(source_.places + (*source_.start)[pencil], end, z, below);
        }
        cursor = {run_, static_cast<std::int32_t>(p - source_.places)};
        return p;
    }

    struct Cursor {
        std::int32_t run = 0, at = 0;
    };
    const PencilGrid& grid_;
    const Source& source_;
    double reach_;
    std::int32_t run_ = 0;
    std::vector<Cursor> cursors_;
};

}  // namespace

void NeighbourLists::build(const Passes& pass, const FixedPoint& fixed_point, const Source& targets,
                           std::vector<Cluster>& clusters, const std::vector<Source>& sources, const Reaches& reaches,
                           ListRef Cluster::*list) {
    constexpr std::size_t per_chunk = 32;
    const std::size_t chunks = (clusters.size() + per_chunk - 1) / per_chunk;
    chunks_.resize(chunks);
    starts_.resize(chunks);
    const Reaches in_fixed_point = reaches / fixed_point.size;
    struct Own {
        std::vector<NeighbourBlock> scratch;
        std::vector<Search> searches;  // made by threads that get something to do
        std::int32_t sizes[per_chunk];
    };
    for_pieces_with<Own>(chunks, [&](Own& own, std::size_t k) {
        auto& [scratch, searches, sizes] = own;
        scratch.clear();
        if (searches.empty())
            for (const Source& s : sources) searches.emplace_back(in_fixed_point.far + in_fixed_point.stale, s);
        const std::size_t first = k * per_chunk, last = std::min(clusters.size(), first + per_chunk);
        const std::vector<std::int32_t>& start = *targets.start;
        const auto after = std::upper_bound(start.begin(), start.end(), clusters[first].first);
        int pencil = static_cast<int>(after - start.begin()) - 1;
        for (Search& s : searches) s.start_anew();
        for (std::size_t n = first; n < last; ++n) {
            const std::size_t before = scratch.size();
            if (clusters[n].first >= start[static_cast<std::size_t>(pencil) + 1]) {
                while (clusters[n].first >= start[static_cast<std::size_t>(pencil) + 1]) ++pencil;
                for (Search& s : searches) s.start_anew();
            }
            const WidePlace centre = targets.grid->centre(pencil);
            const Bounds box = bounds(targets.places, clusters[n], centre);
            const ClusterReach cluster = pass.reach_of(targets.places, clusters[n], in_fixed_point);
            for (Search& s : searches) s.collect(box, centre.z, cluster, pass, scratch);
            sizes[n - first] = static_cast<std::int32_t>(scratch.size() - before);
        }
        chunks_[k].assign(scratch.begin(), scratch.end());
        starts_[k] = chunks_[k].data();
        std::int32_t at = 0;
        for (std::size_t n = first; n < last; ++n) {
            clusters[n].*list = {static_cast<std::int32_t>(k), at, sizes[n - first]};
            at += sizes[n - first];
        }
    });
}

std::int32_t number_wall_loads(std::vector<Cluster>& clusters, const Lists& walls,
                               const std::vector<std::int32_t>& body_end) {
    std::int32_t next = 0;
    for (Cluster& g : clusters) {
        g.wall_load = g.wall_list.size > 0 ? next : -1;
        const NeighbourBlock* const blocks = walls.blocks(g.wall_list);
        std::int32_t before = -1;
        for (std::int32_t k = 0; k < g.wall_list.size; ++k) {
            const auto end = std::upper_bound(body_end.begin(), body_end.end(), blocks[k].first);
            const auto body = static_cast<std::int32_t>(end - body_end.begin());
            next += body != before;
            before = body;
        }
    }
    return next;
}

std::size_t NeighbourLists::bytes() const {
    std::size_t n = starts_.capacity() * sizeof(NeighbourBlock*) + chunks_.capacity() * sizeof(chunks_[0]);
    for (const auto& c : chunks_) n += c.capacity() * sizeof(NeighbourBlock);
    return n;
}

}  // namespace tw
