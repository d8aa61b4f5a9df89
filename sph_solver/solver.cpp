#include "sph_solver/solver.h"

#include <omp.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/backend/run_pass.h"
#include "sph_solver/backend/stopwatch.h"

namespace tw {

Solver::Solver(SolverSetup setup, const Fluid& fluid)
    : setup_(std::move(setup)), passes_(&passes()), effects_(make_effects(setup_.effects)) {
    const SolverSetup& s = setup_;
    if (s.threads > 0) omp_set_num_threads(s.threads);
    h_ = s.h_over_dp * s.dp;
    kernel_ = Kernel(h_, s.dimensions);
    mass_ = s.rho0 * std::pow(s.dp, s.dimensions);
    Vec3 middle = (s.domain.min + s.domain.max) / 2;
    if (s.dimensions == 2) middle.y() = 0;
    quanta_ = Quanta(middle, s.dp / (1 << 18));
    Box area = s.domain;
    const double margin = kernel_.support() + s.dp;
    area.min.array() -= margin;
    area.max.array() += margin;
    if (s.stream) {
        area.min.x() -= s.stream->buffer;
        area.max.x() += s.stream->buffer;
    }
    mirror_planes_.emplace(s.domain, quanta_);
    grid_ = ColumnGrid(area, s.dp, s.dimensions, quanta_, passes_->lanes);

    particles_.for_each_array([&](auto& array) { array.reserve(fluid.places.size()); });
    for (std::size_t k = 0; k < fluid.places.size(); ++k) {
        const Vec3& p = fluid.places[k];
        const double depth_pressure = s.rho0 * s.gravity.norm() * fluid.depth[k];
        const Kind kind = s.stream && p.x() < s.domain.min.x()   ? Kind::inlet
                          : s.stream && p.x() > s.domain.max.x() ? Kind::outlet
                                                                 : Kind::fluid;
        particles_.add(p.x(), p.y(), p.z(), s.stream ? static_cast<float>(s.stream->velocity(0)) : 0.0f,
                       s.state_equation.deviation(s.rho0, depth_pressure), next_id_++, kind);
    }
    build_wall();
}

void Solver::add_air(const AirOptions& air, const Fluid& fluid) {
    if (setup_.scheme != Scheme::kick_drift_kick && setup_.scheme != Scheme::symplectic_euler)
        throw InputError(
            "air needs a time step of one evaluation: [sph] scheme \"kick_drift_kick\" or "
            "\"symplectic_euler\"");
    if (fluid.places.empty()) throw InputError("air: the water leaves no room for it in the domain");
    if (!setup_.mirrors.periodic[2]) setup_.mirrors.on[2][1] = true;
    setup_.surface_support = 0.6;  // of both phases: a void, not the water's surface
    air_ = std::make_unique<Solver>(air_setup(setup_, air), fluid);
}

ExtrapolateData Solver::extrapolation() const {
    ExtrapolateData e;
    e.place = place_.data();
    e.motion = motion_.data();
    e.stress = stress_.data();
    e.kernel = kernel_;
    e.quantum = static_cast<float>(quanta_.size);
    e.rho0 = static_cast<float>(setup_.rho0);
    e.gx = static_cast<float>(setup_.gravity.x());
    e.gy = static_cast<float>(setup_.gravity.y());
    e.gz = static_cast<float>(setup_.gravity.z());
    return e;
}

void Solver::prune(double drift) {
    const Stopwatch watch(timers_.lists);
    PruneData d;
    d.lists = lists_.view();
    d.of = place_.data();
    d.place = place_.data();
    d.reach = reach_among(drift) / quanta_.size;
    run_pass(passes_->prune, d, groups_);
    if (live_wall_groups_.empty()) return;
    d.reach = reach_to_walls(drift) / quanta_.size;
    d.lists = wall_source_lists_.view();
    d.of = wall_place_.data();
    run_pass(passes_->prune, d, live_wall_groups_);
    d.of = place_.data();
    d.place = wall_place_.data();
    d.lists = wall_lists_.view();
    d.list = &Group::wall_list;
    run_pass(passes_->prune, d, groups_);
}

PassData Solver::pass_data(double t) {
    const SolverSetup& s = setup_;
    PassData d;
    d.list = lists_.view();
    d.wall_list = wall_lists_.view();
    d.place = place_.data();
    d.motion = motion_.data();
    d.stress = stress_.data();
    d.wall_place = wall_place_.data();
    d.wall_p = wall_p_.data();
    d.normal = normal_.data();
    d.shift = shift_.data();
    d.rate = rate_.data();
    d.surface = surface_.data();
    d.wall_load = wall_load_.data();
    d.carried = carried_.empty() ? nullptr : carried_.data();
    d.kernel = kernel_;
    d.quantum = static_cast<float>(quanta_.size);
    d.rho0 = static_cast<float>(s.rho0);
    d.inv_mass = static_cast<float>(1 / mass_);
    d.inv_W_dp = static_cast<float>(1 / kernel_.W(s.dp));
    d.diffusion = static_cast<float>(s.delta * s.state_equation.c0);
    d.viscosity = static_cast<float>(s.alpha * s.state_equation.c0 * s.rho0 / 2);
    const double stream_acceleration = s.stream ? s.stream->acceleration(t) : 0;
    d.gx = static_cast<float>(s.gravity.x() + stream_acceleration);
    d.gy = static_cast<float>(s.gravity.y());
    d.gz = static_cast<float>(s.gravity.z());
    d.inv_void = static_cast<float>(1 / (1 - s.touch_support));
    d.two_dimensional = s.dimensions == 2;
    if (s.tension_control) d.tension_control_from = static_cast<float>(s.shifting_support);
    return d;
}

void Solver::evaluate(double t, double compress, double drift) {
    if (!air_) {
        prepare(drift);
        first_sweep(t, compress, drift);
        second_sweep(t);
        return;
    }
    const bool lists_due = rebuild_due_ || air_->rebuild_due_;
    rebuild_due_ = air_->rebuild_due_ = lists_due;
    prepare(drift);
    air_->prepare(drift);
    if (lists_due) {
        const PassData water = pass_data(t), air = air_->pass_data(t);
        const PhaseView of_water{water, groups_, particles_.size(), start_, image_start_},
            of_air{air, air_->groups_, air_->particles_.size(), air_->start_, air_->image_start_};
        const double reach = kernel_.support() + wall_skin_over_dp * setup_.dp;
        of_water_.find_neighbours(*passes_, grid_, quanta_, of_water, of_air, reach);
        of_air_.find_neighbours(*passes_, grid_, quanta_, of_air, of_water, reach);
    }
    of_water_.meet(*passes_, pass_data(t), air_->pass_data(t));
    of_air_.meet(*passes_, air_->pass_data(t), pass_data(t));
    other_ = of_water_.sums(), air_->other_ = of_air_.sums();
    first_sweep(t, compress, drift);
    air_->first_sweep(t, compress, drift);
    second_sweep(t);
    air_->second_sweep(t);
    of_water_.press(*passes_, pass_data(t), air_->pass_data(t));
    of_air_.press(*passes_, air_->pass_data(t), pass_data(t));
}

void Solver::prepare(double drift) {
    if (rebuild_due_) return rebuild(drift);
    {
        const Stopwatch watch(timers_.update);
        update_records();
    }
    prune(drift);
}

void Solver::first_sweep(double t, double compress, double drift) {
    const SolverSetup& s = setup_;
    PassData d = pass_data(t);
    d.other = other_;
    {
        const Stopwatch watch(timers_.gradient);
        run_pass(passes_->continuity_and_gradient, d, groups_);
    }
    const Stopwatch watch(timers_.update);
    mark_surface();
    for (std::size_t i = 0; i < stages_.compression.size(); ++i) stages_.compression[i] = rate_[i].drho;
    Particles& p = particles_;
    // walls are looked after at the end of the step
    const auto drift_freely = [&](std::size_t i) {
        p.x[i] += drift * double(p.u[i]);
        p.y[i] += drift * double(p.v[i]);
        p.z[i] += drift * double(p.w[i]);
        place_[i] = place_record(i);
        if (normal_.empty()) return;
        WallNormalRecord& r = normal_[i];
        r.distance += static_cast<float>(drift * (double(p.u[i]) * r.x + double(p.v[i]) * r.y + double(p.w[i]) * r.z));
    };
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < p.size(); ++i) {
        float& drho = p.drho[i];
        if (p.kind[i] == Kind::fluid) drho += static_cast<float>(compress * rate_[i].drho);
        // the free surface bears no tension (its density is not let below rho0)
        if (p.kind[i] == Kind::fluid && drho < 0 && lacks_support(i)) drho = 0;
        motion_[i].drho = drho;
        stress_[i].p = s.state_equation.pressure(s.rho0, drho);
        if (drift > 0) drift_freely(i);
    }
    const StepView view = step_view(d, t);
    for (const auto& effect : effects_) effect->change_pressure(view);
    update_mirror_images(true);
}

