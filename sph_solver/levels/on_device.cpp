#include "sph_solver/levels/on_device.h"

#include <algorithm>

#include "sph_solver/backend/cuda/tasks.h"
#include "sph_solver/effects/ventilation.h"
#include "sph_solver/levels/level.h"

namespace tw {

namespace {

/// Neighbour lists on the device, as those of the host.
class DeviceLists {
public:
    explicit DeviceLists(cuda::Device& device) : blocks_(device), starts_(device) {}
    void take(const NeighbourLists& lists) {
        std::vector<NeighbourBlock> all;
        std::vector<std::size_t> first;
        for (const auto& chunk : lists.chunks()) {
            first.push_back(all.size());
            all.insert(all.end(), chunk.begin(), chunk.end());
        }
        blocks_.take(all);
        std::vector<NeighbourBlock*> starts;
        for (const std::size_t at : first) starts.push_back(blocks_.data() + at);
        starts_.take(starts);
    }
    Lists view() const { return {starts_.data()}; }
    std::size_t bytes() const { return blocks_.bytes() + starts_.bytes(); }

private:
    cuda::Array<NeighbourBlock> blocks_;
    cuda::Array<NeighbourBlock*> starts_;
};

template <class T>
T* or_null(const cuda::Array<T>& array) {
    return array.size() > 0 ? array.data() : nullptr;
}

}  // namespace

struct LevelOnDevice::Arrays {
    cuda::Device& device;
    cuda::Array<double> x{device}, y{device}, z{device};
    cuda::Array<float> u{device}, v{device}, w{device}, drho{device};
    cuda::Array<Kind> kind{device};
    cuda::Array<Aired> aired{device};
    cuda::Array<PlaceRecord> place{device};
    cuda::Array<VelocityDensityRecord> motion{device};
    cuda::Array<GradientPressureRecord> stress{device};
    cuda::Array<ShiftSupportRecord> shift{device};
    cuda::Array<RateRecord> rate{device};
    cuda::Array<std::uint32_t> surface{device};
    cuda::Array<WallNormalRecord> wall_normal{device};
    cuda::Array<LeavingRecord> wall_leaving{device};

    cuda::Array<Link> links{device};
    cuda::Array<LinkMap> maps{device};
    cuda::Array<Group> groups{device};
    DeviceLists lists{device};

    cuda::Array<PlaceRecord> wall_place{device};
    cuda::Array<float> wall_p{device};
    cuda::Array<std::int32_t> body_end{device};
    cuda::Array<WallLoad> wall_load{device};
    DeviceLists wall_lists{device};
    /// The dummies of one body that have water near.
    struct Part {
        std::size_t first;
        cuda::Array<Group> groups;
        DeviceLists lists;
    };
    std::vector<Part> parts;

    cuda::Array<std::uint32_t> air_stays{device};
    cuda::Array<std::uint8_t> air_near{device};
    cuda::Array<Group> asking{device};
    cuda::Array<int> count{device};
    cuda::Array<MovedExtremes> extremes{device};
    cuda::Array<std::int32_t> too_near{device}, fetched{device};
    cuda::Array<cuda::HeldParticle> held{device};

    explicit Arrays(cuda::Device& d) : device(d) {}

