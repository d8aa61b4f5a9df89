#include "sph_solver/bodies/walls.h"

#include <algorithm>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/bodies/slip_normal.h"

namespace tw {

Walls::Walls(const std::vector<Body>& bodies, const Surroundings& around, const LevelSetup& level,
             double kernel_support, const ColumnGrid& grid, const Quanta& quanta, int lanes)
    : loads(bodies.size()), bodies_(bodies) {
    Box region = around.domain;
    region.min.array() -= kernel_support;
    region.max.array() += kernel_support;
    std::vector<Vec3> places;
    for (const Body& body : bodies) {
        const Dummies d = make_dummies(body.query(), body.surface().bounds(), level.dp, kernel_support + level.dp,
                                       region, around.dimensions);
        std::vector<WidePlace> raw(d.places.size());
        for (std::size_t k = 0; k < raw.size(); ++k) raw[k] = quanta.wide(d.places[k]);
        Part& part = parts_.emplace_back();
        part.first = place_.size();
        std::vector<std::int32_t> order;
        sort_by_column(grid, raw, order, part.start);
        for (const std::int32_t n : order) {
            const auto k = static_cast<std::size_t>(n);
            place_.push_back(raw[k].record(static_cast<float>(d.volumes[k])));
            places.push_back(d.places[k]);
        }
        body_end_.push_back(static_cast<std::int32_t>(place_.size()));
        make_groups(grid, {place_.data() + part.first, &part.start, 0}, lanes, part.groups);
    }
    p_.assign(place_.size(), 0);
    take_motions(places);
}

/// What the dummies hand to the water of their body's motion.
void Walls::take_motions(const std::vector<Vec3>& places) {
    const bool all_fixed = std::ranges::all_of(bodies_, [](const Body& body) { return body.motion().fixed(); });
    const bool none_slides = std::ranges::all_of(bodies_, [](const Body& body) { return body.sliding().isZero(0); });
    std::size_t k = 0;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (; k < static_cast<std::size_t>(body_end_[b]); ++k) {
            const BodyMotion& motion = bodies_[b].motion();
            const Eigen::Vector3f u = motion.velocity_at(places[k]).cast<float>(),
                                  a = motion.acceleration_at(places[k]).cast<float>(),
                                  along = bodies_[b].sliding().cast<float>();
            if (!all_fixed) velocity_.push_back({u.x(), u.y(), u.z()});
            if (!all_fixed) acceleration_.push_back({a.x(), a.y(), a.z()});
            if (!none_slides) sliding_.push_back({along.x(), along.y(), along.z(), 0});
        }
}

void Walls::find_neighbours(const Passes& passes, const ColumnGrid& grid, const Quanta& quanta,
                            std::vector<Group>& groups, const std::vector<Source>& sources, const Reaches& reaches) {
    std::vector<Source> dummies;
    for (const Part& part : parts_)
        dummies.push_back({place_.data() + part.first, &part.start, static_cast<std::int32_t>(part.first)});
    lists_.build(passes, grid, quanta, sources.front(), groups, dummies, reaches, &Group::wall_list);
    for (Part& part : parts_) {
        part.near_water = part.groups;
        part.water.build(passes, grid, quanta, {place_.data() + part.first, &part.start, 0}, part.near_water, sources,
                         reaches);
        std::erase_if(part.near_water, [](const Group& g) { return g.list.size == 0; });
    }
    std::fill(p_.begin(), p_.end(), 0.0f);
    group_loads_.resize(static_cast<std::size_t>(number_wall_loads(groups, lists_.view(), body_end_)));
}

void Walls::prune(const Passes& passes, const PlaceRecord* particles, const std::vector<Group>& groups, double reach) {
    if (empty()) return;
    PruneData d;
    d.reach = reach;
    d.place = particles;
    for (const Part& part : parts_) {
        d.lists = part.water.view();
        d.of = place_.data() + part.first;
        for_pairs(passes.prune, d, part.near_water);
    }
    d.of = particles;
    d.place = place_.data();
    d.lists = lists_.view();
    d.list = &Group::wall_list;
    for_pairs(passes.prune, d, groups);
}

Walls::Nearest Walls::nearest(const Vec3& x, const Vec3& u, double reach) const {
    Nearest r{no_wall, 0};
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const SurfaceQuery& query = bodies_[b].query();
        const SurfaceQuery::Nearest found = query.nearest(x, reach);
        if (found.triangle < 0 || found.distance >= r.normal.distance) continue;
        const Vec3 n = slip_normal(query, found, u);
        r = {{static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()),
              static_cast<float>(found.distance)},
             b};
    }
    return r;
}

std::size_t Walls::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    std::size_t sum = of(place_) + of(p_) + of(group_loads_) + lists_.bytes();
    for (const Part& part : parts_)
        sum += of(part.start) + of(part.groups) + of(part.near_water) + part.water.bytes();
    return sum;
}

}  // namespace tw
