#include "sph_solver/solver.h"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/core/run_pass.h"
#include "sph_solver/core/stopwatch.h"

namespace tw {

namespace {

constexpr double held_at_wall_over_dp = 0.1;  ///< nearer than this a particle is not let towards a wall
constexpr double acceleration_limit = 0.45;   ///< dt < this times sqrt(h / a)

/// Particle ranges of fixed length: partial sums over them, added in order, do not depend on the number of threads.
constexpr std::size_t chunk = 4096;
std::size_t chunks(std::size_t n) { return (n + chunk - 1) / chunk; }

}  // namespace

Solver::Solver(SolverSetup setup, const Fluid& fluid)
    : setup_(std::move(setup)), passes_(&passes()), effects_(make_effects(setup_.effects)) {
    const SolverSetup& s = setup_;
    if (s.threads > 0) omp_set_num_threads(s.threads);
    h_ = s.h_over_dp * s.dp;
    kernel_ = Kernel(h_, s.dimensions);
    mass_ = s.rho0 * std::pow(s.dp, s.dimensions);
    quanta_.size = s.dp / (1 << 18);
    quanta_.origin = (s.domain.min + s.domain.max) / 2;
    if (s.dimensions == 2) quanta_.origin.y() = 0;
    if (s.domain.size().maxCoeff() > quanta_.reach())
        throw InputError(fmt::format("the domain is {:.3g} spacings long; at most 8000 are possible in one run",
                                     s.domain.size().maxCoeff() / s.dp));
    Box area = s.domain;
    const double margin = kernel_.support() + s.dp;
    area.min.array() -= margin;
    area.max.array() += margin;
    if (s.stream) {
        area.min.x() -= s.stream->buffer;
        area.max.x() += s.stream->buffer;
    }
    grid_ = ColumnGrid(area, s.dp, s.dimensions, quanta_);

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

void Solver::evaluate() {
    if (rebuild_due_) rebuild();
    const SolverSetup& s = setup_;
    {
        const Stopwatch watch(timers_.update);
        update_records();
    }
    PassData d;
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
    d.diffusion = static_cast<float>(s.delta * h_ * s.state_equation.c0);
    d.viscosity = static_cast<float>(s.alpha * h_ * s.state_equation.c0 * s.rho0);
    d.eta2 = static_cast<float>(0.01 * h_ * h_);
    const double stream_acceleration = s.stream ? s.stream->acceleration(time_) : 0;
    d.gx = static_cast<float>(s.gravity.x() + stream_acceleration);
    d.gy = static_cast<float>(s.gravity.y());
    d.gz = static_cast<float>(s.gravity.z());
    d.inv_void = static_cast<float>(1 / (1 - s.touch_support));
    d.two_dimensional = s.dimensions == 2;
    if (s.tension_control) d.tension_control_from = static_cast<float>(s.shifting_support);
    {
        const Stopwatch watch(timers_.gradient);
        run_pass(passes_->continuity_and_gradient, d, groups_);
    }
    const StepView view{
        setup_, particles_, d,    *passes_, groups_, live_wall_groups_, images_, wall_place_.size(), wall_load_.size(),
        h_,     mass_,      time_};
    {
        const Stopwatch watch(timers_.update);
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            float& drho = particles_.drho[i];
            if (particles_.kind[i] == Kind::fluid) drho += static_cast<float>(dt_ * rate_[i].drho);
            surface_[i] = shift_[i].support < s.surface_support ? 1.0f : 0.0f;
            // the free surface bears no tension (its density is not let below rho0)
            if (particles_.kind[i] == Kind::fluid && surface_[i] > 0 && drho < 0) drho = 0;
            motion_[i].drho = drho;
            stress_[i].p = s.state_equation.pressure(s.rho0, drho);
        }
        for (const auto& effect : effects_) effect->change_pressure(view);
        update_mirror_images(true);
    }
    if (!live_wall_groups_.empty()) {
        const Stopwatch watch(timers_.walls);
        ExtrapolateData e = extrapolation();
        e.at = wall_place_.data();
        e.p = wall_p_.data();
        run_pass(passes_->extrapolate, e, live_wall_groups_);
    }
    {
        const Stopwatch watch(timers_.forces);
        run_pass(passes_->forces, d, groups_);
    }
    {
        const Stopwatch watch(timers_.effects);
        for (const auto& effect : effects_) effect->add_rates(view);
    }
    timers_.evaluations += static_cast<std::int64_t>(particles_.size());
    timers_.pair_candidates += lists_.candidates() + wall_lists_.candidates();
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
            const Vec3 centre = quanta_.origin + quanta_.size * Vec3(g.x, g.y, g.z);
            sum += force;
            load_.moment += (centre - setup_.moment_reference).cross(force) - mass_ * Vec3(w.mx, w.my, w.mz);
        }
        return sum;
    };
    load_.force = gather(wall_load_);
    for (const auto& effect : effects_)
        if (!effect->wall_loads().empty()) load_.friction += gather(effect->wall_loads());
    load_.force += load_.friction;
}

