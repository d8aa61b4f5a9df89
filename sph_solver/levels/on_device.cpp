#include "sph_solver/levels/on_device.h"

#include <algorithm>

#include "sph_solver/cuda/tasks.h"
#include "sph_solver/effects/ventilation.h"
#include "sph_solver/levels/level.h"
#include "sph_solver/levels/lists_on_device.h"

namespace tw {

namespace {

template <class T>
T* or_null(const cuda::Array<T>& array) {
    return array.size() > 0 ? array.data() : nullptr;
}

}  // namespace

struct LevelOnDevice::Arrays {
    cuda::Device& device;
    /// What stays with a particle.
    struct State {
        cuda::Array<double> x, y, z;
        cuda::Array<float> u, v, w, drho;
        cuda::Array<std::int64_t> id;
        cuda::Array<Kind> kind;
        cuda::Array<Aired> aired;        ///< empty: there is none
        cuda::Array<Trend> trend;        ///< empty: no coarser level
        cuda::Array<float> compression;  ///< empty: no finer level
        explicit State(cuda::Device& d)
            : x(d), y(d), z(d), u(d), v(d), w(d), drho(d), id(d), kind(d), aired(d), trend(d), compression(d) {}

        /// Calls `f(field, other)` for each and what `others` has of it.
        template <class Others, class Function>
        void each_with(Others& others, const Function& f) {
            f(x, others.x), f(y, others.y), f(z, others.z), f(u, others.u), f(v, others.v), f(w, others.w);
            f(drho, others.drho), f(id, others.id), f(kind, others.kind), f(aired, others.aired);
            f(trend, others.trend), f(compression, others.compression);
        }
        template <class Function>
        void each(const Function& f) {
            each_with(*this, [&](auto& field, auto&) { f(field); });
        }
        StateView view() const { return {x.data(), y.data(), z.data(), u.data(), v.data(), w.data(), drho.data()}; }
        std::size_t size() const { return x.size(); }
    };
    State p{device}, sorted{device};
    cuda::Array<PlaceRecord> place{device};
    cuda::Array<VelocityDensityRecord> motion{device};
    cuda::Array<GradientPressureRecord> stress{device};
    cuda::Array<ShiftSupportRecord> shift{device};
    cuda::Array<RateRecord> rate{device};
    cuda::Array<float> density_rate{device};  ///< empty: no coarser level
    cuda::Array<std::uint32_t> surface{device};
    cuda::Array<WallNormalRecord> wall_normal{device};
    cuda::Array<LeavingRecord> wall_leaving{device};
    cuda::Array<std::uint16_t> wall_body{device};  ///< empty: no body moves

    // who stands where
    cuda::Bins bins;
    RunningSum entered{device}, images{device}, groups_before{device};
    cuda::Array<int> gone{device}, column{device};  ///< of particles; of groups
    cuda::Array<std::uint8_t> left{device};
    cuda::Array<WidePlace> wide{device};
    SortedOnDevice order{device, bins}, image_order{device, bins};
    cuda::Array<Link> found{device}, links{device};
    cuda::Array<LinkMap> maps{device};
    cuda::Array<Group> groups{device};
    ListsOnDevice lists{device}, wall_lists{device};

    cuda::Array<PlaceRecord> wall_place{device};
    cuda::Array<float> wall_p{device};
    cuda::Array<WallVelocity> wall_velocity{device};
    cuda::Array<WallAcceleration> wall_acceleration{device};
    cuda::Array<WallMotion> motions{device};
    cuda::Array<std::int32_t> body_end{device};
    cuda::Array<WallLoad> wall_load{device};
    RunningSum loads{device}, at_wall{device};
    cuda::Array<cuda::GroupAtWall> groups_at_walls{device};
    cuda::Array<cuda::NearWall> near_walls{device};
    cuda::Array<cuda::WallFound> walls_found{device};
    /// The dummies of one body.
    struct Part {
        std::size_t first;
        cuda::Array<int> start, column;
        cuda::Array<Group> groups;
        ListsOnDevice lists;
    };
    std::vector<Part> parts;

