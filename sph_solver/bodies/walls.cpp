#include "sph_solver/bodies/walls.h"

#include <algorithm>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/bodies/slip_normal.h"

namespace tw {

Walls::Walls(const std::vector<Body>& bodies, const Surroundings& around, const LevelSetup& level,
             double kernel_support, const ColumnGrid& grid, const Quanta& quanta)
    : loads(bodies.size()), bodies_(bodies) {
    Box region = around.domain;
    region.min.array() -= kernel_support;
    region.max.array() += kernel_support;
    bool any_slides = false;
    for (const Body& body : bodies) {
        any_slides = any_slides || !body.sliding().isZero(0);
        const Dummies d = make_dummies(body.query(), body.surface().bounds(), level.dp, kernel_support + level.dp,
                                       region, around.dimensions);
        std::vector<PlaceRecord> raw(d.places.size());
        for (std::size_t k = 0; k < raw.size(); ++k)
            raw[k] = {quanta.of(d.places[k].x(), 0), quanta.of(d.places[k].y(), 1), quanta.of(d.places[k].z(), 2),
                      static_cast<float>(d.volumes[k])};
        std::vector<std::int32_t> order;
        sort_by_column(grid, raw, 0, raw.size(), order, starts_.emplace_back());
        const std::size_t first = place_.size();
        for (const std::int32_t k : order) place_.push_back(raw[static_cast<std::size_t>(k)]);
        body_end_.push_back(static_cast<std::int32_t>(place_.size()));
        std::vector<Group> groups;
        make_groups(place_, starts_.back(), first, groups);
        groups_.insert(groups_.end(), groups.begin(), groups.end());
    }
    p_.assign(place_.size(), 0);
    take_motions(quanta);
    if (!any_slides) return;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Eigen::Vector3f u = bodies[b].sliding().cast<float>();
        sliding_.resize(static_cast<std::size_t>(body_end_[b]), {u.x(), u.y(), u.z(), 0});
    }
}

/// What the dummies hand to the water of their body's motion.
void Walls::take_motions(const Quanta& quanta) {
    velocity_.clear(), acceleration_.clear();
    if (std::ranges::all_of(bodies_, [](const Body& body) { return body.motion().fixed(); })) return;
    std::size_t k = 0;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (; k < static_cast<std::size_t>(body_end_[b]); ++k) {
            const Vec3 x = quanta.origin + quanta.size * Vec3(place_[k].x, place_[k].y, place_[k].z);
            const Eigen::Vector3f u = bodies_[b].motion().velocity_at(x).cast<float>(),
                                  a = bodies_[b].motion().acceleration_at(x).cast<float>();
            velocity_.push_back({u.x(), u.y(), u.z()});
            acceleration_.push_back({a.x(), a.y(), a.z()});
        }
}

void Walls::find_neighbours(const ColumnGrid& grid, const Quanta& quanta, const PlaceRecord* particles,
                            std::vector<Group>& groups, const std::vector<Source>& sources, const Reaches& reaches) {
    std::vector<Source> dummies;
    for (std::size_t b = 0; b < starts_.size(); ++b) {
        const std::int32_t first = b == 0 ? 0 : body_end_[b - 1];
        dummies.push_back({place_.data() + first, &starts_[b], first});
    }
    lists_.build(grid, quanta, particles, groups, dummies, reaches, &Group::wall_list);
    live_groups_ = groups_;
    source_lists_.build(grid, quanta, place_.data(), live_groups_, sources, reaches);
    std::fill(p_.begin(), p_.end(), 0.0f);
    std::erase_if(live_groups_, [](const Group& g) { return g.list.size == 0; });
    group_loads_.resize(static_cast<std::size_t>(number_wall_loads(groups, lists_.view(), body_end_)));
}

void Walls::prune(const Passes& passes, const PlaceRecord* particles, const std::vector<Group>& groups, double reach) {
    if (live_groups_.empty()) return;
    PruneData d;
    d.reach = reach;
    d.lists = source_lists_.view();
    d.of = place_.data();
    d.place = particles;
    for_pairs(passes.prune, d, live_groups_);
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
    return of(place_) + of(p_) + of(groups_) + of(live_groups_) + of(group_loads_) + lists_.bytes() +
           source_lists_.bytes();
}

}  // namespace tw
