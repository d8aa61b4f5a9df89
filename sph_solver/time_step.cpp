// The time step. Every scheme is made of the same parts: evaluate (the two sweeps over the pairs, solver.cpp), and
// move, which ends the step for every particle, walls included.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sph_solver/backend/stopwatch.h"
#include "sph_solver/solver.h"

namespace tw {

namespace {

constexpr double held_at_wall_over_dp = 0.1;  ///< nearer than this a particle is not let towards a wall
constexpr double acceleration_limit = 0.45;   ///< dt < this times sqrt(h / a)

/// Particle ranges of fixed length: partial sums over them, added in order, do not depend on the number of threads.
constexpr std::size_t chunk = 4096;
std::size_t chunks(std::size_t n) { return (n + chunk - 1) / chunk; }

/// So far a scheme's sweeps look ahead of the places between two steps, in steps: the lists must hold there too.
double looks_ahead(Scheme scheme) {
    switch (scheme) {
        case Scheme::symplectic_euler: return 0;
        case Scheme::kick_drift_kick:
        case Scheme::predictor_corrector: return 0.5;
        case Scheme::rk4_frozen_diffusion: return 1;
    }
    return 1;
}

}  // namespace

void Solver::step() {
    const SolverSetup& s = setup_;
    if (lists_outlived()) rebuild_due_ = true;
    switch (s.scheme) {
        case Scheme::symplectic_euler: return step_symplectic_euler();
        case Scheme::kick_drift_kick: return step_kick_drift_kick();
        case Scheme::predictor_corrector: {
            static constexpr Stage midpoint[] = {{0, 0}, {1. / 2, 1}};
            return step_in_stages(midpoint, false);
        }
        case Scheme::rk4_frozen_diffusion: {
            static constexpr Stage classical[] = {{0, 1. / 6}, {1. / 2, 1. / 3}, {1. / 2, 1. / 3}, {1, 1. / 6}};
            return step_in_stages(classical, true);
        }
    }
}

double Solver::travel_ahead() const { return travel_ + looks_ahead(setup_.scheme) * dt_ * extremes_.speed; }

bool Solver::lists_outlived() const {
    const double relative = travel_in_stream_ + looks_ahead(setup_.scheme) * dt_ * relative_speed_;
    const double skin = skin_over_dp * setup_.dp, wall_skin = wall_skin_over_dp * setup_.dp;
    // two particles may both have moved towards each other; walls stand still
    if (2 * relative > skin || travel_ahead() > wall_skin) return true;
    // across the interface both move
    return air_ && (air_->lists_outlived() || travel_ahead() + air_->travel_ahead() > wall_skin);
}

/// rho -= dt' rho div u at (x, u), dt' the step before;   u += dt a(x, rho);   rho += dt D;   x += dt u
void Solver::step_symplectic_euler() {
    evaluate(time_, dt_);
    gather_load();
    choose_time_step();
    move_all(dt_, 0, dt_);
}

/// The same with the first sweep in the middle of the drift, where the velocity belongs: of second order, but for the
/// viscous forces, which see a velocity half a step old. Cut there, so that places and velocities between two steps
/// are those of one moment (densities: half a step before), and the two kicks beside a drift are one:
///
///   rho -= dt' rho div u at (x, u);   x += dt'/2 u;   u += (dt' + dt)/2 a(x, rho);   rho += (dt' + dt)/2 D;
///   x += dt/2 u
///
/// The first step has dt' = 0. A restart needs nothing but dt'.
void Solver::step_kick_drift_kick() {
    const double before = dt_;
    evaluate(time_ + before / 2, before, before / 2);
    gather_load();
    choose_time_step();
    move_all((before + dt_) / 2, before / 2, dt_ / 2);
}

/// Explicit Runge-Kutta: every stage starts anew from the step's begin with the rates of the stage before, and the step
/// is made with the weighted mean of all. The load is that mean too.
void Solver::step_in_stages(std::span<const Stage> stages, bool freeze_diffusion) {
    if (rebuild_due_) rebuild(dt_);
    Particles& p = particles_;
    const std::size_t n = p.size();
    stages_.compression.resize(n);
    stages_.start.resize(n);
    stages_.mean.assign(n, {});
    if (freeze_diffusion) stages_.diffusion.resize(n);
    Load mean;
    for (const Stage& stage : stages) {
        const bool first = &stage == &stages.front();
        if (!first) go_to_stage(stage.c * dt_);
        evaluate(time_ + (first ? 0 : stage.c * dt_), 0);
        gather_load();
        mean.force += stage.weight * load_.force;
        mean.friction += stage.weight * load_.friction;
        mean.moment += stage.weight * load_.moment;
        if (first) choose_time_step();
        const Stopwatch watch(timers_.update);
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < n; ++i) {
            if (first) {
                stages_.start[i] = {p.x[i], p.y[i], p.z[i], p.u[i], p.v[i], p.w[i], p.drho[i]};
                if (freeze_diffusion) stages_.diffusion[i] = rate_[i].drho;
            }
            RateRecord& r = rate_[i];
            r.drho = stages_.compression[i] + (freeze_diffusion ? stages_.diffusion[i] : r.drho);
            auto& m = stages_.mean[i];
            m.u += stage.weight * p.u[i], m.v += stage.weight * p.v[i], m.w += stage.weight * p.w[i];
            m.ax += stage.weight * r.ax, m.ay += stage.weight * r.ay, m.az += stage.weight * r.az;
            m.drho += stage.weight * r.drho;
        }
    }
    load_ = mean;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) {
        const auto& from = stages_.start[i];
        const auto& m = stages_.mean[i];
        p.x[i] = from.x, p.y[i] = from.y, p.z[i] = from.z;
        p.u[i] = from.u, p.v[i] = from.v, p.w[i] = from.w, p.drho[i] = from.drho;
        rate_[i] = {static_cast<float>(m.ax), static_cast<float>(m.ay), static_cast<float>(m.az),
                    static_cast<float>(m.drho)};
    }
    move(dt_, 0, dt_);
}