void Solver::mark_surface() {
    const std::size_t n = particles_.size(), all = place_.size();
#pragma omp parallel for schedule(static)
    for (std::size_t word = 0; word < surface_.size(); ++word) {
        std::uint32_t bits = 0;
        for (std::size_t i = 32 * word; i < std::min(all, 32 * word + 32); ++i)
            bits |= std::uint32_t{lacks_support(i < n ? i : static_cast<std::size_t>(images_[i - n].source))}
                    << (i % 32);
        surface_[word] = bits;
    }
}

void Solver::second_sweep(double t) {
    if (!live_wall_groups_.empty()) {
        const Stopwatch watch(timers_.walls);
        ExtrapolateData e = extrapolation();
        e.list = wall_source_lists_.view();
        e.at = wall_place_.data();
        e.p = wall_p_.data();
        run_pass(passes_->extrapolate, e, live_wall_groups_);
    }
    const PassData d = pass_data(t);
    {
        const Stopwatch watch(timers_.forces);
        run_pass(passes_->forces, d, groups_);
    }
    {
        const Stopwatch watch(timers_.effects);
        const StepView view = step_view(d, t);
        for (const auto& effect : effects_) effect->add_rates(view);
    }
    timers_.evaluations += static_cast<std::int64_t>(particles_.size());
}