/// The last resort at a wall: a particle so near that no pressure can stop it in time loses its velocity towards the
/// wall (a plastic impact; the wall gets the impulse, which is returned [N s]), and is put back on the surface if this
/// step took it through. The distance carried along is checked against the surface first.
std::optional<Vec3> Solver::hold_at_wall(std::size_t i) {
    Particles& p = particles_;
    NormalRecord& r = normal_[i];
    if (const NormalRecord found = nearest_wall(i, setup_.dp); found.distance < no_wall.distance)
        r = found;
    else
        r.distance = static_cast<float>(setup_.dp);
    const double approach = double(p.u[i]) * r.x + double(p.v[i]) * r.y + double(p.w[i]) * r.z;
    if (r.distance >= held_at_wall_over_dp * setup_.dp || approach >= 0) return {};
    if (r.distance < 0) {
        p.x[i] -= double(r.distance) * r.x;
        p.y[i] -= double(r.distance) * r.y;
        p.z[i] -= double(r.distance) * r.z;
        r.distance = 0;
    }
    const Vec3 before(p.u[i], p.v[i], p.w[i]);
    p.u[i] -= static_cast<float>(approach * r.x);
    p.v[i] -= static_cast<float>(approach * r.y);
    p.w[i] -= static_cast<float>(approach * r.z);
    return mass_ * (before - Vec3(p.u[i], p.v[i], p.w[i]));
}