    cuda::Array<std::uint32_t> air_stays{device};
    cuda::Array<std::uint8_t> air_near{device};
    cuda::Array<Group> asking{device};
    cuda::Array<int> count{device};
    cuda::Array<MovedExtremes> extremes{device};
    cuda::Array<std::int32_t> too_near{device}, fetched{device};
    cuda::Array<cuda::HeldParticle> held{device};

    Arrays(cuda::Device& d, const cuda::Bins& of_columns) : device(d), bins(of_columns) {}

    double bytes() {
        double sum = 0;
        const auto add = [&](const auto&... array) { ((sum += double(array.bytes())), ...); };
        p.each(add), sorted.each(add);
        add(place, motion, stress, shift, rate, density_rate, surface, wall_normal, wall_leaving, wall_body, wall_velocity,
            wall_acceleration, motions, entered, images, groups_before, gone, column, left, wide, order, image_order,
            found, links, maps, groups, lists, wall_lists, wall_place, wall_p, body_end, wall_load, loads, at_wall,
            groups_at_walls, near_walls, walls_found, air_stays, air_near, asking, count, extremes, too_near, fetched,
            held);
        for (const Part& part : parts) add(part.start, part.column, part.groups, part.lists);
        return sum;
    }
};

namespace {

/// Columns in bins of eight spacings: some 32 particles each.
cuda::Bins bins_of(const ColumnGrid& grid, double dp, const Quanta& quanta) {
    const auto height = static_cast<std::int64_t>(8 * dp / quanta.size);
    return {grid, height, static_cast<int>(grid.height / height) + 1};
}

std::vector<int> columns_of(const std::vector<Group>& groups, const std::vector<std::int32_t>& start) {
    std::vector<int> column;
    std::size_t c = 0;
    for (const Group& g : groups) {
        while (start[c + 1] <= g.first) ++c;
        column.push_back(static_cast<int>(c));
    }
    return column;
}

void set_origin(double (&to)[3], const Quanta& quanta) {
    for (int a = 0; a < 3; ++a) to[a] = quanta.origin[a];
}

}  // namespace

LevelOnDevice::LevelOnDevice(Level& level, std::shared_ptr<cuda::Device> device)
    : level_(level),
      device_(std::move(device)),
      on_(std::make_unique<Arrays>(*device_, bins_of(level.grid_, level.setup_.dp, level.quanta_))) {
    cuda::Device& d = *device_;
    Walls& walls = level_.walls_;
    on_->maps.take(level_.ghosts_.maps());
    on_->count.resize(1);
    on_->body_end.take(walls.body_end());
    on_->wall_p.resize(walls.size());
    if (walls.empty()) return;
    for (const Walls::Part& part : walls.parts())
        on_->parts.push_back(
            {part.first, cuda::Array<int>(d), cuda::Array<int>(d), cuda::Array<Group>(d), ListsOnDevice(d)});
    take_sorted_dummies();
}

/// In their order and groups.
void LevelOnDevice::take_sorted_dummies() {
    const Walls& walls = level_.walls_;
    for (std::size_t b = 0; b < on_->parts.size(); ++b) {
        const Walls::Part& part = walls.parts()[b];
        Arrays::Part& on = on_->parts[b];
        on.start.take(part.start), on.groups.take(part.groups);
        on.column.take(columns_of(part.groups, part.start));
    }
    on_->wall_place.take(walls.places());
    take_dummies();
}

/// Where they are now, and how they move.
void LevelOnDevice::take_dummies() {
    const Walls& walls = level_.walls_;
    if (!walls.move()) return;
    on_->wall_place.take(walls.places());
    on_->wall_velocity.take(std::span(walls.velocities(), walls.size()));
    on_->wall_acceleration.take(std::span(walls.accelerations(), walls.size()));
}

NearWalls LevelOnDevice::near_walls() {
    on_->motions.take(level_.walls_.motions());
    return {or_null(on_->wall_normal), or_null(on_->motions), or_null(on_->wall_body)};
}

LevelOnDevice::~LevelOnDevice() = default;

template <class View>
void LevelOnDevice::sweep(const char* kernel, const View& view, const cuda::Array<Group>& groups) {
    const Group* first = groups.data();
    int count = static_cast<int>(groups.size());
    void* const arguments[] = {const_cast<View*>(&view), &first, &count};
    device_->launch(kernel, groups.size() * cuda::warp, arguments);
}

// --- from and to the host ---------------------------------------------------------------------------------------------

void LevelOnDevice::take_state() {
    on_->p.each_with(level_.particles_, [](auto& on, const auto& field) { on.take(field); });
    host_counts_ = false;
}

void LevelOnDevice::bring_all_home() {
    if (home_ || host_counts_) return;
    Particles& p = level_.particles_;
    Arrays& on = *on_;
    on.p.each_with(p, [](const auto& field, auto& to) { field.give(to); });
    on.place.give(p.place), on.motion.give(p.velocity_density), on.stress.give(p.gradient_pressure);
    on.shift.give(p.shift_support), on.rate.give(p.rate), on.surface.give(p.surface);
    on.density_rate.give(p.density_rate);
    on.wall_normal.give(p.wall_normal), on.wall_leaving.give(p.wall_leaving), on.wall_body.give(p.wall_body);
    on.wall_p.give(level_.walls_.pressures());
    if (!order_is_home_) {
        on.order.give_start(level_.start_);
        std::vector<Link> links(on.links.size());
        on.links.give(links);
        std::vector<std::int32_t> start;
        on.image_order.give_start(start);
        level_.ghosts_.take(std::move(links), std::move(start));
    }
    home_ = order_is_home_ = true;
}

std::int64_t LevelOnDevice::live_pairs() const {
    // groups are full but for the last of each column
    return cuda::lanes_of_group * (on_->lists.live() + on_->wall_lists.live());
}

double LevelOnDevice::bytes() const { return on_->bytes(); }

// --- lists --------------------------------------------------------------------------------------------------------------

void LevelOnDevice::make_lists(double drift) {
    Arrays& on = *on_;
    const auto [among, to_walls] = level_.reaches_of_lists(drift);
    if (host_counts_) take_state();
    cross_faces();
    sort_particles();
    find_images(std::max(among.far, to_walls.far));
    Particles& p = level_.particles_;
    const std::size_t n = on.p.size(), all = n + on.links.size();
    p.resize(n);
    p.make_room(on.links.size());
    on.place.resize(all), on.motion.resize(all), on.stress.resize(all);
    on.shift.resize(n), on.rate.resize(n), on.surface.resize(p.surface.size());
    on.density_rate.resize(p.density_rate.size());
    on.air_stays.resize(p.surface.size()), on.air_near.resize(n);
    on.extremes.resize((n + cuda::threads_in_block - 1) / cuda::threads_in_block);
    on.too_near.resize(n);
    update_records();
    make_groups();
    on.asking.resize(on.groups.size());
    const std::vector<cuda::DeviceSource> water{
        on.order.source(on.place.data(), 0), on.image_order.source(on.place.data() + n, static_cast<std::int32_t>(n))};
    on.lists.build(level_.grid_, on.place.data(), on.column, on.groups, water, among / level_.quanta_.size,
                   &Group::list);
    if (!level_.walls_.empty()) {
        level_.walls_.sort(level_.grid_, level_.quanta_, cuda::lanes_of_group);
        if (level_.walls_.move()) take_sorted_dummies();
        for (Arrays::Part& part : on.parts)
            part.lists.build(level_.grid_, on.wall_place.data() + part.first, part.column, part.groups, water,
                             to_walls / level_.quanta_.size, &Group::list);
        find_walls(to_walls);
    }
    home_ = order_is_home_ = false;
}

void LevelOnDevice::cross_faces() {
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    const Box& domain = level_.around_.domain;
    const Faces faces = faces_of(level_.around_.mirrors, domain);
    Ledger& ledger = level_.ledger_;
    std::size_t all = n;
    if (const auto& stream = level_.around_.stream) {
        const CrossOpenings cross{domain.min.x(), domain.max.x(), stream->buffer, level_.setup_.dp};
        on.gone.resize(n);
        int* const entered = on.entered.of(n);
        launch(*device_, "tw_cross", cuda::Cross{cross, on.p.x.data(), on.p.kind.data(), entered, on.gone.data()}, n);
        const int count = on.entered.add_up();
        all += static_cast<std::size_t>(count);
        on.p.each([&](auto& field) {
            if (field.size() > 0) field.grow(all);
        });
        on.gone.grow(all);
        launch(*device_, "tw_enter",
               cuda::Enter{on.p.view(), on.p.kind.data(), or_null(on.p.aired), or_null(on.p.trend),
                           or_null(on.p.compression), on.p.id.data(), on.entered.numbers(), on.entered.before(),
                           on.gone.data(), n, stream->buffer, ledger.next_id},
               n);
        ledger.in += count, ledger.next_id += count;
    }
    on.wide.resize(all), on.left.resize(all);
    launch(*device_, "tw_put_back",
           cuda::PutBack{.mirrors = {on.p.view(), faces},
                         .top = domain.max.z(),
                         .open_top = !faces.mirror[2][1] && !faces.periodic[2],
                         .to_quanta = level_.to_quanta(),
                         .gone = level_.around_.stream ? on.gone.data() : nullptr,
                         .wide = on.wide.data(),
                         .left = on.left.data()},
           all);
}

void LevelOnDevice::sort_particles() {
    Arrays& on = *on_;
    const std::size_t all = on.p.size(), n = on.order.sort(on.wide.data(), on.left.data(), on.p.id.data(), all);
    level_.ledger_.out += static_cast<std::int64_t>(all - n);
    on.p.each_with(on.sorted, [&](const auto& field, auto& sorted) { sorted.resize(field.size() > 0 ? n : 0); });
    launch(*device_, "tw_reorder",
           cuda::Reorder{.order = on.order.order(),
                         .from = on.p.view(),
                         .to = on.sorted.view(),
                         .kind = on.p.kind.data(),
                         .id = on.p.id.data(),
                         .aired = or_null(on.p.aired),
                         .trend = or_null(on.p.trend),
                         .compression = or_null(on.p.compression),
                         .to_kind = on.sorted.kind.data(),
                         .to_id = on.sorted.id.data(),
                         .to_aired = on.sorted.aired.data(),
                         .to_trend = on.sorted.trend.data(),
                         .to_compression = on.sorted.compression.data()},
           n);
    on.p.each_with(on.sorted, [](auto& field, auto& sorted) { field.swap(sorted); });
    sort_at_home(all, n);
}

/// What the host alone knows of the particles, for the edges of zones.
void LevelOnDevice::sort_at_home(std::size_t before, std::size_t n) {
    Particles& p = level_.particles_;
    if (!p.has(With::coarser) && !p.has(With::finer)) return;
    std::vector<std::int32_t> order(n);
    on_->order.give_order(order);
    p.resize(before);
    if (p.has(With::coarser)) p.from_edge.take(order);
    if (p.has(With::finer)) p.children.take(order), p.from_finer_edge.take(order);
}

void LevelOnDevice::find_images(double reach) {
    Arrays& on = *on_;
    const std::size_t n = on.p.size();
    const ImagesNear near{faces_of(level_.around_.mirrors, level_.around_.domain), reach};
    launch(*device_, "tw_count_images", cuda::CountImages{on.p.view(), near, on.images.of(n)}, n);
    const auto count = static_cast<std::size_t>(on.images.add_up());
    on.found.resize(count), on.links.resize(count), on.wide.resize(count);
    launch(*device_, "tw_find_images",
           cuda::FindImages{.p = on.p.view(),
                            .near = near,
                            .maps = on.maps.data(),
                            .to_quanta = level_.to_quanta(),
                            .first = on.images.before(),
                            .links = on.found.data(),
                            .wide = on.wide.data()},
           n);
    on.image_order.sort(on.wide.data(), nullptr, nullptr, count);
    launch(*device_, "tw_reorder_links", cuda::ReorderLinks{on.image_order.order(), on.found.data(), on.links.data()},
           count);
}

void LevelOnDevice::make_groups() {
    Arrays& on = *on_;
    const auto columns = static_cast<std::size_t>(level_.grid_.count());
    launch(*device_, "tw_count_groups",
           cuda::CountGroups{on.order.start(), on.bins.in_column, on.groups_before.of(columns)}, columns);
    const auto count = static_cast<std::size_t>(on.groups_before.add_up());
    on.groups.resize(count), on.column.resize(count);
    launch(*device_, "tw_make_groups",
           cuda::MakeGroups{on.order.start(), on.bins.in_column, on.groups_before.before(), on.groups.data(),
                            on.column.data()},
           columns);
    launch(*device_, "tw_centre_groups",
           cuda::CentreGroups{level_.grid_, on.place.data(), on.column.data(), on.groups.data()}, count);
}

void LevelOnDevice::find_walls(const Reaches& reaches) {
    Arrays& on = *on_;
    Walls& walls = level_.walls_;
    std::vector<cuda::DeviceSource> dummies;
    for (const Arrays::Part& part : on.parts)
        dummies.push_back(
            {on.wall_place.data() + part.first, part.start.data(), 1, static_cast<std::int32_t>(part.first)});
    on.wall_lists.build(level_.grid_, on.place.data(), on.column, on.groups, dummies, reaches / level_.quanta_.size,
                        &Group::wall_list);
    const std::size_t groups = on.groups.size();
    launch(*device_, "tw_count_wall_loads",
           cuda::CountWallLoads{on.groups.data(), on.wall_lists.blocks(), on.body_end.data(),
                                static_cast<int>(on.body_end.size()), on.loads.of(groups), on.at_wall.of(groups)},
           groups);
    const auto loads = static_cast<std::size_t>(on.loads.add_up()),
               at_walls = static_cast<std::size_t>(on.at_wall.add_up());
    on.wall_load.resize(loads);
    walls.group_loads().resize(loads);
    on.groups_at_walls.resize(at_walls);
    cuda::ListGroupsAtWalls list{.columns = level_.grid_,
                                 .column = on.column.data(),
                                 .first_load = on.loads.before(),
                                 .at_wall = on.at_wall.numbers(),
                                 .before = on.at_wall.before(),
                                 .origin = {},
                                 .quantum = level_.quanta_.size,
                                 .groups = on.groups.data(),
                                 .list = on.groups_at_walls.data()};
    set_origin(list.origin, level_.quanta_);
    launch(*device_, "tw_list_groups_at_walls", list, groups);
    std::vector<cuda::GroupAtWall> home(at_walls);
    on.groups_at_walls.give(home);
    level_.groups_.clear(), centres_.clear();
    for (const cuda::GroupAtWall& g : home) level_.groups_.push_back(g.group), centres_.emplace_back(g.x, g.y, g.z);
    ask_walls(at_walls);
}

/// The host finds the wall nearest to each particle of the groups at walls.
void LevelOnDevice::ask_walls(std::size_t groups) {
    Arrays& on = *on_;
    const std::size_t n = on.p.size(), asked = groups * cuda::lanes_of_group;
    on.wall_normal.resize(n), on.wall_leaving.resize(n), on.wall_body.resize(level_.walls_.move() ? n : 0);
    launch(*device_, "tw_no_walls", cuda::NoWalls{on.wall_normal.data(), on.wall_leaving.data(), or_null(on.wall_body)},
           n);
    on.near_walls.resize(asked), on.walls_found.resize(asked);
    launch(*device_, "tw_take_near_walls",
           cuda::TakeNearWalls{on.p.view(), on.p.kind.data(), on.groups_at_walls.data(), on.near_walls.data()}, asked);
    std::vector<cuda::NearWall> near(asked);
    on.near_walls.give(near);
    std::vector<cuda::WallFound> found(asked);
    const double reach = level_.reach_of_normals();
    for_particles(asked, [&](std::size_t k) {
        const cuda::NearWall& q = near[k];
        found[k].index = q.index;
        if (q.index < 0) return;
        const Walls::Nearest nearest = level_.walls_.nearest(Vec3(q.x, q.y, q.z), Vec3(q.u, q.v, q.w), reach);
        found[k].wall = nearest.normal, found[k].leaving = nearest.leaving;
        found[k].body = static_cast<std::uint16_t>(nearest.body);
    });
    on.walls_found.take(found);
    launch(*device_, "tw_put_walls",
           cuda::PutWalls{on.walls_found.data(), on.wall_normal.data(), on.wall_leaving.data(), or_null(on.wall_body)},
           asked);
    std::optional<std::size_t> through;
    for (std::size_t k = 0; k < asked; ++k)
        if (found[k].index >= 0 && double(found[k].wall.distance) < -level_.setup_.dp && is_active(near[k].kind))
            through = static_cast<std::size_t>(found[k].index);
    if (!through) return;
    home_ = order_is_home_ = false;
    bring_all_home();
    level_.fail_through_wall(through);
}

// --- a step -------------------------------------------------------------------------------------------------------------

void LevelOnDevice::refresh(double drift) {
    Arrays& on = *on_;
    if (host_counts_) take_state();
    update_records();
    take_dummies();
    PruneData d;
    d.lists = on.lists.view();
    d.of = d.place = on.place.data();
    d.reach = level_.reach_among(drift) / level_.quanta_.size;
    sweep("tw_prune", d, on.groups);
    home_ = false;
    if (level_.walls_.empty()) return;
    d.reach = level_.reach_to_walls(drift) / level_.quanta_.size;
    for (const Arrays::Part& part : on.parts) {
        d.lists = part.lists.view();
        d.of = on.wall_place.data() + part.first;
        sweep("tw_prune", d, part.groups);
    }
    d.of = on.place.data(), d.place = on.wall_place.data();
    d.lists = on.wall_lists.view();
    d.list = &Group::wall_list;
    sweep("tw_prune", d, on.groups);
}

void LevelOnDevice::update_records() {
    Arrays& on = *on_;
    launch(*device_, "tw_update_records",
           UpdateRecords{on.p.view(), level_.to_quanta(), on.place.data(), on.motion.data()}, on.p.size());
    refresh_images(nullptr);
}

void LevelOnDevice::refresh_images(GradientPressureRecord* stress) {
    const Vec3& g = level_.around_.gravity;
    launch(*device_, "tw_refresh_images",
           cuda::RefreshImages{.links = on_->links.data(),
                               .maps = on_->maps.data(),
                               .n = on_->p.size(),
                               .quantum = level_.quanta_.size,
                               .still = level_.ghosts_.still(),
                               .gravity = {g.x(), g.y(), g.z()},
                               .place = on_->place.data(),
                               .motion = on_->motion.data(),
                               .stress = stress},
           on_->links.size());
}

/// Of the device's arrays in place of the host's.
WaterView LevelOnDevice::water() const {
    WaterView w = level_.water_view();
    w.list = on_->lists.view();
    w.place = on_->place.data(), w.motion = on_->motion.data(), w.stress = on_->stress.data();
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
    w.normal = or_null(on_->wall_normal);
    return w;
}

void LevelOnDevice::first_sweep(double compress, double drift) {
    Arrays& on = *on_;
    const std::size_t n = on.p.size(), all = on.place.size(), words = on.surface.size();
    if (host_counts_) take_state();
    FirstSweepData d = level_.first_sweep_data();
    d.water = water(), d.walls = walls();
    d.stress = on.stress.data(), d.shift = on.shift.data(), d.rate = on.rate.data();
    d.carried = nullptr;
    sweep("tw_first_sweep", d, on.groups);
    const LacksSupport lacks_support{on.p.kind.data(), or_null(on.p.trend), on.shift.data(),
                                     level_.setup_.surface_support};
    launch(*device_, "tw_mark_surface",
           cuda::MarkSurface{lacks_support, on.links.data(), n, all, on.surface.data()}, words);
    if (on.p.aired.size() > 0) note_air();
    AfterFirstSweep after = level_.after_first_sweep(compress, drift);
    after.p = on.p.view();
    after.kind = on.p.kind.data(), after.rate = on.rate.data(), after.shift = on.shift.data();
    after.aired = or_null(on.p.aired);
    after.place = on.place.data(), after.motion = on.motion.data(), after.stress = on.stress.data();
    after.wall = or_null(on.wall_normal);
    after.trend = or_null(on.p.trend), after.compression = or_null(on.p.compression);
    after.density_rate = or_null(on.density_rate);
    on.density_rate.set_zero();
    const double c0 = level_.setup_.state_equation.c0;
    launch(*device_, "tw_compress", cuda::Compress{after, near_walls(), static_cast<float>(c0 * c0)}, n);
    refresh_images(on.stress.data());
    home_ = false;
}

void LevelOnDevice::note_air() {
    Arrays& on = *on_;
    const std::size_t n = on.p.size(), all = on.place.size();
    const Ventilation v;
    const AirAtParticles air{on.p.aired.data(), or_null(on.wall_normal),
                             on.p.drho.data(),  on.shift.data(),
                             on.surface.data(), v.reach_over_dp * static_cast<float>(level_.setup_.dp),
                             v.support};
    launch(*device_, "tw_mark_air", cuda::MarkAir{air, on.links.data(), n, all, on.air_stays.data()},
           on.surface.size());
    on.count.set_zero(), on.air_near.set_zero();
    launch(*device_, "tw_find_asking",
           cuda::FindAsking{air, on.air_stays.data(), on.groups.data(), on.asking.data(), on.count.data()},
           on.groups.size());
    NearAirData d{.water = water(), .near = on.air_near.data()};
    d.water.surface = on.air_stays.data();
    const Group* asking = on.asking.data();
    const int* count = on.count.data();
    void* const arguments[] = {&d, &asking, &count};
    device_->launch("tw_near_air", on.groups.size() * cuda::warp, arguments);
    launch(*device_, "tw_note_air", cuda::NoteAir{air, on.air_stays.data(), on.air_near.data()}, n);
}

void LevelOnDevice::second_sweep(double t) {
    Arrays& on = *on_;
    take_dummies();
    for (const Arrays::Part& part : on.parts) {
        ExtrapolateData e = level_.extrapolation();
        e.water = water();
        e.list = part.lists.view();
        e.at = on.wall_place.data() + part.first;
        e.p = on.wall_p.data() + part.first;
        if (on.wall_acceleration.size() > 0) e.acceleration = on.wall_acceleration.data() + part.first;
        sweep("tw_extrapolate", e, part.groups);
    }
    SecondSweepData d = level_.second_sweep_data(t);
    d.water = water(), d.walls = walls();
    d.leaving = or_null(on.wall_leaving);
    d.shift = on.shift.data(), d.rate = on.rate.data(), d.wall_load = on.wall_load.data();
    sweep("tw_second_sweep", d, on.groups);
    on.wall_load.give(level_.walls_.group_loads());
    home_ = false;
}

LevelOnDevice::Moved LevelOnDevice::move(const Move& of_host) {
    Arrays& on = *on_;
    std::size_t n = on.p.size();
    cuda::MoveAll task{.move = of_host,
                       .wall = or_null(on.wall_normal),
                       .walls = near_walls(),
                       .held_from = Level::held_at_wall_over_dp * level_.setup_.dp,
                       .too_near = on.too_near.data(),
                       .count = on.count.data()};
    task.move.p = on.p.view();
    task.move.kind = on.p.kind.data(), task.move.rate = on.rate.data(), task.move.shift_support = on.shift.data();
    task.move.trend = or_null(on.p.trend);
    on.count.set_zero();
    MovedExtremes* of_blocks = on.extremes.data();
    void* const arguments[] = {&task, &of_blocks, &n};
    device_->launch("tw_move", n, arguments);
    home_ = false;

    Moved moved;
    std::vector<MovedExtremes> parts(on.extremes.size());
    on.extremes.give(parts);
    for (const MovedExtremes& part : parts) cuda::join(moved.extremes, part);
    int held = 0;
    on.count.give(std::span(&held, 1));
    if (held == 0) return moved;
    std::vector<std::int32_t> which(static_cast<std::size_t>(held));
    on.too_near.give(which);
    std::ranges::sort(which);
    moved.at_walls.assign(which.begin(), which.end());
    fetch(std::move(which));
    return moved;
}

void LevelOnDevice::bring_home(const std::vector<std::size_t>& particles) {
    if (!home_) fetch({particles.begin(), particles.end()});
}

void LevelOnDevice::fetch(std::vector<std::int32_t> which) {
    Arrays& on = *on_;
    on.fetched.take(which);
    on.held.resize(which.size());
    launch(*device_, "tw_take_held",
           cuda::TakeHeld{on.p.view(), or_null(on.wall_normal), or_null(on.wall_leaving), or_null(on.wall_body),
                          on.p.id.data(), on.p.kind.data(), on.fetched.data(), on.held.data()},
           which.size());
    std::vector<cuda::HeldParticle> held(which.size());
    on.held.give(held);
    Particles& p = level_.particles_;
    for (const cuda::HeldParticle& h : held) {
        const auto i = static_cast<std::size_t>(h.index);
        p.x[i] = h.x, p.y[i] = h.y, p.z[i] = h.z;
        p.u[i] = h.u, p.v[i] = h.v, p.w[i] = h.w, p.drho[i] = h.drho;
        p.id[i] = h.id, p.kind[i] = h.kind;
        if (!p.wall_body.empty()) p.wall_body[i] = h.body;
        if (!p.wall_normal.empty()) p.wall_normal[i] = h.wall, p.wall_leaving[i] = h.leaving;
    }
}

void LevelOnDevice::put_back(const std::vector<std::size_t>& held_at_home) {
    if (held_at_home.empty()) return;
    const Particles& p = level_.particles_;
    std::vector<cuda::HeldParticle> held;
    for (const std::size_t i : held_at_home)
        held.push_back({static_cast<std::int64_t>(i), p.id[i], p.x[i], p.y[i], p.z[i], p.u[i], p.v[i], p.w[i],
                        p.drho[i], p.wall_normal[i], p.wall_leaving[i], p.kind[i],
                        p.wall_body.empty() ? std::uint16_t{0} : p.wall_body[i]});
    on_->held.take(held);
    launch(*device_, "tw_put_held",
           cuda::PutHeld{on_->held.data(), on_->p.view(), on_->wall_normal.data(), on_->wall_leaving.data(),
                         or_null(on_->wall_body)},
           held.size());
}

// --- points -------------------------------------------------------------------------------------------------------------

void LevelOnDevice::sample(const Points& points, const Reaches& quanta, const ExtrapolateData& to) {
    Arrays& on = *on_;
    cuda::Device& d = *device_;
    const std::size_t n = points.places.size(), own = on.p.size();
    cuda::Array<PlaceRecord> places(d);
    cuda::Array<Group> groups(d);
    cuda::Array<int> column(d);
    cuda::Array<float> p(d), support(d);
    ListsOnDevice lists(d);
    places.take(points.places), groups.take(points.groups);
    column.take(columns_of(points.groups, points.start));
    p.resize(n), support.resize(n);
    lists.build(level_.grid_, places.data(), column, groups,
                {on.order.source(on.place.data(), 0),
                 on.image_order.source(on.place.data() + own, static_cast<std::int32_t>(own))},
                quanta, &Group::list);
    ExtrapolateData e = to;
    e.water = water();
    e.list = lists.view();
    e.at = places.data(), e.p = p.data(), e.support = support.data();
    sweep("tw_extrapolate", e, groups);
    p.give(std::span(to.p, n)), support.give(std::span(to.support, n));
}

}  // namespace tw
