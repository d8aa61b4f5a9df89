// Who is whose neighbour in a level on a device: what crosses the domain's faces, sorting, images, clusters, lists, and
// walls.
#include <functional>
#include <numeric>

#include "sph_solver/cuda/faces.h"
#include "sph_solver/levels/arrays_on_device.h"
#include "sph_solver/loops/inlet_wave.h"

namespace tw {

void LevelOnDevice::make_lists(double drift) {
    Arrays& on = *on_;
    const auto [among, to_walls] = level_.reaches_of_lists(drift);
    const double reach = std::max(among.far, to_walls.far);
    if (shared()) {
        cross_and_hold(reach);
        sort_particles(nullptr);
    } else {
        if (host_counts_) upload_state();
        cross_faces();
        sort_particles(on.left.data());
    }
    if (!level_.walls.empty()) level_.walls.sort(level_.grid, level_.fixed_point, cuda::lanes_of_cluster);
    if (shared()) note_own();
    find_images(reach);
    Particles& p = level_.particles;
    const std::size_t n = on.p.size();
    p.resize(n);
    p.make_room(on.links.size());
    FieldsView::each(on.p, p, [](auto& field, const auto& on_host, auto about) {
        if constexpr (!decltype(about)::moves) field.resize(on_host.size());
    });
    on.surface.resize(p.surface.size());
    on.extremes.resize((n + cuda::threads_in_block - 1) / cuda::threads_in_block);
    on.too_near.resize(n);
    pack_state();
    on.clusters.make(level_.grid, on.order, on.p.place.data(), or_null(on.own_pencils));
    const std::vector<cuda::DeviceSource> water = sources();
    on.lists.build(level_.grid, level_.grid, on.p.place.data(), on.clusters.pencil(), on.clusters.clusters(), water,
                   among / level_.fixed_point.size);
    if (!level_.walls.empty()) {
        if (level_.walls.move() || shared()) upload_sorted_dummies();
        if (shared()) on.wall_p.set_zero();  // what no rank works out that holds them
        for (Arrays::Part& part : on.parts)
            part.lists.build(level_.grid, level_.grid, on.wall_place.data() + part.first, part.pencil, part.clusters,
                             water, to_walls / level_.fixed_point.size);
        list_walls(to_walls);
    }
    if (shared()) note_work();
    on_host_ = order_on_host_ = false;
}

/// As RankShare::cross_and_hold. The host sees particles that are sent to other ranks, or may have come from them:
/// those of pencils that several ranks hold. All others stay where they are.
void LevelOnDevice::cross_and_hold(double reach) {
    Arrays& on = *on_;
    if (host_counts_ || share_.is_on_first()) {
        copy_all_to_host();
        share_.cross_and_hold(reach);
        upload_state();
    } else {
        share_.divide_pencils();
        cuda::launch(*device_, cuda::MarkStaying{nullptr, on.own.data(), on.following.of(on.p.size())}, on.p.size());
        keep(list_marked());
        const Ledger before = level_.ledger;
        cross_faces();
        const std::vector<std::int32_t> entered = list_entered();
        const std::size_t all = on.p.size();
        share_.find_holders(reach);
        on.inner_pencils.upload(share_.inner_pencils());
        const auto list_in = [&](bool inner) {
            cuda::launch(*device_,
                         cuda::MarkInPencils{level_.grid, on.wide.data(), on.left.data(), on.inner_pencils.data(),
                                             inner, on.following.of(all)},
                         all);
            return list_marked();
        };
        const std::size_t at_border = list_in(false);
        on.at_border.swap(on.which);
        const std::size_t inner = list_in(true);
        level_.ledger.out += static_cast<std::int64_t>(all - at_border - inner);
        const std::vector<std::int64_t> ids = share_.agree_on_crossings(before, entered);
        on.p.id.upload_at(ids, all - ids.size());

        Particles& p = level_.particles;
        const auto sort_out = [&](const cuda::Array<int>& which, std::size_t n) {
            on.p.each_moving_with(on.sorted,
                                  [&](const auto& field, auto& sorted) { sorted.resize(field.size() > 0 ? n : 0); });
            cuda::launch(*device_, cuda::Reorder{which.data(), on.p.all(), on.sorted.all()}, n);
        };
        sort_out(on.at_border, at_border);
        p.resize(at_border);
        on.sorted.each_moving_with(p, [](const auto& sorted, auto& on_host) { sorted.download(on_host); });
        sort_out(on.which, inner);
        on.p.each_moving_with(on.sorted, [](auto& field, auto& sorted) { field.swap(sorted); });
        std::vector<std::int32_t> staying(at_border);
        std::iota(staying.begin(), staying.end(), 0);
        share_.hold_pencils(staying);
        on.p.each_moving_with(p, [&](auto& field, const auto& on_host) {
            if (on_host.empty()) return;
            field.grow(inner + on_host.size());
            field.upload_at(on_host, inner);
        });
    }
    on.wide.resize(on.p.size());
    cuda::launch(*device_, cuda::TakeWide{on.p.view(), level_.to_fixed_point(), on.wide.data()}, on.p.size());
}

/// Particles in place of which the inlet has let others in; the new ones stand behind all, in this order.
std::vector<std::int32_t> LevelOnDevice::list_entered() {
    if (!level_.around.stream) return {};
    Arrays& on = *on_;
    const std::size_t n = on.entered.size();
    std::vector<std::int32_t> entered(on.p.size() - n);
    on.which.resize(entered.size());
    cuda::launch(*device_, cuda::ListMarked{on.entered.numbers(), on.entered.before(), on.which.data()}, n);
    on.which.download(entered);
    return entered;
}

/// The particles are sorted.
void LevelOnDevice::note_own() {
    Arrays& on = *on_;
    on.order.download_start(level_.near.start);
    level_.particles.resize(on.p.size());
    share_.note_own();
    upload_own();
    const std::function<bool(int)> own = share_.own_pencils();
    std::vector<char> pencils(static_cast<std::size_t>(level_.grid.count()));
    for (std::size_t c = 0; c < pencils.size(); ++c) pencils[c] = own(static_cast<int>(c));
    on.own_pencils.upload(pencils);
    loops_.set_halos(share_.halo(), level_.walls.halo());
}

/// Which particles are its own, and where they stand.
void LevelOnDevice::upload_own() {
    on_->own.upload({share_.own(), level_.particles.size()});
    on_->start.upload(level_.near.start);
}

void LevelOnDevice::note_work() {
    Arrays& on = *on_;
    const std::size_t n = on.clusters.size();
    cuda::launch(
        *device_,
        cuda::WorkOfClusters{on.clusters.clusters().data(), on.lists.blocks(), on.wall_lists.blocks(), on.work.of(n)},
        n);
    std::vector<int> work(n);
    on.work.download(work);
    share_.note_work(work);
}

/// Where neighbours among the level's particles and images are looked for.
std::vector<cuda::DeviceSource> LevelOnDevice::sources() const {
    const Arrays& on = *on_;
    const std::size_t n = on.p.size();
    return {on.order.source(on.p.place.data(), 0),
            on.image_order.source(on.p.place.data() + n, static_cast<std::int32_t>(n))};
}

StepMaker::Near LevelOnDevice::find_neighbours(StepMaker& other, const Reaches& reaches, RoomForLists&) {
    Arrays& on = *on_;
    const auto& of = static_cast<LevelOnDevice&>(other);
    on.asking_others.copy(on.clusters.clusters());
    on.lists_of_others.build(of.level_.grid, level_.grid, on.p.place.data(), on.clusters.pencil(), on.asking_others,
                             of.sources(), reaches / level_.fixed_point.size);
    const std::size_t n = on.asking_others.size();
    on.near_others.resize(n);
    on.count.set_zero();
    Cluster* const near = on.near_others.data();
    cuda::launch_threads(*device_, n, cuda::HasNeighbours{}, static_cast<const Cluster*>(on.asking_others.data()), near,
                         on.count.data(), n);
    return {on.lists_of_others.view(), {near, static_cast<std::size_t>(on.count.value(0))}};
}

void LevelOnDevice::cross_faces() {
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    const Box& domain = level_.around.domain;
    const Faces faces = faces_of(level_.around.mirrors, domain);
    Ledger& ledger = level_.ledger;
    std::size_t all = n;
    if (const auto& stream = level_.around.stream) {
        const CrossOpenings cross{domain.min.x(), domain.max.x(), stream->buffer, level_.setup.dp};
        on.gone.resize(n);
        int* const entered = on.entered.of(n);
        cuda::launch(*device_, cuda::Cross{cross, on.p.x.data(), on.p.kind.data(), entered, on.gone.data()}, n);
        const int count = on.entered.add_up();
        all += static_cast<std::size_t>(count);
        on.p.each_moving_with(on.p, [&](auto& field, auto&) {
            if (field.size() > 0) field.grow(all);
        });
        on.gone.grow(all);
        cuda::launch(*device_,
                     cuda::Enter{on.p.all(), on.entered.numbers(), on.entered.before(), on.gone.data(), n,
                                 stream->buffer, ledger.next_id},
                     n);
        if (level_.inlet_has_wave() && count > 0)
            level_.with_wave_of_inlet([&]<class Wave>(const WaveOfInlet<Wave>& of) {
                cuda::launch(*device_,
                             EnterUnderWave<Wave>{on.p.view(), on.p.all().calm_height, of, n,
                                                  stream->wave_at(level_.time), stream->buffer},
                             static_cast<std::size_t>(count));
            });
        ledger.in += count, ledger.next_id += count;
    }
    on.wide.resize(all), on.left.resize(all);
    cuda::launch(*device_,
                 cuda::PutBack{.mirrors = {on.p.view(), faces},
                               .top = domain.max.z(),
                               .open_top = !faces.mirror[2][1] && !faces.periodic[2],
                               .to_fixed_point = level_.to_fixed_point(),
                               .gone = level_.around.stream ? on.gone.data() : nullptr,
                               .wide = on.wide.data(),
                               .left = on.left.data()},
                 all);
}

void LevelOnDevice::sort_particles(const std::uint8_t* left) {
    Arrays& on = *on_;
    const std::size_t all = on.p.size(), n = on.order.sort(on.wide.data(), left, on.p.id.data(), all);
    level_.ledger.out += static_cast<std::int64_t>(all - n);
    on.p.each_moving_with(on.sorted, [&](const auto& field, auto& sorted) { sorted.resize(field.size() > 0 ? n : 0); });
    cuda::launch(*device_, cuda::Reorder{on.order.order(), on.p.all(), on.sorted.all()}, n);
    on.p.each_moving_with(on.sorted, [](auto& field, auto& sorted) { field.swap(sorted); });
}

void LevelOnDevice::find_images(double reach) {
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    const ImagesNear near{faces_of(level_.around.mirrors, level_.around.domain), reach};
    cuda::launch(*device_, cuda::CountImages{on.p.view(), near, on.images.of(n)}, n);
    const auto count = static_cast<std::size_t>(on.images.add_up());
    on.found.resize(count), on.links.resize(count), on.wide.resize(count);
    cuda::launch(*device_,
                 cuda::FindImages{.p = on.p.view(),
                                  .near = near,
                                  .maps = on.maps.data(),
                                  .to_fixed_point = level_.to_fixed_point(),
                                  .first = on.images.before(),
                                  .links = on.found.data(),
                                  .wide = on.wide.data()},
                 n);
    on.image_order.sort(on.wide.data(), nullptr, nullptr, count);
    cuda::launch(*device_, cuda::ReorderLinks{on.image_order.order(), on.found.data(), on.links.data()}, count);
}

void LevelOnDevice::list_walls(const Reaches& reaches) {
    Arrays& on = *on_;
    Walls& walls = level_.walls;
    std::vector<cuda::DeviceSource> dummies;
    for (const Arrays::Part& part : on.parts)
        dummies.push_back(
            {on.wall_place.data() + part.first, part.start.data(), 1, static_cast<std::int32_t>(part.first)});
    on.wall_lists.build(level_.grid, level_.grid, on.p.place.data(), on.clusters.pencil(), on.clusters.clusters(),
                        dummies, reaches / level_.fixed_point.size, &Cluster::wall_list);
    const std::size_t clusters = on.clusters.size();
    cuda::launch(
        *device_,
        cuda::CountWallLoads{on.clusters.clusters().data(), on.wall_lists.blocks(), on.body_end.data(),
                             static_cast<int>(on.body_end.size()), on.loads.of(clusters), on.at_wall.of(clusters)},
        clusters);
    const auto loads = static_cast<std::size_t>(on.loads.add_up()),
               at_walls = static_cast<std::size_t>(on.at_wall.add_up());
    on.wall_load.resize(loads);
    walls.cluster_loads().resize(loads);
    on.clusters_at_walls.resize(at_walls);
    cuda::ListClustersAtWalls list{.pencils = level_.grid,
                                   .pencil = on.clusters.pencil().data(),
                                   .first_load = on.loads.before(),
                                   .at_wall = on.at_wall.numbers(),
                                   .before = on.at_wall.before(),
                                   .origin = {},
                                   .unit = level_.fixed_point.size,
                                   .clusters = on.clusters.clusters().data(),
                                   .list = on.clusters_at_walls.data()};
    for (int a = 0; a < 3; ++a) list.origin[a] = level_.fixed_point.origin[a];
    cuda::launch(*device_, list, clusters);
    std::vector<cuda::ClusterAtWall> on_host(at_walls);
    on.clusters_at_walls.download(on_host);
    level_.near.clusters.clear(), centres_.clear();
    for (const cuda::ClusterAtWall& g : on_host)
        level_.near.clusters.push_back(g.cluster), centres_.emplace_back(g.x, g.y, g.z);
    find_walls();
}

/// The host finds the wall nearest to each particle of the clusters at walls.
void LevelOnDevice::find_walls() {
    Arrays& on = *on_;
    const std::size_t asked = on.clusters_at_walls.size() * cuda::lanes_of_cluster;
    cuda::launch(*device_, cuda::NoWalls{on.p.all()}, on.p.size());
    on.near_walls.resize(asked), on.walls_found.resize(asked);
    cuda::launch(*device_,
                 cuda::TakeNearWalls{on.p.view(), on.p.kind.data(), on.clusters_at_walls.data(), on.near_walls.data()},
                 asked);
    std::vector<cuda::NearWall> near(asked);
    on.near_walls.download(near);
    std::vector<cuda::WallFound> found(asked);
    const double reach = level_.reach_of_normals();
    for_particles(asked, [&](std::size_t k) {
        const cuda::NearWall& q = near[k];
        found[k].index = q.index;
        if (q.index >= 0) found[k].wall = level_.walls.nearest(Vec3(q.x, q.y, q.z), Vec3(q.u, q.v, q.w), reach);
    });
    on.walls_found.upload(found);
    cuda::launch(*device_, cuda::PutWalls{on.walls_found.data(), on.p.all()}, asked);
    if (shared())
        FieldsView::each(on.p, level_.particles, [&](const auto& field, const auto&, auto about) {
            if constexpr (decltype(about)::of_walls)
                if (level_.particles.has(decltype(about)::had_with)) loops_.halo().exchange({of_each(field.data())});
        });
    std::optional<std::size_t> through;
    for (std::size_t k = 0; k < asked; ++k)
        if (found[k].index >= 0 && double(found[k].wall.normal.distance) < -level_.setup.dp && is_active(near[k].kind))
            through = static_cast<std::size_t>(found[k].index);
    if (share_.ranks().sum(std::int64_t{through.has_value()}) == 0) return;
    on_host_ = order_on_host_ = false;
    copy_all_to_host();
    share_.fail_through_wall(through);
}

}  // namespace tw