/// From the step's begin for the time `since`, with the velocities and rates found last.
void Solver::go_to_stage(double since) {
    const Stopwatch watch(timers_.update);
    Particles& p = particles_;
    const double stream = setup_.stream ? setup_.stream->velocity(time_ + since) : 0,
                 stream_before = setup_.stream ? setup_.stream->velocity(time_) : 0;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto& from = stages_.start[i];
        const RateRecord& r = rate_[i];
        p.x[i] = from.x + since * double(p.u[i]);
        p.y[i] = from.y + since * double(p.v[i]);
        p.z[i] = from.z + since * double(p.w[i]);
        switch (p.kind[i]) {
            case Kind::fluid:
                p.u[i] = static_cast<float>(from.u + since * r.ax);
                p.v[i] = static_cast<float>(from.v + since * r.ay);
                p.w[i] = static_cast<float>(from.w + since * r.az);
                p.drho[i] = static_cast<float>(from.drho + since * r.drho);
                break;
            case Kind::inlet: p.u[i] = static_cast<float>(stream); break;
            case Kind::outlet: p.u[i] = static_cast<float>(from.u + (stream - stream_before)); break;
        }
    }
}

double Solver::reference_speed() const {
    return std::max(extremes_.speed, setup_.stream ? setup_.stream->velocity(time_) : 0.0);
}

void Solver::choose_time_step() {
    const SolverSetup& s = setup_;
    const double c0 = s.state_equation.c0;
    dt_ = s.cfl * h_ / (c0 + reference_speed());
    if (extremes_.acceleration > 0) dt_ = std::min(dt_, acceleration_limit * std::sqrt(h_ / extremes_.acceleration));
    if (s.alpha > 0) dt_ = std::min(dt_, 0.25 * h_ * h_ / (s.alpha * h_ * c0));
    for (const auto& effect : effects_) dt_ = std::min(dt_, effect->largest_step(s, h_));
    if (!air_) return;
    air_->choose_time_step();
    dt_ = air_->dt_ = std::min(dt_, air_->dt_);
}

void Solver::move_all(double dt, double drifted, double drift) {
    move(dt, drifted, drift);
    if (air_) air_->move(dt, drifted, drift);
}

