// Fields of a level on a processor at points that are none of its particles: samples, and the particles of other
// levels.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/levels/on_processor.h"
#include "sph_solver/pair_loops/interpolate.h"

namespace tw {

namespace {

/// The heights between which a pencil of a grid has something within reach of some places [fixed-point units]; none:
/// from > to.
struct Span {
    std::int64_t from = INT64_MAX, to = INT64_MIN;
};
std::vector<Span> within_reach(const SortedPlaces& of, const PencilGrid& grid, double reach) {
    const auto r = static_cast<std::int64_t>(std::ceil(reach));
    std::vector<Span> spans(static_cast<std::size_t>(grid.count()));
    for (int c = 0; c < of.grid.count(); ++c) {
        const auto first = static_cast<std::size_t>(of.start[static_cast<std::size_t>(c)]),
                   end = static_cast<std::size_t>(of.start[static_cast<std::size_t>(c) + 1]);
        if (first == end) continue;
        const WidePlace centre = of.grid.centre(c);
        const std::int64_t half = of.grid.width / 2 + 1 + r;
        const auto height = [&](std::size_t k) {
            return centre.z + difference(of.places[k].z, static_cast<std::int32_t>(centre.z));
        };
        const Span span{height(first) - r, height(end - 1) + r};
        // pencils at the rim hold whatever lies beyond
        const int cx = c % of.grid.nx, cy = c / of.grid.nx % of.grid.ny;
        const int x0 = cx == 0 ? 0 : grid.pencil_x(centre.x - half), y0 = cy == 0 ? 0 : grid.pencil_y(centre.y - half),
                  x1 = cx == of.grid.nx - 1 ? grid.nx - 1 : grid.pencil_x(centre.x + half),
                  y1 = cy == of.grid.ny - 1 ? grid.ny - 1 : grid.pencil_y(centre.y + half);
        for (int z = grid.slab(span.from); z <= grid.slab(span.to); ++z)
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x) {
                    Span& known = spans[static_cast<std::size_t>(grid.pencil(x, y, z))];
                    known = {std::min(known.from, span.from), std::max(known.to, span.to)};
                }
    }
    return spans;
}

}  // namespace

void LevelOnProcessor::sample(SortedPlaces& points, const ExtrapolateData& to) {
    points.find_neighbours(level_.kernel, level_, sources());
    ExtrapolateData e = to;
    e.list = points.lists.view();
    for_pairs(level_.passes, e, points.clusters);
}

void LevelOnProcessor::interpolate(FieldsAt& at) {
    at.resize();
    if (share_.ranks().many())
        return share_.interpolate_together(at, [&](FieldsAt& here) {
            pack_state();
            interpolate_here(here);
        });
    if (at.places.empty()) return;
    pack_state();
    interpolate_here(at);
}

void LevelOnProcessor::interpolate_here(FieldsAt& at) {
    const std::size_t n = at.places.size(), own = level_.particles.size();
    at.resize();
    if (n == 0) return;
    InterpolateData d = level_.interpolation();
    SortedPlaces sorted(at.places, at.apart, level_);
    const Reaches reaches = level_.reaches_of_interpolation();
    const std::vector<Span> asked =
        within_reach(sorted, level_.grid, (reaches.far + reaches.stale) / level_.fixed_point.size);
    TakeGiving giving = level_.giving(level_.particles.view(), level_.ghosts.links().data(), own, at);
    // of those that count and may be asked for, in the order of the level's particles and then of their images
    std::vector<PackedPlace> place;
    std::vector<PackedVelocityDensity> motion;
    std::vector<float> known_support, rate;
    const auto take = [&](const std::vector<std::int32_t>& all_start, std::size_t offset) {
        const std::size_t pencils = all_start.size() - 1, before = place.size();
        const auto each_in = [&](std::size_t pencil, const auto& f) {
            const Span& span = asked[pencil];
            if (span.from > span.to) return;
            const std::int64_t middle = level_.grid.centre(static_cast<int>(pencil)).z;
            for (auto k = static_cast<std::size_t>(all_start[pencil]);
                 k < static_cast<std::size_t>(all_start[pencil + 1]); ++k) {
                const std::int64_t z =
                    middle + difference(level_.particles.place[offset + k].z, static_cast<std::int32_t>(middle));
                if (z >= span.from && z <= span.to && giving.counts(offset + k)) f(offset + k);
            }
        };
        std::vector<std::int32_t> start(all_start.size(), 0);
        for_particles(pencils, [&](std::size_t c) { each_in(c, [&](std::size_t) { ++start[c + 1]; }); });
        std::partial_sum(start.begin(), start.end(), start.begin());
        const std::size_t end = before + static_cast<std::size_t>(start.back());
        place.resize(end), motion.resize(end), known_support.resize(at.without ? end : 0);
        rate.resize(at.want_compression ? end : 0);
        giving.to_place = place.data(), giving.to_motion = motion.data();
        giving.known_support = at.without ? known_support.data() : nullptr;
        giving.rate = at.want_compression ? rate.data() : nullptr;
        for_particles(pencils, [&](std::size_t c) {
            std::size_t k = before + static_cast<std::size_t>(start[c]);
            each_in(c, [&](std::size_t i) { giving.put(i, k++); });
        });
        return start;
    };
    const std::vector<std::int32_t> start = take(level_.near.start, 0), images_start = take(level_.ghosts.start(), own);
    const auto images_from = static_cast<std::int32_t>(start.back());
    const std::vector<Source> from{{&level_.grid, place.data(), &start, 0},
                                   {&level_.grid, place.data() + images_from, &images_start, images_from}};
    sorted.find_neighbours(d.water.kernel, level_, from);
    FieldsAt in_order{at};
    d.list = sorted.lists.view();
    d.at = sorted.places.data();
    d.water.place = place.data(), d.water.motion = motion.data();
    d.known_support = giving.known_support, d.rate = giving.rate;
    d.value = in_order.value.data(), d.support = in_order.support.data();
    d.mean_support = in_order.mean_support.data();
    d.compression = at.want_compression ? in_order.compression.data() : nullptr;
    for_pairs(level_.passes, d, sorted.clusters);
    for_particles(n, [&](std::size_t k) { at.take(static_cast<std::size_t>(sorted.order[k]), in_order.given(k)); });
}

}  // namespace tw
