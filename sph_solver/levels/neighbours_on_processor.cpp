// Who is whose neighbour in a level on a processor: sorting, images, clusters, lists and wall normals; and the packed
// arrays that the pair loops read.
#include <algorithm>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/levels/on_processor.h"

namespace tw {

void LevelOnProcessor::pack_state() {
    Particles& p = level_.particles;
    for_particles(p.size(),
                  PackState{level_.state_view(), level_.to_fixed_point(), p.place.data(), p.velocity_density.data()});
    level_.ghosts.refresh(p, level_.time, p.velocity_density);
}

void LevelOnProcessor::prune(double drift) {
    PruneData d;
    d.lists = level_.near.lists.view();
    d.of = level_.particles.place.data();
    d.place = level_.particles.place.data();
    d.reach = level_.reach_among(drift) / level_.fixed_point.size;
    for_pairs(level_.passes, d, level_.near.clusters);
    level_.walls.prune(level_.passes, level_.particles.place.data(), level_.near.clusters,
                       level_.reach_to_walls(drift) / level_.fixed_point.size);
}

std::vector<Source> LevelOnProcessor::sources() const {
    const std::size_t n = level_.particles.size();
    return {{&level_.grid, level_.particles.place.data(), &level_.near.start, 0},
            {&level_.grid, level_.particles.place.data() + n, &level_.ghosts.start(), static_cast<std::int32_t>(n)}};
}

void LevelOnProcessor::make_lists(double drift) {
    Particles& p = level_.particles;
    const bool shared = share_.ranks().many();
    const auto [among, to_walls] = level_.reaches_of_lists(drift);
    const double reach = std::max(among.far, to_walls.far);
    const std::vector<std::int32_t> index = share_.cross_and_hold(reach);

    std::vector<WidePlace> kept(index.size());
    for_particles(kept.size(), [&](std::size_t k) {
        const auto i = static_cast<std::size_t>(index[k]);
        kept[k] = level_.fixed_point.wide({p.x[i], p.y[i], p.z[i]});
    });
    std::vector<std::int32_t> order;
    sort_by_pencil(level_.grid, kept, order, level_.near.start);
    order_coincident(
        kept, level_.near.start,
        [&](std::int32_t k) { return p.id[static_cast<std::size_t>(index[static_cast<std::size_t>(k)])]; }, order);
    for (auto& k : order) k = index[static_cast<std::size_t>(k)];
    p.reorder(order);
    if (!level_.walls.empty()) level_.walls.sort(level_.grid, level_.fixed_point, level_.passes.lanes);
    if (shared) share_.note_own();

    level_.ghosts.find(p, level_.grid, reach);
    p.make_room(level_.ghosts.count());
    pack_state();

    const std::vector<Source> own = sources();
    make_clusters(own.front(), level_.passes.lanes, level_.near.clusters, share_.own_pencils());
    level_.near.lists.build(level_.passes, level_.fixed_point, own.front(), level_.near.clusters, own, among);
    if (!level_.walls.empty()) {
        level_.walls.find_neighbours(level_.passes, level_.grid, level_.fixed_point, level_.near.clusters, own,
                                     to_walls, share_.own_pencils());
        find_walls();
    }
    if (!shared) return;
    std::vector<int> work;
    for (const Cluster& g : level_.near.clusters) work.push_back(static_cast<int>(g.size * (1 + level_.live_pairs(g))));
    share_.note_work(work);
}

void LevelOnProcessor::find_walls() {
    const double reach = level_.reach_of_normals();
    Particles& p = level_.particles;
    const FieldsView all = p.view();
    for_clusters(level_.near.clusters, [&](const Cluster& g) {
        for (int l = 0; l < g.size; ++l) {
            const auto i = static_cast<std::size_t>(g.first + l);
            NearestWall near;
            if (g.wall_list.size > 0)
                near = level_.walls.nearest(Vec3(p.x[i], p.y[i], p.z[i]), Vec3(p.u[i], p.v[i], p.w[i]), reach);
            near.note(all, i);
        }
    });
    FieldsView::each(all, all, [&](auto* field, const auto*, auto about) {
        if constexpr (decltype(about)::of_walls)
            if (p.has(decltype(about)::had_with)) share_.halo().exchange(field);
    });
    std::optional<std::size_t> through;
    for (std::size_t i = p.size(); i-- > 0 && !through;)
        if (double(p.wall_normal[i].distance) < -level_.setup.dp && is_active(p.kind[i])) through = i;
    if (share_.ranks().sum(std::int64_t{through.has_value()})) share_.fail_through_wall(through);
}

std::int64_t LevelOnProcessor::live_pairs() const {
    std::int64_t pairs = 0;
    for (const Cluster& g : level_.near.clusters) pairs += level_.live_pairs(g) * g.size;
    return pairs;
}

StepMaker::Near LevelOnProcessor::find_neighbours(StepMaker& other, const Reaches& reaches, RoomForLists& room) {
    room.clusters = level_.near.clusters;
    room.lists.build(level_.passes, level_.fixed_point, sources().front(), room.clusters,
                     static_cast<LevelOnProcessor&>(other).sources(), reaches);
    std::erase_if(room.clusters, [](const Cluster& g) { return g.list.size == 0; });
    return {room.lists.view(), room.clusters};
}

}  // namespace tw