/// The last resort at a wall: a particle so near that no pressure can stop it in time loses its velocity towards the
/// wall (a plastic impact; the wall gets the impulse, which is returned [N s]), and is put back on the surface if this
/// step took it through. The distance carried along is checked against the surface first.
std::optional<Vec3> Solver::hold_at_wall(std::size_t i) {
    Particles& p = particles_;
    WallNormalRecord& r = normal_[i];
    if (const WallNormalRecord found = nearest_wall(i, setup_.dp); found.distance < no_wall.distance)
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

/// The last act of every scheme: velocities and densities change for `dt` by rate_, places for `drift` [s] by the new
/// velocity (or by the mean one of the stages) and by shifting; walls, bounds and the clock. `drifted`: for so long the
/// places have moved in this step already.
void Solver::move(double dt, double drifted, double drift) {
    const Stopwatch watch(timers_.update);
    const SolverSetup& s = setup_;
    Particles& p = particles_;
    const double c0 = s.state_equation.c0, speed_before = extremes_.speed;
    const double stream_before = s.stream ? s.stream->velocity(time_) : 0,
                 stream_after = s.stream ? s.stream->velocity(time_ + dt) : 0;
    const double shift_scale = -s.shifting * dt * std::max(reference_speed(), 1e-30) * h_, shift_cap = 0.05 * s.dp;

    struct Part {
        double speed2 = 0, acceleration2 = 0, relative2 = 0, relative2_before = 0, shift2 = 0, low = 0, high = 0;
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
            const double u0 = p.u[i], v0 = p.v[i], w0 = p.w[i];
            const bool was_inside =
                control_ && control_->inside(p.x[i] - drifted * u0, p.y[i] - drifted * v0, p.z[i] - drifted * w0);
            if (drifted > 0)
                part.relative2_before =
                    std::max(part.relative2_before, (u0 - stream_before) * (u0 - stream_before) + v0 * v0 + w0 * w0);
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
                        const double length2 = shift.squaredNorm();
                        if (length2 > shift_cap * shift_cap) shift *= shift_cap / std::sqrt(length2);
                        part.shift2 = std::max(part.shift2, std::min(length2, shift_cap * shift_cap));
                    }
                    break;
                }
                case Kind::inlet: p.u[i] = static_cast<float>(stream_after); break;
                case Kind::outlet: p.u[i] = static_cast<float>(u0 + (stream_after - stream_before)); break;
            }
            const Vec3 along = stages_.mean.empty() ? Vec3(p.u[i], p.v[i], p.w[i])
                                                    : Vec3(stages_.mean[i].u, stages_.mean[i].v, stages_.mean[i].w);
            p.x[i] += drift * along.x() + shift.x();
            p.y[i] += drift * along.y() + shift.y();
            p.z[i] += drift * along.z() + shift.z();
            if (!normal_.empty() && p.kind[i] == Kind::fluid) {
                WallNormalRecord& r = normal_[i];
                const double approach = along.x() * r.x + along.y() * r.y + along.z() * r.z;
                r.distance +=
                    static_cast<float>(drift * approach + shift.x() * r.x + shift.y() * r.y + shift.z() * r.z);
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
    double relative2 = 0, relative2_before = 0, speed2 = 0, shift2 = 0;
    std::size_t fastest = 0;
    Vec3 crossed = Vec3::Zero();
    for (const Part& part : parts) {
        if (part.broken)
            fail_at(part.fastest,
                    "has a velocity, density or place that is not a number; often a time step or sound speed that does "
                    "not fit the flow");
        if (part.speed2 > speed2) speed2 = part.speed2, fastest = part.fastest;
        relative2 = std::max(relative2, part.relative2);
        relative2_before = std::max(relative2_before, part.relative2_before);
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
    relative_speed_ = std::sqrt(relative2);
    travel_in_stream_ += drifted * std::sqrt(relative2_before) + drift * relative_speed_ + shift_travel;
    travel_ += drifted * speed_before + drift * extremes_.speed + shift_travel;
    time_ += dt;
    ++steps_;
    if (extremes_.speed > largest_mach * c0)
        fail_at(fastest, fmt::format("moves at {:.3g} m/s = {:.3g} c0; the sound speed is too low for this flow, or a "
                                     "wall was struck too hard",
                                     extremes_.speed, extremes_.speed / c0));
    check_bounds();
}

void Solver::check_bounds() {
    const double rho0 = setup_.rho0, most = setup_.largest_compression, least = -setup_.largest_rarefaction;
    const auto beyond = [&](double drho) { return drho > most * rho0 || drho < least * rho0; };
    if (!beyond(extremes_.density_deviation_high) && !beyond(extremes_.density_deviation_low)) return;
    for (std::size_t i = 0; i < particles_.size(); ++i)
        if (beyond(double(particles_.drho[i])))
            fail_at(i, fmt::format(
                           "has the density {:.4g} kg/m3, not {:.0f} to {:.0f} % of {:.4g}; often a sound speed that "
                           "is too low or water caught between walls",
                           rho0 + double(particles_.drho[i]), 100 + 100 * least, 100 + 100 * most, rho0));
}

}  // namespace tw
