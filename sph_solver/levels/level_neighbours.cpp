// Who is whose neighbour in a level: sorting, ghosts, groups, lists and wall normals; and the records that the sweeps
// read.
#include <algorithm>
#include <numeric>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/backend/stopwatch.h"
#include "sph_solver/levels/level.h"

namespace tw {

double Level::travel_ahead() const { return life_.travel + schedule_.looks_ahead() * dt_ * extremes_.speed; }

bool Level::lists_outlived() const {
    const double relative = life_.travel_in_stream + schedule_.looks_ahead() * dt_ * life_.relative_speed;
    const double skin = ListLife::skin_over_dp * setup_.dp, wall_skin = ListLife::wall_skin_over_dp * setup_.dp;
    // two particles may both have moved towards each other
    return 2 * relative > skin || travel_ahead() + wall_travel_ahead() > wall_skin;
}

double Level::wall_travel_ahead() const { return life_.wall_travel + schedule_.looks_ahead() * dt_ * walls_.fastest(); }

void Level::refresh(double drift) {
    if (life_.over) {
        const Stopwatch watch(timers_.lists);
        ++timers_.rebuilds;
        if (device_)
            device_->make_lists(drift);
        else
            rebuild(drift);
        life_.travel = life_.travel_in_stream = life_.wall_travel = 0;
        life_.over = false;
        return;
    }
    walls_.follow(quanta_);
    if (device_) return device_->refresh(drift);
    {
        const Stopwatch watch(timers_.update);
        update_records();
    }
    prune(drift);
}

void Level::update_records() {
    Particles& p = particles_;
    for_particles(p.size(), UpdateRecords{state_view(), to_quanta(), p.place.data(), p.velocity_density.data()});
    ghosts_.refresh(p, time_, p.velocity_density);
}

/// Leaves in the lists who is within reach now, or may be after `drift` [s] with the present velocities.
void Level::prune(double drift) {
    const Stopwatch watch(timers_.lists);
    PruneData d;
    d.lists = lists_.view();
    d.of = particles_.place.data();
    d.place = particles_.place.data();
    d.reach = reach_among(drift) / quanta_.size;
    for_pairs(passes_, d, groups_);
    walls_.prune(passes_, particles_.place.data(), groups_, reach_to_walls(drift) / quanta_.size);
}

std::vector<Source> Level::sources() const {
    const std::size_t n = particles_.size();
    return {{&grid_, particles_.place.data(), &start_, 0},
            {&grid_, particles_.place.data() + n, &ghosts_.start(), static_cast<std::int32_t>(n)}};
}

Level::ReachesOfLists Level::reaches_of_lists(double drift) const {
    const double support = kernel_.support();
    const auto reaches = [&](double now, double slack) {
        return Reaches{std::max(support + slack, now), now, support - slack};
    };
    return {reaches(reach_among(drift), ListLife::skin_over_dp * setup_.dp),
            reaches(reach_to_walls(drift), ListLife::wall_skin_over_dp * setup_.dp)};
}

/// Makes the lists anew, live as `prune` leaves them.
void Level::rebuild(double drift) {
    const LevelSetup& s = setup_;
    Particles& p = particles_;

    const bool shared = ranks().many();
    if (shared) {
        divide_columns();
        let_go({});
    }
    const Ledger before = ledger_;
    const auto [gone, entered] = cross_open_boundaries(around_, s.dp, p, ledger_);
    std::vector<std::int32_t> index;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (!gone[i]) index.push_back(static_cast<std::int32_t>(i));
    ledger_.out += static_cast<std::int64_t>(p.size() - index.size());

    const auto [among, to_walls] = reaches_of_lists(drift);
    const double reach = std::max(among.far, to_walls.far);
    if (shared) {
        agree_on_crossings(before, entered);
        hold_columns(index, std::max(reach, reach_of_others()));
        index.resize(p.size());
        std::iota(index.begin(), index.end(), 0);
    }

    std::vector<WidePlace> kept(index.size());
    for_particles(kept.size(), [&](std::size_t k) {
        const auto i = static_cast<std::size_t>(index[k]);
        kept[k] = quanta_.wide({p.x[i], p.y[i], p.z[i]});
    });
    std::vector<std::int32_t> order;
    sort_by_column(grid_, kept, order, start_);
    order_coincident(
        kept, start_,
        [&](std::int32_t k) { return p.id[static_cast<std::size_t>(index[static_cast<std::size_t>(k)])]; }, order);
    for (auto& k : order) k = index[static_cast<std::size_t>(k)];
    p.reorder(order);
    if (!walls_.empty()) walls_.sort(grid_, quanta_, passes_.lanes);
    if (shared) note_own();

    ghosts_.find(p, grid_, reach);
    p.make_room(ghosts_.count());
    update_records();

    const std::vector<Source> own = sources();
    make_groups(own.front(), passes_.lanes, groups_, own_columns());
    if (shared) {
        group_columns_.clear();
        for (const Group& g : groups_) group_columns_.push_back(column_of(static_cast<std::size_t>(g.first)));
    }
    lists_.build(passes_, quanta_, own.front(), groups_, own, among);
    if (!walls_.empty()) {
        walls_.find_neighbours(passes_, grid_, quanta_, groups_, own, to_walls, own_columns());
        find_normals();
    }
}

void Level::note_wall(std::size_t i, const Walls::Nearest& near) {
    particles_.wall_normal[i] = near.normal;
    particles_.wall_leaving[i] = near.leaving;
    if (walls_.move()) particles_.wall_body[i] = static_cast<std::uint16_t>(near.body);
    if (walls_.give_way()) particles_.wall_triangle[i] = near.triangle;
}

void Level::find_normals() {
    const double reach = reach_of_normals();
    const Particles& p = particles_;
    for_groups(groups_, [&](const Group& g) {
        for (int l = 0; l < g.size; ++l) {
            const auto i = static_cast<std::size_t>(g.first + l);
            Walls::Nearest near{no_wall};
            if (g.wall_list.size > 0)
                near = walls_.nearest(Vec3(p.x[i], p.y[i], p.z[i]), Vec3(p.u[i], p.v[i], p.w[i]), reach);
            note_wall(i, near);
        }
    });
    halo_.tell(particles_.wall_normal.data(), particles_.wall_leaving.data());
    if (walls_.move()) halo_.tell(particles_.wall_body.data());
    if (walls_.give_way()) halo_.tell(particles_.wall_triangle.data());
    std::optional<std::size_t> through;
    for (std::size_t i = p.size(); i-- > 0 && !through;)
        if (double(p.wall_normal[i].distance) < -setup_.dp && is_active(p.kind[i])) through = i;
    if (ranks().sum(std::int64_t{through.has_value()})) fail_through_wall(through);
}

void Level::fail_through_wall(std::optional<std::size_t> through) {
    ++ledger_.lost;
    fail_together({through, through ? -column_of(*through) : 0,
                   "has gone through the hull; often a wall thinner than the kernel's support 2 h, or a spacing too "
                   "coarse for a sharp edge"});
}

}  // namespace tw
