// Fields of a level on a device at points that are none of its particles: samples, and the particles of other levels.
#include <numeric>

#include "sph_solver/levels/arrays_on_device.h"
#include "sph_solver/pair_loops/interpolate.h"

namespace tw {

void LevelOnDevice::sample(SortedPlaces& points, const ExtrapolateData& to) {
    cuda::Device& d = *device_;
    const std::size_t n = points.places.size();
    cuda::Array<PackedPlace> places(d);
    cuda::Array<Cluster> clusters(d);
    cuda::Array<int> pencil(d);
    cuda::Array<float> p(d), support(d);
    ListsOnDevice lists(d);
    places.upload(points.places), clusters.upload(points.clusters);
    pencil.upload(pencils_of(points.clusters, points.start));
    p.resize(n), support.resize(n);
    p.set_zero(), support.set_zero();  // at those of other ranks nothing is found
    lists.build(level_.grid, level_.grid, places.data(), pencil, clusters, sources(),
                level_.reaches_of_points(level_.kernel) / level_.fixed_point.size);
    ExtrapolateData e = to;
    e.water = water();
    e.list = lists.view();
    e.at = places.data(), e.p = p.data(), e.support = support.data();
    cuda::launch_pairs(*device_, e, clusters);
    p.download(std::span(to.p, n)), support.download(std::span(to.support, n));
}

/// Copies what counts of the level's particles and images to arrays of its own, where neighbours can be looked for.
std::vector<cuda::DeviceSource> LevelOnDevice::note_giving(const Asking& asking) {
    Arrays& on = *on_;
    const std::size_t n = on.p.size(), all = on.p.place.size();
    TakeGiving take = level_.giving(on.p.all(), on.links.data(), n, asking);
    cuda::launch(*device_, cuda::MarkGiving{take, on.gives.of(all)}, all);
    const auto giving = static_cast<std::size_t>(on.gives.add_up());
    on.giving_place.resize(giving), on.giving_motion.resize(giving);
    on.giving_support.resize(asking.without ? giving : 0);
    on.giving_rate.resize(asking.want_compression ? giving : 0);
    take.to_place = on.giving_place.data(), take.to_motion = on.giving_motion.data();
    take.known_support = or_null(on.giving_support), take.rate = or_null(on.giving_rate);
    cuda::launch(*device_, cuda::PutGiving{take, on.gives.numbers(), on.gives.before()}, all);
    const auto pencils = static_cast<std::size_t>(level_.grid.count()) + 1;
    const auto source = [&](const SortedOnDevice& order, std::size_t from, cuda::Array<int>& start) {
        start.resize(pencils);
        cuda::launch(*device_,
                     cuda::StartGiving{order.start(), order.in_pencil(), from, on.gives.before(), start.data()},
                     pencils);
        return cuda::DeviceSource{on.giving_place.data(), start.data(), 1, 0};
    };
    return {source(on.order, 0, on.giving_start), source(on.image_order, n, on.giving_images)};
}

cuda::FoundAt LevelOnDevice::ask(const cuda::Array<WidePlace>& wide, const Asking& asking) {
    pack_state();
    Arrays& on = *on_;
    const PencilGrid grid = level_.grid.scaled(asking.apart);
    const double unit = level_.fixed_point.size;
    Arrays::Asked& at =
        on.asked.try_emplace(asking.apart, *device_, bins_of(grid, asking.apart * level_.setup.dp, unit)).first->second;
    const std::size_t n = at.order.sort(wide.data(), nullptr, nullptr, wide.size());
    at.place.resize(n), at.value.resize(n), at.support.resize(n), at.mean_support.resize(n);
    at.compression.resize(asking.want_compression ? n : 0);
    cuda::launch(*device_, cuda::SortAsked{at.order.order(), wide.data(), at.place.data()}, n);
    at.clusters.make(grid, at.order, at.place.data());
    const std::vector<cuda::DeviceSource> giving = note_giving(asking);
    at.lists.build(level_.grid, grid, at.place.data(), at.clusters.pencil(), at.clusters.clusters(), giving,
                   level_.reaches_of_interpolation() / unit);
    InterpolateData d = level_.interpolation();
    d.list = at.lists.view();
    d.at = at.place.data();
    d.water.place = on.giving_place.data(), d.water.motion = on.giving_motion.data();
    d.known_support = or_null(on.giving_support), d.rate = or_null(on.giving_rate);
    d.value = at.value.data(), d.support = at.support.data(), d.mean_support = at.mean_support.data();
    d.compression = or_null(at.compression);
    at.mean_support.set_zero(), at.compression.set_zero();  // where nobody gives anything they are not worked out
    cuda::launch_pairs(*device_, d, at.clusters.clusters());
    return {at.order.order(), d.value, d.support, d.mean_support, d.compression};
}

/// Fields of another level where those in `which` are, or will be after a time [s].
cuda::FoundAt LevelOnDevice::ask_other(EdgeSteps& level, double ahead, const Asking& asking) {
    if (shared()) return ask_ranks(level, ahead, asking);
    Arrays& on = *on_;
    auto& other = static_cast<LevelOnDevice&>(level);
    const std::size_t n = on.which.size();
    on.wide_of_others.resize(n);
    cuda::launch(
        *device_,
        cuda::PlacesToAsk{on.p.view(), ahead, other.level_.to_fixed_point(), on.which.data(), on.wide_of_others.data()},
        n);
    return other.ask(on.wide_of_others, asking);
}

/// The same of several ranks, each of which has its part of the other level.
cuda::FoundAt LevelOnDevice::ask_ranks(EdgeSteps& level, double ahead, const Asking& asking) {
    Arrays& on = *on_;
    const std::size_t n = on.which.size();
    on.places_ahead.resize(n);
    cuda::launch(*device_, cuda::PlacesAhead{on.p.view(), ahead, on.which.data(), on.places_ahead.data()}, n);
    std::vector<V3<double>> places(n);
    on.places_ahead.download(places);
    FieldsAt at{asking};
    for (const V3<double>& x : places) at.places.emplace_back(x.x, x.y, x.z);
    level.interpolate(at);
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    on.found_order.upload(order);
    on.found_value.upload(at.value), on.found_support.upload(at.support), on.found_mean.upload(at.mean_support);
    on.found_compression.upload(at.compression);
    return {on.found_order.data(), on.found_value.data(), on.found_support.data(), on.found_mean.data(),
            or_null(on.found_compression)};
}

void LevelOnDevice::interpolate(FieldsAt& at) {
    at.resize();
    if (shared())
        share_.interpolate_together(at, [this](FieldsAt& here) { interpolate_here(here); });
    else if (!at.places.empty())
        interpolate_here(at);
}

void LevelOnDevice::interpolate_here(FieldsAt& at) {
    at.resize();
    if (at.places.empty()) return pack_state();  // as the other ranks do
    Arrays& on = *on_;
    std::vector<WidePlace> wide;
    for (const Vec3& x : at.places) wide.push_back(level_.fixed_point.wide(x));
    on.wide_of_others.upload(wide);
    const cuda::FoundAt found = ask(on.wide_of_others, at);
    on.given.resize(wide.size());
    cuda::launch(*device_, cuda::HandToHost{found, on.given.data()}, wide.size());
    std::vector<Given> given(wide.size());
    on.given.download(given);
    for (std::size_t k = 0; k < given.size(); ++k) at.take(k, given[k]);
}

}  // namespace tw
