// Fields of a level at points that are none of its particles: dummies, samples, and the particles of other levels.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/equations/wall_pressure.h"
#include "sph_solver/levels/level.h"
#include "sph_solver/sweeps/interpolate.h"

namespace tw {

namespace {

/// Points in the order and the groups in which the sweeps visit them.
struct SortedPlaces {
    ColumnGrid grid;
    std::vector<std::int32_t> order, start;  ///< order[k]: which point stands at k
    std::vector<PlaceRecord> places;
    std::vector<Group> groups;
    NeighbourLists lists;

    /// `apart`: distance between points [spacings of the level]. `wanted`: which columns of them; empty: all.
    SortedPlaces(const std::vector<Vec3>& points, double apart, const Level& level,
                 const std::function<bool(int)>& wanted = {})
        : grid(level.grid().scaled(apart)) {
        std::vector<WidePlace> raw(points.size());
        for_particles(raw.size(), [&](std::size_t k) { raw[k] = level.quanta().wide(points[k]); });
        sort_by_column(grid, raw, order, start);
        places.resize(raw.size());
        for_particles(raw.size(),
                      [&](std::size_t k) { places[k] = raw[static_cast<std::size_t>(order[k])].record(0); });
        make_groups(sorted(), level.passes().lanes, groups, wanted);
    }
    SortedPlaces(const SortedPlaces&) = delete;

    Source sorted() const { return {&grid, places.data(), &start, 0}; }

    /// `travel`: how far the sources have moved since they were sorted [m].
    void find_neighbours(const Kernel& kernel, const Level& level, const std::vector<Source>& sources, double travel) {
        lists.build(level.passes(), level.quanta(), sorted(), groups, sources, reaches(kernel, level, travel));
    }
    static Reaches reaches(const Kernel& kernel, const Level& level, double travel) {
        const double support = kernel.support();
        return {support, support, support, stale(level, travel)};
    }
    /// How far sources may be from where they were sorted, with a margin, because the travel is that of particles that
    /// the water's equations move: what others come farther is missing at the rim of the kernel, where it weighs
    /// (0.1 dp / 2h)^4 at most.
    static double stale(const Level& level, double travel) { return travel + 0.1 * level.setup().dp; }
};

/// The heights between which a column of a grid has something within reach of some places [quanta]; none: from > to.
struct Span {
    std::int64_t from = INT64_MAX, to = INT64_MIN;
};
std::vector<Span> within_reach(const SortedPlaces& of, const ColumnGrid& grid, double reach) {
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
        // columns at the rim hold whatever lies beyond
        const int cx = c % of.grid.nx, cy = c / of.grid.nx % of.grid.ny;
        const int x0 = cx == 0 ? 0 : grid.column_x(centre.x - half), y0 = cy == 0 ? 0 : grid.column_y(centre.y - half),
                  x1 = cx == of.grid.nx - 1 ? grid.nx - 1 : grid.column_x(centre.x + half),
                  y1 = cy == of.grid.ny - 1 ? grid.ny - 1 : grid.column_y(centre.y + half);
        for (int z = grid.slab(span.from); z <= grid.slab(span.to); ++z)
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x) {
                    Span& known = spans[static_cast<std::size_t>(grid.column(x, y, z))];
                    known = {std::min(known.from, span.from), std::max(known.to, span.to)};
                }
    }
    return spans;
}

}  // namespace

ExtrapolateData Level::extrapolation() const {
    ExtrapolateData e;
    e.water = water_view();
    e.gx = static_cast<float>(around_.weight().x());
    e.gy = static_cast<float>(around_.weight().y());
    e.gz = static_cast<float>(around_.weight().z());
    return e;
}

void Level::sample(PointSamples& points) const {
    const std::size_t n = points.places.size();
    points.p.assign(n, 0);
    points.support.assign(n, 0);
    if (points.want_flux) points.flux.assign(6 * n, 0);
    if (n == 0) return;
    SortedPlaces sorted(points.places, 1, *this, own_columns());  // whose columns are those of the particles
    if (!device_) sorted.find_neighbours(kernel_, *this, sources(), life_.travel);
    std::vector<float> p(n), support(n), flux(points.want_flux ? 6 * n : 0);
    ExtrapolateData e = extrapolation();
    e.list = sorted.lists.view();
    e.at = sorted.places.data();
    e.p = p.data();
    e.support = support.data();
    if (points.want_flux) {
        e.carried = particles_.carried.data();
        e.flux = flux.data();
        e.gx = e.gy = e.gz = 0;  // pairs carry the particles' own pressure
    }
    if (device_)
        device_->sample({sorted.places, sorted.start, sorted.groups},
                        sorted.reaches(kernel_, *this, life_.travel) / quanta_.size, e);
    else
        for_pairs(passes_, e, sorted.groups);
    for (std::size_t k = 0; k < n; ++k) {
        const auto i = static_cast<std::size_t>(sorted.order[k]);
        points.p[i] = p[k];
        points.support[i] = support[k];
        if (around_.at_rest && !points.want_flux && support[k] > WallPressure::least_support)
            points.p[i] += static_cast<float>(around_.at_rest->at(points.places[i].z()));
        for (std::size_t a = 0; a < 6 && points.want_flux; ++a) points.flux[6 * i + a] = flux[6 * k + a];
    }
    tell_samples(points);
}

/// Each point is worked out by one rank, and nothing on the others.
void Level::tell_samples(PointSamples& points) const {
    for (std::vector<float>* values : {&points.p, &points.support, &points.flux})
        ranks().take_from_owners(std::span(*values));
}

