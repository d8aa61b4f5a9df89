#include "sph_solver/levels/on_device.h"

#include <algorithm>

#include "sph_solver/levels/arrays_on_device.h"

namespace tw {

LevelOnDevice::LevelOnDevice(ParticleSystem& level, RankShare& share, std::shared_ptr<cuda::Device> device)
    : level_(level),
      share_(share),
      device_(std::move(device)),
      loops_(device_),
      on_(std::make_unique<Arrays>(*device_, bins_of(level.grid, level.setup.dp, level.fixed_point.size))) {
    cuda::Device& d = *device_;
    Walls& walls = level_.walls;
    on_->maps.upload(level_.ghosts.maps());
    on_->count.resize(1);
    on_->body_end.upload(walls.body_end());
    on_->wall_p.resize(walls.size());
    if (walls.empty()) return;
    for (const Walls::Part& part : walls.parts()) {
        on_->parts.push_back(
            {part.first, cuda::Array<int>(d), cuda::Array<int>(d), cuda::Array<Cluster>(d), ListsOnDevice(d)});
        on_->surfaces.push_back({0, cuda::Array<Corners>(d), cuda::Array<V3<double>>(d), cuda::Array<V3<double>>(d)});
    }
    upload_sorted_dummies();
}

/// In their order and clusters.
void LevelOnDevice::upload_sorted_dummies() {
    const Walls& walls = level_.walls;
    for (std::size_t b = 0; b < on_->parts.size(); ++b) {
        const Walls::Part& part = walls.parts()[b];
        Arrays::Part& on = on_->parts[b];
        std::vector<Cluster> own;
        if (shared())
            make_clusters({&level_.grid, walls.places().data() + part.first, &part.start, 0}, cuda::lanes_of_cluster,
                          own, share_.own_pencils());
        const std::vector<Cluster>& clusters = shared() ? own : part.clusters;
        on.start.upload(part.start), on.clusters.upload(clusters);
        on.pencil.upload(pencils_of(clusters, part.start));
    }
    on_->wall_place.upload(walls.places());
    upload_dummies();
}

/// Where they are now, and how they move.
void LevelOnDevice::upload_dummies() {
    const Walls& walls = level_.walls;
    if (walls.move()) {
        on_->wall_place.upload(walls.places());
        on_->wall_velocity.upload(std::span(walls.velocities(), walls.size()));
    }
    if (walls.accelerations()) on_->wall_acceleration.upload(std::span(walls.accelerations(), walls.size()));
}

NearWalls LevelOnDevice::near_walls() {
    on_->motions.upload(level_.walls.motions());
    return {.normal = or_null(on_->p.wall_normal),
            .motions = or_null(on_->motions),
            .body = or_null(on_->p.wall_body),
            .triangle = or_null(on_->p.wall_triangle),
            .surfaces = upload_surfaces()};
}

/// How the surfaces of bodies that deform move now; null: there are none.
const SurfaceMotion* LevelOnDevice::upload_surfaces() {
    Walls& walls = level_.walls;
    if (!walls.any_deformable() || walls.empty()) return nullptr;
    std::vector<SurfaceMotion> motions;
    for (std::size_t b = 0; b < on_->surfaces.size(); ++b) {
        const Attached::WettedSurface surface = walls.attached(b)->wetted_surface();
        Arrays::WettedSurface& on = on_->surfaces[b];
        if (surface.times_noted != on.times_noted) on.corners.upload(surface.corners), on.noted.upload(surface.noted);
        on.times_noted = surface.times_noted;
        on.velocity.upload(surface.velocity);
        motions.push_back({or_null(on.corners), or_null(on.noted), or_null(on.velocity)});
    }
    on_->surface_motions.upload(motions);
    return on_->surface_motions.data();
}

LevelOnDevice::~LevelOnDevice() = default;

// --- from and to the host
// ---------------------------------------------------------------------------------------------

void LevelOnDevice::upload_state() {
    on_->p.each_moving_with(level_.particles, [](auto& on, const auto& field) { on.upload(field); });
    if (shared()) upload_own();
    host_counts_ = false;
}

void LevelOnDevice::copy_all_to_host() {
    if (on_host_ || host_counts_) return;
    Particles& p = level_.particles;
    Arrays& on = *on_;
    FieldsView::each(on.p, p, [](const auto& field, auto& to, auto) { field.download(to); });
    on.surface.download(p.surface);
    on.wall_p.download(level_.walls.pressures());
    if (!order_on_host_) {
        if (!shared()) on.order.download_start(level_.near.start);  // else it is there
        std::vector<Link> links(on.links.size());
        on.links.download(links);
        std::vector<std::int32_t> start;
        on.image_order.download_start(start);
        level_.ghosts.take(std::move(links), std::move(start));
    }
    on_host_ = order_on_host_ = true;
}

void LevelOnDevice::copy_motion_to_host() {
    if (on_host_ || host_counts_) return;
    Particles& p = level_.particles;
    const Arrays::Fields& on = on_->p;
    on.x.download(p.x), on.y.download(p.y), on.z.download(p.z);
    on.u.download(p.u), on.v.download(p.v), on.w.download(p.w);
    on.kind.download(p.kind);
}

std::int64_t LevelOnDevice::live_pairs() const {
    // clusters are full but for the last of each pencil
    return cuda::lanes_of_cluster * (on_->lists.live() + on_->wall_lists.live());
}

KindCounts LevelOnDevice::count(CountKinds kinds) {
    if (host_counts_) upload_state();
    Arrays& on = *on_;
    on.kinds.resize(1);
    on.kinds.set_zero();
    kinds.kind = on.p.kind.data(), kinds.x = on.p.x.data(), kinds.counts = on.kinds.data();
    kinds.own = or_null(on.own);
    cuda::launch(*device_, kinds, on.p.size());
    return on.kinds.value(0);
}

double LevelOnDevice::bytes_on_device() const { return on_->bytes() + double(loops_.bytes()); }

// --- a step
// -------------------------------------------------------------------------------------------------------------

void LevelOnDevice::prune(double drift) {
    Arrays& on = *on_;
    upload_dummies();
    PruneData d;
    d.lists = on.lists.view();
    d.of = d.place = on.p.place.data();
    d.reach = level_.reach_among(drift) / level_.fixed_point.size;
    cuda::launch_pairs(*device_, d, on.clusters.clusters());
    on_host_ = false;
    if (level_.walls.empty()) return;
    d.reach = level_.reach_to_walls(drift) / level_.fixed_point.size;
    for (const Arrays::Part& part : on.parts) {
        d.lists = part.lists.view();
        d.of = on.wall_place.data() + part.first;
        cuda::launch_pairs(*device_, d, part.clusters);
    }
    d.of = on.p.place.data(), d.place = on.wall_place.data();
    d.lists = on.wall_lists.view();
    d.list = &Cluster::wall_list;
    cuda::launch_pairs(*device_, d, on.clusters.clusters());
}

void LevelOnDevice::pack_state() {
    Arrays& on = *on_;
    if (host_counts_) upload_state();
    cuda::launch(*device_,
                 PackState{on.p.view(), level_.to_fixed_point(), on.p.place.data(), on.p.velocity_density.data()},
                 on.p.size());
    refresh_images(level_.time, false);
}

void LevelOnDevice::refresh_images(double t, bool with_stress) {
    PackedGradientPressure* const stress = with_stress ? on_->p.gradient_pressure.data() : nullptr;
    const auto refresh = [&](const auto& force) {
        cuda::launch(*device_,
                     cuda::RefreshImages{on_->links.data(), on_->maps.data(), on_->p.size(), level_.fixed_point.size,
                                         level_.ghosts.still(), force, on_->p.place.data(),
                                         on_->p.velocity_density.data(), stress},
                     on_->links.size());
    };
    const Vec3 g = level_.around.weight();
    if (level_.around.frame)
        refresh(ForceHalfway{on_->p.view(), ForceOfFrame::of(level_.around.force(t))});
    else
        refresh(SameForce{{g.x(), g.y(), g.z()}});
}

/// Of the device's arrays in place of the host's.
WaterView LevelOnDevice::water() const {
    WaterView w = level_.water_view();
    w.list = on_->lists.view();
    w.place = on_->p.place.data(), w.motion = on_->p.velocity_density.data(),
    w.stress = on_->p.gradient_pressure.data();
    w.surface = on_->surface.data();
    if (w.kind) w.kind = on_->p.kind.data();
    return w;
}
WallView LevelOnDevice::walls() const {
    WallView w = level_.wall_view();
    w.list = on_->wall_lists.view();
    w.place = or_null(on_->wall_place), w.p = on_->wall_p.data();
    w.velocity = or_null(on_->wall_velocity);
    w.body_end = on_->body_end.data();
    w.normal = or_null(on_->p.wall_normal);
    return w;
}

StepView LevelOnDevice::step_view(double t) {
    Arrays& on = *on_;
    if (on.sliding.size() == 0) on.sliding.upload(level_.walls.sliding());
    StepView view = level_.step_view(t, share_.halo());
    view.n = on.p.size(), view.images = on.links.size();
    view.p = on.p.view(), view.kind = on.p.kind.data();
    view.fields = on.p.all(), view.shift = on.p.shift_support.data();
    view.water = water(), view.dummies = walls();
    view.stress = on.p.gradient_pressure.data(), view.rate = on.p.rate.data();
    view.clusters = {on.clusters.clusters().data(), on.clusters.size()};
    view.bodies.clear();
    for (const Arrays::Part& part : on.parts)
        view.bodies.push_back({part.first, part.lists.view(), {part.clusters.data(), part.clusters.size()}});
    view.sliding = or_null(on.sliding);
    view.links = on.links.data(), view.maps = on.maps.data();
    view.device = &loops_;
    on_host_ = false;
    return view;
}

void LevelOnDevice::first_pair_loop(const OtherSums* other) {
    Arrays& on = *on_;
    if (host_counts_) upload_state();
    FirstPairLoopData d = level_.first_pair_loop_data();
    d.water = water(), d.walls = walls();
    d.stress = on.p.gradient_pressure.data(), d.shift = on.p.shift_support.data(), d.rate = on.p.rate.data();
    d.other = other;
    d.carried = nullptr;
    cuda::launch_pairs(*device_, d, on.clusters.clusters());
    on_host_ = false;
}

void LevelOnDevice::exchange_first_sums() {
    const Arrays::Fields& p = on_->p;
    loops_.halo().exchange(
        {of_each(p.gradient_pressure.data(), offsetof(PackedGradientPressure, gx), 3 * sizeof(float)),
         of_each(p.shift_support.data(), offsetof(PackedShiftSupport, support), sizeof(float)),
         of_each(p.rate.data(), offsetof(PackedRate, drho), sizeof(float))});
}

void LevelOnDevice::mark_surface() {
    Arrays& on = *on_;
    cuda::launch(*device_,
                 cuda::MarkSurface{level_.lacks_support(on.p.all()), on.links.data(), on.p.size(), on.p.place.size(),
                                   on.surface.data()},
                 on.surface.size());
}

void LevelOnDevice::compress(double compress, double drift) {
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    const AfterFirstPairLoop after = level_.after_first_pair_loop(on.p.all(), compress, drift);
    on.p.density_rate.set_zero();
    const StateEquation& state_equation = level_.setup.state_equation;
    const double c0 = state_equation.c0;
    if (state_equation.form == StateEquation::Form::linear)
        cuda::launch(*device_, cuda::Compress{after, near_walls(), cuda::LinearPressure{static_cast<float>(c0 * c0)}},
                     n);
    else
        cuda::launch(*device_,
                     cuda::Compress{after, near_walls(), cuda::PressureOfState{state_equation, level_.setup.rho0}}, n);
    on_host_ = false;
}

void LevelOnDevice::press_walls() {
    Arrays& on = *on_;
    upload_dummies();
    for (const Arrays::Part& part : on.parts) {
        ExtrapolateData e = level_.extrapolation();
        e.water = water();
        e.list = part.lists.view();
        e.at = on.wall_place.data() + part.first;
        e.p = on.wall_p.data() + part.first;
        if (on.wall_acceleration.size() > 0) e.acceleration = on.wall_acceleration.data() + part.first;
        cuda::launch_pairs(*device_, e, part.clusters);
    }
}

void LevelOnDevice::exchange_pressures() { loops_.dummies_halo().exchange({of_each(on_->wall_p.data())}); }

void LevelOnDevice::second_pair_loop(double t) {
    Arrays& on = *on_;
    SecondPairLoopData d = level_.second_pair_loop_data(t);
    d.water = water(), d.walls = walls();
    d.leaving = or_null(on.p.wall_leaving);
    d.shift = on.p.shift_support.data(), d.rate = on.p.rate.data(), d.wall_load = on.wall_load.data();
    cuda::launch_pairs(*device_, d, on.clusters.clusters());
    on_host_ = false;
}

void LevelOnDevice::exchange_rates() {
    loops_.halo().exchange({of_each(on_->p.rate.data()), of_each(on_->p.shift_support.data())});
}

void LevelOnDevice::copy_loads_to_host() { on_->wall_load.download(level_.walls.cluster_loads()); }

std::vector<Moved> LevelOnDevice::move(const Move& of_host, const Hold& hold) {
    Arrays& on = *on_;
    std::size_t n = on.p.size();
    cuda::MoveAll task{.move = of_host,
                       .wall = or_null(on.p.wall_normal),
                       .walls = near_walls(),
                       .held_from = Move::held_at_wall_over_dp * level_.setup.dp,
                       .too_near = on.too_near.data(),
                       .count = on.count.data()};
    task.move.p = on.p.view();
    task.move.kind = on.p.kind.data(), task.move.rate = on.p.rate.data(),
    task.move.shift_support = on.p.shift_support.data();
    task.move.trend = or_null(on.p.trend);
    on.count.set_zero();
    MovedExtremes* of_blocks = on.extremes.data();
    cuda::launch_threads(*device_, n, task, of_blocks, n);
    on_host_ = false;

    Moved moved;
    std::vector<MovedExtremes> parts(on.extremes.size());
    on.extremes.download(parts);
    for (const MovedExtremes& part : parts) cuda::join(moved, part);
    int held = 0;
    on.count.download(std::span(&held, 1));
    if (held == 0) return {moved};
    std::vector<std::int32_t> at_walls(static_cast<std::size_t>(held));
    on.too_near.download(at_walls);
    std::ranges::sort(at_walls);
    fetch(at_walls);
    for (const std::int32_t k : at_walls) {
        const auto i = static_cast<std::size_t>(k);
        hold(i, moved);
        of_host.note(i, moved);
    }
    put_back(at_walls);
    return {moved};
}

void LevelOnDevice::copy_to_host(const std::vector<std::size_t>& particles) {
    if (!on_host_) fetch(std::vector<std::int32_t>(particles.begin(), particles.end()));
}

std::vector<std::int32_t> LevelOnDevice::copy_pressed_to_host(MayBePressed condition) {
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    condition.wall = on.p.wall_normal.data(), condition.kind = on.p.kind.data();
    cuda::launch(*device_, cuda::MarkPressed{condition, on.following.of(n)}, n);
    std::vector<std::int32_t> which(list_marked());
    on.which.download(which);
    fetch(which);
    return which;
}

void LevelOnDevice::push(const std::vector<std::int32_t>& which, const std::vector<V3<float>>& accelerations) {
    Arrays& on = *on_;
    on.pushed.upload(which), on.pushes.upload(accelerations);
    cuda::launch(*device_, AddPushes{on.pushed.data(), on.pushes.data(), on.p.rate.data()}, which.size());
    on_host_ = false;
}

void LevelOnDevice::fetch(const std::vector<std::int32_t>& which) {
    Arrays& on = *on_;
    on.fetched.upload(which);
    on.held.resize(which.size());
    cuda::launch(*device_, cuda::TakeHeld{on.p.all(), on.fetched.data(), on.held.data()}, which.size());
    std::vector<cuda::HeldParticle> held(which.size());
    on.held.download(held);
    for (const cuda::HeldParticle& h : held)
        FieldsView::each(level_.particles, h, [&h](auto& field, const auto& value, auto about) {
            if constexpr (cuda::HeldParticle::has(decltype(about){})) {
                if (!field.empty()) field[static_cast<std::size_t>(h.index)] = value;
            }
        });
}

void LevelOnDevice::put_back(const std::vector<std::int32_t>& held_on_host) {
    std::vector<cuda::HeldParticle> held(held_on_host.size());
    for (std::size_t k = 0; k < held.size(); ++k) {
        const auto i = static_cast<std::size_t>(held_on_host[k]);
        held[k].index = held_on_host[k];
        FieldsView::each(level_.particles, held[k], [i](const auto& field, auto& value, auto about) {
            if constexpr (cuda::HeldParticle::has(decltype(about){})) {
                if (!field.empty()) value = field[i];
            }
        });
    }
    on_->held.upload(held);
    cuda::launch(*device_, cuda::PutHeld{on_->held.data(), on_->p.all()}, held.size());
}

}  // namespace tw