StepView Solver::step_view(const PassData& d, double t) const {
    return {setup_,
            particles_,
            d,
            *passes_,
            groups_,
            live_wall_groups_,
            wall_source_lists_.view(),
            images_,
            wall_motion_,
            wall_place_.size(),
            wall_load_.size(),
            h_,
            mass_,
            t};
}

void Solver::gather_load() {
    // force on the solids = minus what they exert on the water, group by group in a fixed order
    load_ = {};
    const auto gather = [&](const std::vector<WallLoad>& loads) {
        Vec3 sum = Vec3::Zero();
        for (const Group& g : groups_) {
            if (g.wall_load < 0) continue;
            const WallLoad& w = loads[static_cast<std::size_t>(g.wall_load)];
            const Vec3 force = -mass_ * Vec3(w.ax, w.ay, w.az);
            const auto i = static_cast<std::size_t>(g.first);
            const Vec3 centre(quanta_.metres(g.x, 0, particles_.x[i]), quanta_.metres(g.y, 1, particles_.y[i]),
                              quanta_.metres(g.z, 2, particles_.z[i]));
            sum += force;
            load_.moment += (centre - setup_.moment_reference).cross(force) - mass_ * Vec3(w.mx, w.my, w.mz);
        }
        return sum;
    };
    load_.force = gather(wall_load_);
    for (const auto& effect : effects_)
        if (!effect->wall_loads().empty()) load_.friction += gather(effect->wall_loads());
    load_.force += load_.friction;
    if (air_) air_->gather_load();
}

void Solver::sample(PointSamples& points) {
    if (stress_.empty()) evaluate(time_, 0);
    const std::size_t n = points.places.size();
    points.p.assign(n, 0);
    points.support.assign(n, 0);
    if (points.want_flux) points.flux.assign(3 * n, 0);
    if (n == 0) return;
    std::vector<WidePlace> raw(n);
    std::vector<PlaceRecord> places(n);
    for (std::size_t k = 0; k < n; ++k) raw[k] = quanta_.wide(points.places[k]);
    std::vector<std::int32_t> order, start;
    sort_by_column(grid_, raw, order, start);
    for (std::size_t k = 0; k < n; ++k) places[k] = raw[static_cast<std::size_t>(order[k])].record(0);
    const Source sorted{places.data(), &start, 0};
    std::vector<Group> groups;
    make_groups(grid_, sorted, passes_->lanes, groups);
    std::vector<float> p(n), support(n), flux(points.want_flux ? 3 * n : 0);
    extrapolate_to(sorted, groups, p, support, points.want_flux ? flux.data() : nullptr);
    if (air_) {
        std::vector<float> p_air(n), support_air(n);
        air_->extrapolate_to(sorted, groups, p_air, support_air, nullptr);
        const float lid = static_cast<float>(air_->lid_pressure());
        for (std::size_t k = 0; k < n; ++k)
            if (const float both = support[k] + support_air[k]; both > 0)
                p[k] = (p[k] * support[k] + p_air[k] * support_air[k]) / both - lid;
    }
    for (std::size_t k = 0; k < n; ++k) {
        const auto i = static_cast<std::size_t>(order[k]);
        points.p[i] = p[k];
        points.support[i] = support[k];
        for (std::size_t a = 0; a < 3 && points.want_flux; ++a) points.flux[3 * i + a] = flux[3 * k + a];
    }
}