double Level::density_of_row() const {
    const double c0 = setup_.state_equation.c0;
    return setup_.rho0 * around_.gravity.norm() * setup_.dp / (c0 * c0);
}

Reaches Level::reaches_of_interpolation() const {
    return SortedPlaces::reaches(Kernel(interpolation_h_over_dp * setup_.dp, around_.dimensions), *this, life_.travel);
}

InterpolateData Level::interpolation() const {
    const Eigen::Vector3f slope =
        (setup_.rho0 / (setup_.state_equation.c0 * setup_.state_equation.c0) * around_.gravity).cast<float>();
    InterpolateData d;
    d.water.kernel = Kernel(interpolation_h_over_dp * setup_.dp, around_.dimensions);
    d.water.quantum = static_cast<float>(quanta_.size);
    d.gx = slope.x(), d.gy = slope.y(), d.gz = slope.z();
    d.water.two_dimensional = around_.dimensions == 2;
    return d;
}

TakeGiving Level::giving(const Asking& asking) {
    const Particles& p = particles_;
    return {.place = p.place.data(),
            .motion = p.velocity_density.data(),
            .shift = p.shift_support.data(),
            .density_rate = p.density_rate.data(),
            .kind = p.kind.data(),
            .links = ghosts_.links().data(),
            .n = p.size(),
            .of = asking.of,
            .density_before = asking.density_before,
            .without = asking.without ? *asking.without : SurfaceExcess(),
            .row = density_of_row(),
            .to_place = nullptr,
            .to_motion = nullptr,
            .known_support = nullptr,
            .rate = nullptr};
}

double Level::reach_of_others() const {
    if (!particles_.has(With::coarser) && !particles_.has(With::finer)) return 0;
    return Kernel(interpolation_h_over_dp * setup_.dp, around_.dimensions).support() +
           ListLife::wall_skin_over_dp * setup_.dp;
}

void Level::interpolate(FieldsAt& at) {
    at.resize();
    if (ranks().many()) return interpolate_together(at);
    if (at.places.empty()) return;
    if (device_) return device_->interpolate(at);
    update_records();
    interpolate_here(at);
}

void Level::interpolate_here(FieldsAt& at) {
    const std::size_t n = at.places.size(), own = particles_.size();
    at.resize();
    if (n == 0) return;
    InterpolateData d = interpolation();
    SortedPlaces sorted(at.places, at.apart, *this);
    const Reaches reaches = reaches_of_interpolation();
    const std::vector<Span> asked = within_reach(sorted, grid_, (reaches.far + reaches.stale) / quanta_.size);
    TakeGiving giving = this->giving(at);
    // of those that count and may be asked for, in the order of the level's particles and then of their images
    std::vector<PlaceRecord> place;
    std::vector<VelocityDensityRecord> motion;
    std::vector<float> known_support, rate;
    const auto take = [&](const std::vector<std::int32_t>& all_start, std::size_t offset) {
        const std::size_t columns = all_start.size() - 1, before = place.size();
        const auto each_in = [&](std::size_t column, const auto& f) {
            const Span& span = asked[column];
            if (span.from > span.to) return;
            const std::int64_t middle = grid_.centre(static_cast<int>(column)).z;
            for (auto k = static_cast<std::size_t>(all_start[column]);
                 k < static_cast<std::size_t>(all_start[column + 1]); ++k) {
                const std::int64_t z =
                    middle + difference(particles_.place[offset + k].z, static_cast<std::int32_t>(middle));
                if (z >= span.from && z <= span.to && giving.counts(offset + k)) f(offset + k);
            }
        };
        std::vector<std::int32_t> start(all_start.size(), 0);
        for_particles(columns, [&](std::size_t c) { each_in(c, [&](std::size_t) { ++start[c + 1]; }); });
        std::partial_sum(start.begin(), start.end(), start.begin());
        const std::size_t end = before + static_cast<std::size_t>(start.back());
        place.resize(end), motion.resize(end), known_support.resize(at.without ? end : 0);
        rate.resize(at.want_compression ? end : 0);
        giving.to_place = place.data(), giving.to_motion = motion.data();
        giving.known_support = at.without ? known_support.data() : nullptr;
        giving.rate = at.want_compression ? rate.data() : nullptr;
        for_particles(columns, [&](std::size_t c) {
            std::size_t k = before + static_cast<std::size_t>(start[c]);
            each_in(c, [&](std::size_t i) { giving.put(i, k++); });
        });
        return start;
    };
    const std::vector<std::int32_t> start = take(start_, 0), images_start = take(ghosts_.start(), own);
    const auto images_from = static_cast<std::int32_t>(start.back());
    const std::vector<Source> from{{&grid_, place.data(), &start, 0},
                                   {&grid_, place.data() + images_from, &images_start, images_from}};
    sorted.find_neighbours(d.water.kernel, *this, from, life_.travel);
    FieldsAt in_order{at};
    d.list = sorted.lists.view();
    d.at = sorted.places.data();
    d.water.place = place.data(), d.water.motion = motion.data();
    d.known_support = giving.known_support, d.rate = giving.rate;
    d.value = in_order.value.data(), d.support = in_order.support.data();
    d.mean_support = in_order.mean_support.data();
    d.compression = at.want_compression ? in_order.compression.data() : nullptr;
    for_pairs(passes_, d, sorted.groups);
    for_particles(n, [&](std::size_t k) { at.take(static_cast<std::size_t>(sorted.order[k]), in_order.given(k)); });
}

}  // namespace tw
