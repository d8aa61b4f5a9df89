#include "sph_solver/levels/level.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"
#include "base/numbers.h"
#include "sph_solver/backend/for_particles.h"
#include "sph_solver/backend/stopwatch.h"
#include "sph_solver/bodies/group_loads.h"
#include "sph_solver/bodies/wall_pushes.h"
#include "sph_solver/effects/effects.h"
#include "sph_solver/equations/water_touch.h"
#include "sph_solver/loops/surface.h"

namespace tw {

namespace {

Quanta quanta_of(const Surroundings& around, double dp) {
    Vec3 middle = (around.domain.min + around.domain.max) / 2;
    if (around.dimensions == 2) middle.y() = 0;
    return Quanta(middle, dp / (1 << 18));
}

/// The columns cover the domain, its mirror images and the buffers of the stream.
Box column_area(const Surroundings& around, double support, double dp) {
    Box area = around.domain;
    area.min.array() -= support + dp;
    area.max.array() += support + dp;
    if (around.stream) {
        area.min.x() -= around.stream->buffer;
        area.max.x() += around.stream->buffer;
    }
    return area;
}

}  // namespace

Level::Level(const Surroundings& around, LevelSetup setup, const EffectOptions& effects, const Schedule& schedule,
             const Bodies& bodies, const Passes& passes, const Fluid& fluid)
    : around_(around),
      setup_(std::move(setup)),
      schedule_(schedule),
      bodies_(bodies),
      passes_(passes),
      h_(setup_.h_over_dp * setup_.dp),
      mass_(setup_.rho0 * (fluid.volume > 0 ? fluid.volume : std::pow(setup_.dp, around.dimensions))),
      kernel_(h_, around.dimensions),
      given_back_(static_cast<float>(WaterTouch::of_plane_surface(kernel_, setup_.dp, around.dimensions))),
      quanta_(quanta_of(around, setup_.dp)),
      grid_(column_area(around, kernel_.support(), setup_.dp), setup_.dp, around.dimensions, quanta_, passes.lanes),
      ghosts_(around, setup_, quanta_),
      walls_(bodies, around, setup_, kernel_.support(), grid_, quanta_, passes.lanes) {
    for (const EffectOn& on : effects) particles_.bring(effects_.emplace_back(on.make())->brings());
    if (!walls_.empty()) {
        particles_.bring(With::walls);
        if (walls_.move()) particles_.bring(With::moving_bodies);
        if (walls_.give_way()) particles_.bring(With::elastic_bodies);
    }
    particles_.reserve(fluid.places.size());
    for (std::size_t k = 0; k < fluid.places.size(); ++k) {
        const Vec3& p = fluid.places[k];
        const double depth_pressure =
            around.at_rest ? around.at_rest->carried(p.z()) : setup_.rho0 * around.gravity.norm() * fluid.depth[k];
        const Kind kind = around.stream && p.x() < around.domain.min.x()   ? Kind::inlet
                          : around.stream && p.x() > around.domain.max.x() ? Kind::outlet
                                                                           : Kind::fluid;
        particles_.add(p.x(), p.y(), p.z(), static_cast<float>(stream_velocity(0)),
                       setup_.state_equation.deviation(setup_.rho0, depth_pressure), ledger_.next_id++, kind);
    }
    begin_whole();
    if (!around.frame) return;
    const Eigen::Vector3f u = around.frame->velocity_of_rest().cast<float>();
    for (std::size_t i = 0; i < particles_.size(); ++i)
        particles_.u[i] = u.x(), particles_.v[i] = u.y(), particles_.w[i] = u.z();
}

double Level::reference_speed() const { return std::max(extremes_.speed, stream_velocity(time_)); }

Vec3 Level::body_force() const {
    return around_.weight() + Vec3(around_.stream ? around_.stream->acceleration(time_) : 0, 0, 0);
}

double Level::lid_pressure() const {
    struct Under {
        ExactSum pressure;
        std::int64_t count = 0;
        Under& operator+=(const Under& other) {
            pressure += other.pressure, count += other.count;
            return *this;
        }
    };
    const Particles& p = home();
    const Under lid = sum_over_all<Under>([&](Under& sum, std::size_t i) {
        if (p.z[i] <= around_.domain.max.z() - kernel_.support()) return;
        sum.pressure += setup_.state_equation.pressure(setup_.rho0, p.drho[i]);
        ++sum.count;
    });
    return lid.count > 0 ? lid.pressure.value() / double(lid.count) : 0;
}

// --- the two sweeps -------------------------------------------------------------------------------------------------

WaterView Level::water_view() const {
    const Particles& r = particles_;
    const bool of_one_kind = !particles_.has(With::coarser) && !particles_.has(With::finer) && !around_.stream;
    return {.list = lists_.view(),
            .place = r.place.data(),
            .motion = r.velocity_density.data(),
            .stress = r.gradient_pressure.data(),
            .surface = r.surface.data(),
            .kind = of_one_kind ? nullptr : particles_.kind.data(),
            .kernel = kernel_,
            .quantum = static_cast<float>(quanta_.size),
            .rho0 = static_cast<float>(setup_.rho0),
            .inv_mass = static_cast<float>(1 / mass_),
            .two_dimensional = around_.dimensions == 2};
}

WallView Level::wall_view() const {
    return {.list = walls_.lists(),
            .place = walls_.places().data(),
            .p = walls_.pressures().data(),
            .velocity = walls_.velocities(),
            .body_end = walls_.body_end().data(),
            .bodies = static_cast<int>(walls_.body_end().size()),
            .normal = particles_.wall_normal.data()};
}

FirstSweepData Level::first_sweep_data() {
    Particles& r = particles_;
    return {.water = water_view(),
            .walls = wall_view(),
            .stress = r.gradient_pressure.data(),
            .shift = r.shift_support.data(),
            .rate = r.rate.data(),
            .carried = r.carried.empty() ? nullptr : r.carried.data(),
            .inv_W_dp = static_cast<float>(1 / kernel_.W(setup_.dp)),
            .fastest_shift = static_cast<float>(setup_.state_equation.c0 / 10),
            .inv_dp = static_cast<float>(1 / setup_.dp),
            .inv_void = static_cast<float>(1 / (1 - setup_.touch_support)),
            .surface_support = static_cast<float>(setup_.surface_support),
            .given_back = given_back_};
}

SecondSweepData Level::second_sweep_data(double t) {
    const LevelSetup& s = setup_;
    const double stream_acceleration = around_.stream ? around_.stream->acceleration(t) : 0;
    SecondSweepData d{.water = water_view(),
                      .walls = wall_view(),
                      .leaving = particles_.wall_leaving.data(),
                      .shift = particles_.shift_support.data(),
                      .rate = particles_.rate.data(),
                      .wall_load = walls_.group_loads().data(),
                      .diffusion = static_cast<float>(s.delta * s.state_equation.c0),
                      .packing = s.shifting > 0 ? static_cast<float>(s.packing * s.state_equation.c0 / h_ * s.rho0) : 0,
                      .packing_reach = static_cast<float>(kernel_.support() - s.dp / 2),
                      .viscosity = static_cast<float>(s.alpha * s.state_equation.c0 * s.rho0 / 2),
                      .gx = static_cast<float>(around_.weight().x() + stream_acceleration),
                      .gy = static_cast<float>(around_.weight().y()),
                      .gz = static_cast<float>(around_.weight().z())};
    if (s.tension_control) d.tension_control_from = static_cast<float>(s.shifting_support);
    return d;
}

void Level::first_sweep(double t, double compress, double drift, const OtherSums* other) {
    if (device_) {
        const Stopwatch watch(timers_.gradient);
        device_->first_sweep(t, compress, drift, other);
        return note_compression();
    }
    FirstSweepData d = first_sweep_data();
    d.other = other;
    {
        const Stopwatch watch(timers_.gradient);
        for_pairs(passes_, d, groups_);
    }
    const Stopwatch watch(timers_.update);
    tell_first_sweep();
    mark_surface();
    each_effect(t, [](Effect& effect, const StepView& view) { effect.after_first_sweep(view); });
    Particles& p = particles_;
    if (p.has(With::coarser)) p.density_rate.assign(p.size(), 0);
    note_compression();
    const AfterFirstSweep after = after_first_sweep(compress, drift);
    for_particles(p.size(), [&](std::size_t i) {
        after(
            i, [&](float drho) { return setup_.state_equation.pressure(setup_.rho0, drho); },
            [&](std::size_t k, const V3<double>& u) { return leaving(k, u); });
    });
    each_effect(t, [](Effect& effect, const StepView& view) { effect.change_pressure(view); });
    ghosts_.refresh(p, t, p.velocity_density, p.gradient_pressure, p.carried);
}

AfterFirstSweep Level::after_first_sweep(double compress, double drift) {
    Particles& p = particles_;
    const auto or_null = [](auto& field) { return field.empty() ? nullptr : field.data(); };
    return {.p = state_view(),
            .to_quanta = to_quanta(),
            .kind = p.kind.data(),
            .rate = p.rate.data(),
            .shift = p.shift_support.data(),
            .aired = or_null(p.aired),
            .place = p.place.data(),
            .motion = p.velocity_density.data(),
            .stress = p.gradient_pressure.data(),
            .wall = or_null(p.wall_normal),
            .compress = compress,
            .drift = drift,
            .surface_support = setup_.surface_support,
            .trend = or_null(p.trend),
            .compression = or_null(p.compression),
            .density_rate = or_null(p.density_rate)};
}

void Level::mark_surface() {
    const std::size_t n = particles_.size();
    const MarkBits mark{lacks_support(), ghosts_.links().data(), n, particles_.place.size(), particles_.surface.data()};
    for_particles(particles_.surface.size(), mark);
}

void Level::second_sweep(double t) {
    if (device_) {
        const Stopwatch watch(timers_.forces);
        timers_.evaluations += static_cast<std::int64_t>(particles_.size());
        put_walls(t);
        return device_->second_sweep(t);
    }
    if (!walls_.empty()) {
        const Stopwatch watch(timers_.walls);
        put_walls(t);
        for (const Walls::Part& part : walls_.parts()) {
            ExtrapolateData e = extrapolation();
            e.list = part.water.view();
            e.at = walls_.places().data() + part.first;
            e.p = walls_.pressures().data() + part.first;
            if (walls_.accelerations()) e.acceleration = walls_.accelerations() + part.first;
            for_pairs(passes_, e, part.near_water);
        }
        walls_.halo().tell(walls_.pressures().data());
    }
    {
        const Stopwatch watch(timers_.forces);
        for_pairs(passes_, second_sweep_data(t), groups_);
    }
    {
        const Stopwatch watch(timers_.effects);
        each_effect(t, [](Effect& effect, const StepView& view) { effect.add_rates(view); });
    }
    timers_.evaluations += static_cast<std::int64_t>(particles_.size() - copies());
}

void Level::put_walls(double t) {
    wall_speed_ = walls_.fastest();
    walls_.follow(quanta_);
    if (around_.frame && !walls_.empty()) walls_.feel(around_.force(t), around_.gravity);
}

StepView Level::step_view(double t) { return device_ ? device_->step_view(t) : step_view_here(t); }

StepView Level::step_view_here(double t) {
    Particles& p = particles_;
    StepView view{.around = around_,
                  .level = setup_,
                  .n = p.size(),
                  .images = ghosts_.count(),
                  .p = state_view(),
                  .kind = p.kind.data(),
                  .aired = p.aired.data(),
                  .shift = p.shift_support.data(),
                  .water = water_view(),
                  .dummies = {},
                  .stress = p.gradient_pressure.data(),
                  .rate = p.rate.data(),
                  .passes = passes_,
                  .groups = groups_,
                  .bodies = {},
                  .dummy_count = walls_.size(),
                  .sliding = walls_.sliding().empty() ? nullptr : walls_.sliding().data(),
                  .wall_load_count = walls_.group_load_count(),
                  .links = ghosts_.links().data(),
                  .maps = ghosts_.maps().data(),
                  .ranks = ranks(),
                  .halo = halo_,
                  .dummies_halo = walls_.halo(),
                  .h = h_,
                  .mass = mass_,
                  .time = t};
    if (walls_.empty()) return view;
    view.dummies = wall_view();
    for (const Walls::Part& part : walls_.parts())
        view.bodies.push_back({part.first, part.water.view(), part.near_water});
    return view;
}

void Level::gather_loads(const Vec3& moment_reference) {
    const auto arm = [&](const Group& g) {
        if (device_)
            return Vec3(device_->centre_of_group(static_cast<std::size_t>(&g - groups_.data())) - moment_reference);
        const auto i = static_cast<std::size_t>(g.first);
        return Vec3(Vec3(quanta_.metres(g.x, 0, particles_.x[i]), quanta_.metres(g.y, 1, particles_.y[i]),
                         quanta_.metres(g.z, 2, particles_.z[i])) -
                    moment_reference);
    };
    const std::size_t n = bodies_.size();
    std::vector<PushSum> sums(3 * n);
    const std::span<PushSum> pressed(sums.data(), n), rubbed(sums.data() + n, n), of_bodies(sums.data() + 2 * n, n);
    add_group_loads(groups_, walls_.group_loads(), arm, pressed);
    for (const auto& effect : effects_)
        if (!effect->wall_loads().empty()) add_group_loads(groups_, effect->wall_loads(), arm, rubbed);
    if (walls_.press()) {
        const WallPushes pushed = push_particles();
        std::vector<WallPush> own;
        std::vector<std::int32_t> columns;
        for (std::size_t k = 0; k < pushed.pushes.size(); ++k) {
            const auto by = static_cast<std::size_t>(pushed.by[k]);
            if (owns(by)) own.push_back(pushed.pushes[k]), columns.push_back(column_of(by));
        }
        for (const WallPush& p : own) of_bodies[p.body].add(p.force, p.place - moment_reference);
        walls_.set_pushes(of_all_ranks(own, columns));
    }
    if (ranks().many() && all_fixed(bodies_) && schedule_.stages().empty()) {
        waiting_loads_ = std::move(sums);  // nobody asks for them before the step's end
        return;
    }
    ranks().add(std::span(sums));
    set_loads(sums, moment_reference);
}

/// By bodies that press.
WallPushes Level::push_particles() {
    std::vector<std::int32_t> near;
    const MayBePressed may_be{particles_.wall_normal.data(), particles_.kind.data(), setup_.dp};
    if (device_)
        near = device_->bring_pressed_home(may_be);
    else
        for (std::size_t i = 0; i < particles_.size(); ++i)
            if (may_be(i)) near.push_back(static_cast<std::int32_t>(i));
    WallPushes pushed = wall_pushes(bodies_, particles_, near, setup_.dp, mass_);
    if (device_) {
        device_->push(pushed.by, pushed.accelerations);
        return pushed;
    }
    const AddPushes add{pushed.by.data(), pushed.accelerations.data(), particles_.rate.data()};
    for (std::size_t k = 0; k < pushed.by.size(); ++k) add(k);
    return pushed;
}

/// The force of the pressure that the particles do not carry.
void Level::add_archimedes(std::size_t b, const Vec3& moment_reference, Load& load) const {
    const Surroundings::Submerged& solid = around_.submerged[b];
    const Vec3 centroid = bodies_[b]->now(solid.centroid);
    if (centroid.z() + solid.radius > around_.at_rest->bottom)
        throw RunError(
            fmt::format("{} came within {:.4g} m of still water at t = {:.6g} s, where the particles carry the whole "
                        "pressure; what "
                        "comes then is not solved with [effects] dynamic_pressure = \"on\": end the run before it, or "
                        "set it to \"off\"",
                        bodies_[b]->name(), around_.at_rest->surface - centroid.z() - solid.radius, time_));
    const Vec3 up(0, 0, around_.at_rest->weight * solid.volume);
    load.force += up;
    load.moment += (centroid - moment_reference).cross(up);
}

void Level::set_loads(std::span<const PushSum> sums, const Vec3& moment_reference) {
    const std::size_t n = bodies_.size();
    const auto pressed = sums.first(n), rubbed = sums.subspan(n, n), of_bodies = sums.last(n);
    // force on the bodies = minus what they exert on the water
    std::vector<Load> loads(n);
    for (std::size_t b = 0; b < n; ++b) {
        loads[b].friction = -mass_ * rubbed[b].push.value();
        loads[b].force = of_bodies[b].push.value() - mass_ * pressed[b].push.value() + loads[b].friction;
        PushSum by_walls = pressed[b];
        by_walls += rubbed[b];
        loads[b].moment = of_bodies[b].turn.value() - mass_ * by_walls.turn.value();
        if (around_.at_rest) add_archimedes(b, moment_reference, loads[b]);
    }
    walls_.set_loads(std::move(loads));
}

// --- state ----------------------------------------------------------------------------------------------------------

std::int64_t Level::live_pairs(const Group& g) const {
    std::int64_t live = 0;
    const auto count = [&](const Lists& lists, const ListRef& list) {
        const NeighbourBlock* blocks = lists.blocks(list);
        for (std::int32_t k = 0; k < list.size; ++k) live += std::popcount(blocks[k].live);
    };
    count(lists_.view(), g.list);
    count(walls_.lists(), g.wall_list);
    return live;
}

KindCounts Level::kinds() const {
    KindCounts counts;
    CountKinds kinds{particles_.kind.data(), particles_.x.data(), -infinite, infinite, &counts};
    if (around_.stream) kinds.first = around_.domain.min.x(), kinds.last = around_.domain.max.x();
    if (device_) return device_->count(kinds);
    for (std::size_t i = 0; i < particles_.size(); ++i)
        if (owns(i)) kinds(i, [](int* count) { ++*count; });
    return ranks().sum(counts);
}

double Level::visited_per_particle() const {
    if (device_) return double(device_->live_pairs()) / double(particles_.size());
    double pairs = 0;
    for (const Group& g : groups_) pairs += double(live_pairs(g) * g.size);
    return pairs / double(particles_.size());
}

double Level::bytes() const {
    double sum = double(lists_.bytes() + walls_.bytes() + ghosts_.bytes() + particles_.bytes());
    const auto add = [&](const auto& v) { sum += double(v.capacity() * sizeof(v[0])); };
    add(groups_);
    sum +=
        double(stages_.start.bytes() + stages_.mean.bytes() + stages_.compression.bytes() + stages_.diffusion.bytes());
    for (const auto& effect : effects_) sum += double(effect->bytes());
    sum += bytes_on_device();
    return sum;
}

Level::State Level::state() const { return {time_, dt_, steps_, ledger_, extremes_}; }

void Level::restore(const State& s, Particles particles) {
    time_ = s.time, dt_ = s.dt, steps_ = s.steps;
    ledger_ = s.ledger, extremes_ = s.extremes;
    particles.bring_all_of(particles_);  // what is not saved is made anew where it is asked for
    particles_ = std::move(particles);
    begin_whole();
    if (device_) device_->note_changed_state();
    start_anew();
}

FieldsToSet Level::fields_to_set() {
    home();
    if (device_) device_->note_changed_state();
    return FieldsToSet(particles_);
}

void Level::take_out(std::vector<std::int64_t> ids, std::int64_t active) {
    ledger_.out += active;
    home();
    if (device_) device_->note_changed_state();
    std::ranges::sort(ids);
    std::vector<int> gone(particles_.size());
    for_particles(gone.size(), [&](std::size_t i) { gone[i] = std::ranges::binary_search(ids, particles_.id[i]); });
    let_go(gone);
    total_ -= static_cast<std::int64_t>(ids.size());
    start_anew();
}

void Level::mark_restart_point() {
    if (!particles_.has(With::finer)) return make_lists_due();
    home();  // a finer level has changed velocities since the last step: the lists reach as far as after a restart
    start_anew();
}

void Level::start_anew() {
    const double stream = stream_velocity(time_);
    life_.relative_speed = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i)
        life_.relative_speed =
            std::max(life_.relative_speed,
                     Vec3(particles_.u[i] - stream, double(particles_.v[i]), double(particles_.w[i])).norm());
    life_.relative_speed = ranks().largest(life_.relative_speed);
    make_lists_due();
}

std::string Level::text_of_failure(std::size_t i, const std::string& what) const {
    const Particles& p = particles_;
    return fmt::format("{} particle {} at t = {:.6g} s (step {}) near ({:.4g}, {:.4g}, {:.4g}) m, |u| = {:.4g} m/s, {}",
                       setup_.material, p.id[i], time_, steps_, p.x[i], p.y[i], p.z[i],
                       std::sqrt(double(p.u[i]) * p.u[i] + double(p.v[i]) * p.v[i] + double(p.w[i]) * p.w[i]), what);
}

}  // namespace tw