    StateView state() const { return {x.data(), y.data(), z.data(), u.data(), v.data(), w.data(), drho.data()}; }
    /// Calls `f(array)` for each but those of `parts`.
    template <class Function>
    void each(const Function& f) const {
        f(x), f(y), f(z), f(u), f(v), f(w), f(drho), f(kind), f(aired), f(place), f(motion), f(stress), f(shift);
        f(rate), f(surface), f(wall_normal), f(wall_leaving), f(links), f(maps), f(groups), f(lists), f(wall_place);
        f(wall_p), f(body_end), f(wall_load), f(wall_lists), f(air_stays), f(air_near), f(asking), f(count);
        f(extremes), f(too_near), f(fetched), f(held);
    }
};

LevelOnDevice::LevelOnDevice(Level& level, std::shared_ptr<cuda::Device> device)
    : level_(level), device_(std::move(device)), on_(std::make_unique<Arrays>(*device_)) {
    on_->maps.take(level_.ghosts_.maps());
    on_->body_end.take(level_.walls_.body_end());
    on_->wall_place.take(level_.walls_.places());
    for (const Walls::Part& part : level_.walls_.parts())
        on_->parts.push_back({part.first, cuda::Array<Group>(*device_), DeviceLists(*device_)});
    on_->count.resize(1);
}

LevelOnDevice::~LevelOnDevice() = default;

template <class Task>
void LevelOnDevice::start(const char* kernel, const Task& task, std::size_t count) {
    void* const arguments[] = {const_cast<Task*>(&task), &count};
    device_->launch(kernel, count, arguments);
}

template <class View>
void LevelOnDevice::sweep(const char* kernel, const View& view, const cuda::Array<Group>& groups) {
    const Group* first = groups.data();
    int count = static_cast<int>(groups.size());
    void* const arguments[] = {const_cast<View*>(&view), &first, &count};
    device_->launch(kernel, groups.size() * cuda::warp, arguments);
}

// --- from and to the host ---------------------------------------------------------------------------------------------

void LevelOnDevice::bring_state_home() {
    if (state_is_home_) return;
    Particles& p = level_.particles_;
    on_->x.give(p.x), on_->y.give(p.y), on_->z.give(p.z);
    on_->u.give(p.u), on_->v.give(p.v), on_->w.give(p.w), on_->drho.give(p.drho);
    on_->aired.give(p.aired);
    state_is_home_ = true;
}

void LevelOnDevice::bring_all_home() {
    bring_state_home();
    if (all_is_home_) return;
    Particles& p = level_.particles_;
    on_->place.give(p.place), on_->motion.give(p.velocity_density), on_->stress.give(p.gradient_pressure);
    on_->shift.give(p.shift_support), on_->rate.give(p.rate), on_->surface.give(p.surface);
    on_->wall_normal.give(p.wall_normal), on_->wall_leaving.give(p.wall_leaving);
    on_->wall_p.give(level_.walls_.pressures());
    all_is_home_ = true;
}

void LevelOnDevice::take_state() {
    Particles& p = level_.particles_;
    Arrays& on = *on_;
    on.x.take(p.x), on.y.take(p.y), on.z.take(p.z);
    on.u.take(p.u), on.v.take(p.v), on.w.take(p.w), on.drho.take(p.drho);
    on.kind.take(p.kind), on.aired.take(p.aired);
    state_changed_ = false;
}

void LevelOnDevice::take_lists() {
    Particles& p = level_.particles_;
    const std::size_t n = p.size();
    Arrays& on = *on_;
    take_state();
    on.place.take(p.place), on.motion.take(p.velocity_density);
    on.stress.resize(p.gradient_pressure.size());
    on.shift.resize(n), on.rate.resize(n), on.surface.resize(p.surface.size());
    on.wall_normal.take(p.wall_normal), on.wall_leaving.take(p.wall_leaving);
    on.links.take(level_.ghosts_.links());
    on.groups.take(level_.groups_);
    on.lists.take(level_.lists_);
    on.air_stays.resize(p.surface.size()), on.air_near.resize(n), on.asking.resize(level_.groups_.size());
    on.extremes.resize((n + cuda::threads_in_block - 1) / cuda::threads_in_block);
    on.too_near.resize(n);
    Walls& walls = level_.walls_;
    if (!walls.empty()) {
        on.wall_lists.take(walls.neighbour_lists());
        for (std::size_t b = 0; b < on.parts.size(); ++b) {
            on.parts[b].groups.take(walls.parts()[b].near_water);
            on.parts[b].lists.take(walls.parts()[b].water);
        }
        on.wall_p.resize(walls.size());
        on.wall_p.set_zero();
        on.wall_load.resize(walls.group_load_count());
    }
    state_is_home_ = true, all_is_home_ = false;
}

// --- a step -------------------------------------------------------------------------------------------------------------

void LevelOnDevice::refresh(double drift) {
    Arrays& on = *on_;
    if (state_changed_) take_state();
    start("tw_update_records", UpdateRecords{on.state(), level_.to_quanta(), on.place.data(), on.motion.data()},
          on.x.size());
    refresh_images(nullptr);
    PruneData d;
    d.lists = on.lists.view();
    d.of = d.place = on.place.data();
    d.reach = level_.reach_among(drift) / level_.quanta_.size;
    sweep("tw_prune", d, on.groups);
    state_is_home_ = all_is_home_ = false;
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

void LevelOnDevice::refresh_images(GradientPressureRecord* stress) {
    const Vec3& g = level_.around_.gravity;
    start("tw_refresh_images",
          cuda::RefreshImages{.links = on_->links.data(),
                              .maps = on_->maps.data(),
                              .n = on_->x.size(),
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
    if (w.kind) w.kind = on_->kind.data();
    return w;
}
WallView LevelOnDevice::walls() const {
    WallView w = level_.wall_view();
    w.list = on_->wall_lists.view();
    w.place = or_null(on_->wall_place), w.p = on_->wall_p.data();
    w.velocity = nullptr;
    w.body_end = on_->body_end.data();
    w.normal = or_null(on_->wall_normal);
    return w;
}

void LevelOnDevice::first_sweep(double compress, double drift) {
    Arrays& on = *on_;
    const std::size_t n = on.x.size(), all = on.place.size(), words = on.surface.size();
    FirstSweepData d = level_.first_sweep_data();
    d.water = water(), d.walls = walls();
    d.stress = on.stress.data(), d.shift = on.shift.data(), d.rate = on.rate.data();
    d.carried = nullptr;
    sweep("tw_first_sweep", d, on.groups);
    start("tw_mark_surface",
          cuda::MarkSurface{on.shift.data(), level_.setup_.surface_support, on.links.data(), n, all,
                            on.surface.data()},
          words);
    if (on.aired.size() > 0) note_air();
    AfterFirstSweep after = level_.after_first_sweep(compress, drift);
    after.p = on.state();
    after.kind = on.kind.data(), after.rate = on.rate.data(), after.shift = on.shift.data();
    after.aired = or_null(on.aired);
    after.place = on.place.data(), after.motion = on.motion.data(), after.stress = on.stress.data();
    after.wall = or_null(on.wall_normal);
    const double c0 = level_.setup_.state_equation.c0;
    start("tw_compress", cuda::Compress{after, static_cast<float>(c0 * c0)}, n);
    refresh_images(on.stress.data());
    state_is_home_ = all_is_home_ = false;
}

void LevelOnDevice::note_air() {
    Arrays& on = *on_;
    const std::size_t n = on.x.size(), all = on.place.size();
    const Ventilation v;
    const AirAtParticles air{on.aired.data(),
                             or_null(on.wall_normal),
                             on.drho.data(),
                             on.shift.data(),
                             on.surface.data(),
                             v.reach_over_dp * static_cast<float>(level_.setup_.dp),
                             v.support};
    start("tw_mark_air", cuda::MarkAir{air, on.links.data(), n, all, on.air_stays.data()}, on.surface.size());
    on.count.set_zero(), on.air_near.set_zero();
    start("tw_find_asking",
          cuda::FindAsking{air, on.air_stays.data(), on.groups.data(), on.asking.data(), on.count.data()},
          on.groups.size());
    NearAirData d{.water = water(), .near = on.air_near.data()};
    d.water.surface = on.air_stays.data();
    const Group* asking = on.asking.data();
    const int* count = on.count.data();
    void* const arguments[] = {&d, &asking, &count};
    device_->launch("tw_near_air", on.groups.size() * cuda::warp, arguments);
    start("tw_note_air", cuda::NoteAir{air, on.air_stays.data(), on.air_near.data()}, n);
}

void LevelOnDevice::second_sweep(double t) {
    Arrays& on = *on_;
    for (const Arrays::Part& part : on.parts) {
        ExtrapolateData e = level_.extrapolation();
        e.water = water();
        e.list = part.lists.view();
        e.at = on.wall_place.data() + part.first;
        e.p = on.wall_p.data() + part.first;
        sweep("tw_extrapolate", e, part.groups);
    }
    SecondSweepData d = level_.second_sweep_data(t);
    d.water = water(), d.walls = walls();
    d.leaving = or_null(on.wall_leaving);
    d.shift = on.shift.data(), d.rate = on.rate.data(), d.wall_load = on.wall_load.data();
    sweep("tw_second_sweep", d, on.groups);
    on.wall_load.give(level_.walls_.group_loads());
    state_is_home_ = all_is_home_ = false;
}

LevelOnDevice::Moved LevelOnDevice::move(const Move& of_host) {
    Arrays& on = *on_;
    std::size_t n = on.x.size();
    cuda::MoveAll task{.move = of_host,
                       .wall = or_null(on.wall_normal),
                       .held_from = Level::held_at_wall_over_dp * level_.setup_.dp,
                       .too_near = on.too_near.data(),
                       .count = on.count.data()};
    task.move.p = on.state();
    task.move.kind = on.kind.data(), task.move.rate = on.rate.data(), task.move.shift_support = on.shift.data();
    on.count.set_zero();
    MovedExtremes* of_blocks = on.extremes.data();
    void* const arguments[] = {&task, &of_blocks, &n};
    device_->launch("tw_move", n, arguments);
    state_is_home_ = all_is_home_ = false;

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
    if (!state_is_home_) fetch({particles.begin(), particles.end()});
}

void LevelOnDevice::fetch(std::vector<std::int32_t> which) {
    Arrays& on = *on_;
    on.fetched.take(which);
    on.held.resize(which.size());
    start("tw_take_held",
          cuda::TakeHeld{on.state(), or_null(on.wall_normal), or_null(on.wall_leaving), on.fetched.data(),
                         on.held.data()},
          which.size());
    std::vector<cuda::HeldParticle> held(which.size());
    on.held.give(held);
    Particles& p = level_.particles_;
    for (const cuda::HeldParticle& h : held) {
        const auto i = static_cast<std::size_t>(h.index);
        p.x[i] = h.x, p.y[i] = h.y, p.z[i] = h.z;
        p.u[i] = h.u, p.v[i] = h.v, p.w[i] = h.w, p.drho[i] = h.drho;
        if (!p.wall_normal.empty()) p.wall_normal[i] = h.wall, p.wall_leaving[i] = h.leaving;
    }
}

void LevelOnDevice::put_back(const std::vector<std::size_t>& held_at_home) {
    if (held_at_home.empty()) return;
    const Particles& p = level_.particles_;
    std::vector<cuda::HeldParticle> held;
    for (const std::size_t i : held_at_home)
        held.push_back({static_cast<std::int64_t>(i), p.x[i], p.y[i], p.z[i], p.u[i], p.v[i], p.w[i], p.drho[i],
                        p.wall_normal[i], p.wall_leaving[i]});
    on_->held.take(held);
    start("tw_put_held",
          cuda::PutHeld{on_->held.data(), on_->state(), on_->wall_normal.data(), on_->wall_leaving.data()},
          held.size());
}

double LevelOnDevice::bytes() const {
    double sum = 0;
    on_->each([&](const auto& array) { sum += double(array.bytes()); });
    for (const Arrays::Part& part : on_->parts) sum += double(part.groups.bytes() + part.lists.bytes());
    return sum;
}

}  // namespace tw