void Solver::integrate() {
    const Stopwatch watch(timers_.update);
    const SolverSetup& s = setup_;
    Particles& p = particles_;
    const double c0 = s.state_equation.c0;
    const double speed = std::max(extremes_.speed, s.stream ? s.stream->velocity(time_) : 0.0);
    dt_ = s.cfl * h_ / (c0 + speed);
    if (extremes_.acceleration > 0) dt_ = std::min(dt_, acceleration_limit * std::sqrt(h_ / extremes_.acceleration));
    if (s.alpha > 0) dt_ = std::min(dt_, 0.25 * h_ * h_ / (s.alpha * h_ * c0));
    for (const auto& effect : effects_) dt_ = std::min(dt_, effect->largest_step(s, h_));
    const double dt = dt_, stream_before = s.stream ? s.stream->velocity(time_) : 0,
                 stream_after = s.stream ? s.stream->velocity(time_ + dt) : 0;
    const double shift_scale = -s.shifting * dt * std::max(speed, 1e-30) * h_, shift_cap = 0.05 * s.dp;

    struct Part {
        double speed2 = 0, acceleration2 = 0, relative2 = 0, shift2 = 0, low = 0, high = 0;
        std::size_t fastest = 0, densest = 0, thinnest = 0;
        Vec3 crossed = Vec3::Zero();
        Vec3 impulse = Vec3::Zero(),
             turn = Vec3::Zero();  // given to the solids by particles held at a wall [N s, N m s]
        std::int64_t held = 0;
        bool broken = false;
    };
    std::vector<Part> parts(chunks(p.size()));
#pragma omp parallel for schedule(static)
    for (std::size_t c = 0; c < parts.size(); ++c) {
        Part& part = parts[c];
        for (std::size_t i = c * chunk; i < std::min(p.size(), (c + 1) * chunk); ++i) {
            const bool was_inside = control_ && control_->inside(p.x[i], p.y[i], p.z[i]);
            const double u0 = p.u[i], v0 = p.v[i], w0 = p.w[i];
            Vec3 shift = Vec3::Zero();
            switch (p.kind[i]) {
                case Kind::fluid: {
                    const RateRecord& r = rate_[i];
                    part.acceleration2 =
                        std::max(part.acceleration2, double(r.ax) * r.ax + double(r.ay) * r.ay + double(r.az) * r.az);
                    p.u[i] = static_cast<float>(u0 + dt * r.ax);
                    p.v[i] = static_cast<float>(v0 + dt * r.ay);
                    p.w[i] = static_cast<float>(w0 + dt * r.az);
                    p.drho[i] = static_cast<float>(p.drho[i] + dt * r.drho);
                    if (s.shifting > 0 && shift_[i].support > s.shifting_support) {
                        shift = shift_scale * Vec3(shift_[i].x, shift_[i].y, shift_[i].z);
                        const double length = shift.norm();
                        if (length > shift_cap) shift *= shift_cap / length;
                        part.shift2 = std::max(part.shift2, shift.squaredNorm());
                    }
                    break;
                }
                case Kind::inlet: p.u[i] = static_cast<float>(stream_after); break;
                case Kind::outlet: p.u[i] = static_cast<float>(u0 + (stream_after - stream_before)); break;
            }
            p.x[i] += dt * double(p.u[i]) + shift.x();
            p.y[i] += dt * double(p.v[i]) + shift.y();
            p.z[i] += dt * double(p.w[i]) + shift.z();
            if (!normal_.empty() && p.kind[i] == Kind::fluid) {
                NormalRecord& r = normal_[i];
                const double approach = double(p.u[i]) * r.x + double(p.v[i]) * r.y + double(p.w[i]) * r.z;
                r.distance += static_cast<float>(dt * approach + shift.x() * r.x + shift.y() * r.y + shift.z() * r.z);
                const bool too_near = r.distance < held_at_wall_over_dp * s.dp;
                if (const auto impulse = too_near ? hold_at_wall(i) : std::nullopt) {
                    ++part.held;
                    part.impulse += *impulse;
                    part.turn += (Vec3(p.x[i], p.y[i], p.z[i]) - s.moment_reference).cross(*impulse);
                }
            }
            const double u = p.u[i], v = p.v[i], w = p.w[i], speed2 = u * u + v * v + w * w;
            if (speed2 > part.speed2) part.speed2 = speed2, part.fastest = i;
            part.relative2 = std::max(part.relative2, (u - stream_after) * (u - stream_after) + v * v + w * w);
            if (p.drho[i] < part.low) part.low = double(p.drho[i]), part.thinnest = i;
            if (p.drho[i] > part.high) part.high = double(p.drho[i]), part.densest = i;
            if (!std::isfinite(speed2 + p.drho[i] + p.x[i] + p.y[i] + p.z[i])) part.broken = true, part.fastest = i;
            if (control_) {
                // momentum of what crosses a face, with the velocity in the middle of the step
                const int crossing = int(control_->inside(p.x[i], p.y[i], p.z[i])) - int(was_inside);
                if (crossing) part.crossed += crossing * mass_ * Vec3((u0 + u) / 2, (v0 + v) / 2, (w0 + w) / 2);
            }
            if (part.broken) break;
        }
    }
    extremes_ = {};
    double relative2 = 0, speed2 = 0, shift2 = 0;
    std::size_t fastest = 0;
    Vec3 crossed = Vec3::Zero();
    for (const Part& part : parts) {
        if (part.broken)
            fail_at(part.fastest,
                    "has a velocity, density or place that is not a number; often a time step or sound speed that does "
                    "not fit the flow");
        if (part.speed2 > speed2) speed2 = part.speed2, fastest = part.fastest;
        relative2 = std::max(relative2, part.relative2);
        shift2 = std::max(shift2, part.shift2);
        extremes_.acceleration = std::max(extremes_.acceleration, part.acceleration2);
        const auto place = [&](std::size_t i) { return Vec3(p.x[i], p.y[i], p.z[i]); };
        if (part.low < extremes_.density_deviation_low)
            extremes_.density_deviation_low = part.low, extremes_.thinnest_place = place(part.thinnest);
        if (part.high > extremes_.density_deviation_high)
            extremes_.density_deviation_high = part.high, extremes_.densest_place = place(part.densest);
        crossed += part.crossed;
        ledger_.held += part.held;
        load_.force += part.impulse / dt;
        load_.moment += part.turn / dt;
    }
    extremes_.speed = std::sqrt(speed2);
    extremes_.acceleration = std::sqrt(extremes_.acceleration);
    if (fastest < p.size()) {
        extremes_.fastest = p.id[fastest];
        extremes_.fastest_place = Vec3(p.x[fastest], p.y[fastest], p.z[fastest]);
    }
    if (control_) control_->add_crossed(crossed);
    // what moves with the stream stays beside its neighbours: the particle lists need only the motion relative to it
    const double shift_travel = std::sqrt(shift2);
    travel_in_stream_ += dt * std::sqrt(relative2) + shift_travel;
    travel_ += dt * extremes_.speed + shift_travel;
    time_ += dt;
    ++steps_;
    if (extremes_.speed > largest_mach * c0)
        fail_at(fastest, fmt::format("moves at {:.3g} m/s = {:.3g} c0; the sound speed is too low for this flow, or a "
                                     "wall was struck too hard",
                                     extremes_.speed, extremes_.speed / c0));
    check_bounds();
}