double Solver::lid_pressure() const {
    double sum = 0;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i)
        if (particles_.z[i] > setup_.domain.max.z() - kernel_.support()) sum += pressure(i), ++count;
    return count > 0 ? sum / double(count) : 0;
}

void Solver::extrapolate_to(const Source& sorted, std::vector<Group>& groups, std::vector<float>& p,
                            std::vector<float>& support, float* flux) const {
    NeighbourLists lists;
    const std::size_t particles = particles_.size();
    // the particles were sorted a few steps ago and have moved by up to the skin since: twice that keeps the search
    // complete
    const double reach = kernel_.support() + 2 * wall_skin_over_dp * setup_.dp;
    lists.build(
        *passes_, grid_, quanta_, sorted, groups,
        {{place_.data(), &start_, 0}, {place_.data() + particles, &image_start_, static_cast<std::int32_t>(particles)}},
        {reach, reach, reach});
    ExtrapolateData e = extrapolation();
    e.list = lists.view();
    e.at = sorted.places;
    e.p = p.data();
    e.support = support.data();
    if (flux) {
        e.carried = carried_.data();
        e.flux = flux;
    }
    run_pass(passes_->extrapolate, e, groups);
}

double Solver::visited_per_particle() const {
    double pairs = 0;
    for (const Group& g : groups_) {
        std::int64_t live = 0;
        for (std::int32_t k = 0; k < g.list.size; ++k) live += std::popcount(lists_.view().blocks(g.list)[k].live);
        for (std::int32_t k = 0; k < g.wall_list.size; ++k)
            live += std::popcount(wall_lists_.view().blocks(g.wall_list)[k].live);
        pairs += double(live * g.size);
    }
    return pairs / double(particles_.size());
}

double Solver::bytes() const {
    double sum = double(lists_.bytes() + wall_lists_.bytes() + wall_source_lists_.bytes());
    const auto add = [&](const auto& v) { sum += double(v.capacity() * sizeof(v[0])); };
    auto& p = const_cast<Particles&>(particles_);
    p.for_each_array(add);
    add(images_), add(place_), add(motion_), add(stress_), add(shift_), add(rate_), add(normal_), add(carried_),
        add(surface_), add(groups_), add(wall_load_);
    add(stages_.start), add(stages_.mean), add(stages_.compression), add(stages_.diffusion);
    add(wall_place_), add(wall_p_), add(wall_groups_), add(live_wall_groups_);
    for (const auto& effect : effects_) sum += double(effect->bytes());
    if (air_) sum += air_->bytes() + double(of_water_.bytes() + of_air_.bytes());
    return sum;
}

Solver::Restart Solver::restart_state() const {
    Restart r{time_, dt_, steps_, ledger_, extremes_, next_id_, {}};
    if (control_) r.control = control_->state();
    return r;
}

void Solver::restore(const Restart& r, Particles particles) {
    time_ = r.time, dt_ = r.dt, steps_ = r.steps;
    ledger_ = r.ledger, extremes_ = r.extremes, next_id_ = r.next_id;
    if (control_) control_->set_state(r.control);
    particles_ = std::move(particles);
    const double stream = setup_.stream ? setup_.stream->velocity(time_) : 0;
    relative_speed_ = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i)
        relative_speed_ = std::max(
            relative_speed_, Vec3(particles_.u[i] - stream, double(particles_.v[i]), double(particles_.w[i])).norm());
    rebuild_due_ = true;
}

void Solver::fail_at(std::size_t i, const std::string& what) const {
    const Particles& p = particles_;
    throw RunError(fmt::format("{} {} at t = {:.6g} s (step {}) near ({:.4g}, {:.4g}, {:.4g}) m, |u| = {:.4g} m/s, {}",
                               setup_.name, p.id[i], time_, steps_, p.x[i], p.y[i], p.z[i],
                               std::sqrt(double(p.u[i]) * p.u[i] + double(p.v[i]) * p.v[i] + double(p.w[i]) * p.w[i]),
                               what));
}

}  // namespace tw