void Solver::check_bounds() {
    const double limit = largest_density_deviation * setup_.rho0;
    if (extremes_.density_deviation_high <= limit && extremes_.density_deviation_low >= -limit) return;
    for (std::size_t i = 0; i < particles_.size(); ++i)
        if (std::abs(particles_.drho[i]) > limit)
            fail_at(
                i, fmt::format("has the density {:.4g} kg/m3, more than {:.0f} % from {:.4g}; often a sound speed that "
                               "is too low or water caught between walls",
                               setup_.rho0 + double(particles_.drho[i]), 100 * largest_density_deviation, setup_.rho0));
}

void Solver::step() {
    const SolverSetup& s = setup_;
    // two particles may both have moved towards each other; walls stand still
    if (2 * travel_in_stream_ > skin_over_dp * s.dp || travel_ > wall_skin_over_dp * s.dp) rebuild_due_ = true;
    evaluate();
    gather_load();
    integrate();
}

void Solver::sample(PointSamples& points) {
    if (stress_.empty()) evaluate();
    const std::size_t n = points.places.size();
    points.p.assign(n, 0);
    points.support.assign(n, 0);
    if (points.want_flux) points.flux.assign(3 * n, 0);
    if (n == 0) return;
    std::vector<PlaceRecord> raw(n), sorted(n);
    for (std::size_t k = 0; k < n; ++k)
        raw[k] = {quanta_.of(points.places[k].x(), 0), quanta_.of(points.places[k].y(), 1),
                  quanta_.of(points.places[k].z(), 2), 0};
    std::vector<std::int32_t> order, start;
    sort_by_column(grid_, raw, 0, n, order, start);
    for (std::size_t k = 0; k < n; ++k) sorted[k] = raw[static_cast<std::size_t>(order[k])];
    std::vector<Group> groups;
    make_groups(sorted, start, 0, groups);
    NeighbourLists lists;
    const std::size_t particles = particles_.size();
    // the particles were sorted a few steps ago and have moved by up to the skin since: twice that keeps the search
    // complete
    const double reach = kernel_.support() + 2 * wall_skin_over_dp * setup_.dp;
    lists.build(
        grid_, quanta_, sorted.data(), groups,
        {{place_.data(), &start_, 0}, {place_.data() + particles, &image_start_, static_cast<std::int32_t>(particles)}},
        reach, false);
    std::vector<float> p(n), support(n), flux(points.want_flux ? 3 * n : 0);
    ExtrapolateData e = extrapolation();
    e.at = sorted.data();
    e.p = p.data();
    e.support = support.data();
    if (points.want_flux) {
        e.carried = carried_.data();
        e.flux = flux.data();
    }
    run_pass(passes_->extrapolate, e, groups);
    for (std::size_t k = 0; k < n; ++k) {
        const auto i = static_cast<std::size_t>(order[k]);
        points.p[i] = p[k];
        points.support[i] = support[k];
        for (std::size_t a = 0; a < 3 && points.want_flux; ++a) points.flux[3 * i + a] = flux[3 * k + a];
    }
}

double Solver::bytes() const {
    double sum = double(lists_.bytes() + wall_lists_.bytes() + wall_source_lists_.bytes());
    const auto add = [&](const auto& v) { sum += double(v.capacity() * sizeof(v[0])); };
    auto& p = const_cast<Particles&>(particles_);
    p.for_each_array(add);
    add(images_), add(place_), add(motion_), add(stress_), add(shift_), add(rate_), add(normal_), add(carried_),
        add(surface_), add(groups_), add(wall_load_);
    add(wall_place_), add(wall_p_), add(wall_groups_), add(live_wall_groups_);
    for (const auto& effect : effects_) sum += double(effect->bytes());
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
    rebuild_due_ = true;
}

void Solver::fail_at(std::size_t i, const std::string& what) const {
    const Particles& p = particles_;
    throw RunError(
        fmt::format("particle {} at t = {:.6g} s (step {}) near ({:.4g}, {:.4g}, {:.4g}) m, |u| = {:.4g} m/s, {}",
                    p.id[i], time_, steps_, p.x[i], p.y[i], p.z[i],
                    std::sqrt(double(p.u[i]) * p.u[i] + double(p.v[i]) * p.v[i] + double(p.w[i]) * p.w[i]), what));
}

}  // namespace tw
