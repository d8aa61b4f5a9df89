// The last act of a step of one level: velocities, densities and places change; walls, limits and the clock. And the
// stages of explicit Runge-Kutta schemes.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/backend/for_particles.h"
#include "sph_solver/backend/stopwatch.h"
#include "sph_solver/levels/level.h"
#include "sph_solver/loops/move.h"

namespace tw {

namespace {

/// What a range of particles adds to the step's extremes and sums.
struct Part : MovedExtremes {
    // per unit of particle mass
    ExactVectorSum crossed;          ///< momentum into the control volume [m/s]
    std::vector<PushSum> on_bodies;  ///< impulse of particles held at the wall of each of them [m/s]; empty: none
    std::vector<WallStrike> on_elastic;
    std::vector<std::size_t> by;  ///< who gave each of those
    std::int64_t held = 0;
};

/// What all ranks make of their parts.
struct OfAllRanks {
    struct At {
        double value;         ///< the larger one counts, and of equal ones that of the column that comes first
        std::int32_t column;  ///< of the particle; it is one that no rank has where it is past the last column
        std::int64_t id;
        double x, y, z;
        At& operator+=(const At& other) {
            if (other.value > value || (other.value == value && other.column < column)) *this = other;
            return *this;
        }
        Vec3 place() const { return {x, y, z}; }
    };
    At fastest, densest, thinnest;
    double acceleration2, relative2, relative2_before, shift2;
    ExactVectorSum crossed;
    std::int64_t held;
    std::int64_t broken;

    OfAllRanks& operator+=(const OfAllRanks& other) {
        fastest += other.fastest, densest += other.densest, thinnest += other.thinnest;
        for (const auto of :
             {&OfAllRanks::acceleration2, &OfAllRanks::relative2, &OfAllRanks::relative2_before, &OfAllRanks::shift2})
            this->*of = std::max(this->*of, other.*of);
        crossed += other.crossed;
        held += other.held, broken += other.broken;
        return *this;
    }
};

}  // namespace

/// The last resort at a wall: a particle so near that no pressure can stop it in time loses its velocity towards the
/// wall (a plastic impact; the body gets the impulse), and is put back on the surface if this step took it through. The
/// distance carried along is checked against the surface first.
std::optional<Level::Held> Level::hold_at_wall(std::size_t i) {
    Particles& p = particles_;
    WallNormalRecord& r = particles_.wall_normal[i];
    const Walls::Nearest found = walls_.nearest(Vec3(p.x[i], p.y[i], p.z[i]), Vec3(p.u[i], p.v[i], p.w[i]), setup_.dp);
    if (found.normal.distance < no_wall.distance) {
        note_wall(i, found);
    } else {
        r.distance = static_cast<float>(setup_.dp);
    }
    const double approach = leaving(i, {p.u[i], p.v[i], p.w[i]});
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
    return Held{before - Vec3(p.u[i], p.v[i], p.w[i]), found.body, found.triangle};
}

Level::Struck Level::advance(const Schedule::Move& move, const Vec3& moment_reference) {
    const Stopwatch watch(timers_.update);
    const auto [dt, drifted, drift] = move;
    const LevelSetup& s = setup_;
    Particles& p = particles_;
    const double c0 = s.state_equation.c0, speed_before = extremes_.speed;
    const double stream_before = stream_velocity(time_), stream_after = stream_velocity(time_ + dt);
    const Move move_on{.p = state_view(),
                       .kind = p.kind.data(),
                       .rate = p.rate.data(),
                       .shift_support = p.shift_support.data(),
                       .trend = p.trend.empty() ? nullptr : p.trend.data(),
                       .dt = dt,
                       .drifted = drifted,
                       .drift = drift,
                       .stream_before = stream_before,
                       .stream_after = stream_after,
                       .shifts = s.shifting > 0,
                       .shifting_support = s.shifting_support,
                       .shift_step = ShiftStep(s.shifting, dt, h_, s.dp),
                       .stages = stages_.mean.data()};
    walls_.note_motions();

    const auto hold = [&](std::size_t i, Part& part) {
        const auto held = hold_at_wall(i);
        if (!held || p.kind[i] != Kind::fluid || !owns(i)) return;
        ++part.held;
        part.on_bodies.resize(bodies_.size());
        const Vec3 place(p.x[i], p.y[i], p.z[i]);
        part.on_bodies[held->body].add(held->lost, place - moment_reference);
        if (walls_.give_way()) {
            part.on_elastic.push_back({held->body, held->triangle, place, mass_ * held->lost});
            part.by.push_back(i);
        }
    };
    const auto moved_by_device = [&](const Move& by) {
        const DeviceSteps::Moved moved = device_->move(by);
        Part part;
        static_cast<MovedExtremes&>(part) = moved.extremes;
        for (const std::size_t i : moved.at_walls) {
            hold(i, part);
            by.note(i, part);
        }
        device_->put_back(moved.at_walls);
        return part;
    };
    const auto move_range = [&](Part& part, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double u0 = p.u[i], v0 = p.v[i], w0 = p.w[i];
            const double was_inside =
                control_ ? control_->share(p.x[i] - drifted * u0, p.y[i] - drifted * v0, p.z[i] - drifted * w0) : 0;
            const V3<double> shift = move_on.kick(i, part);
            const V3<double> along = move_on.along(i);
            move_on.drift_along(i, along, shift);
            if (!p.wall_normal.empty() && kept_out_of_solids(p.kind[i])) {
                WallNormalRecord& r = p.wall_normal[i];
                r.distance += static_cast<float>(drift * leaving(i, along) + dot(shift, normal_of(r)));
                if (r.distance < held_at_wall_over_dp * s.dp) hold(i, part);
            }
            move_on.note(i, part);
            if (control_ && owns(i)) {
                // momentum of what crosses a face, with the velocity in the middle of the step
                const double crossing = control_->share(p.x[i], p.y[i], p.z[i]) - was_inside;
                if (crossing != 0)
                    part.crossed += crossing * Vec3((u0 + double(p.u[i])) / 2, (v0 + double(p.v[i])) / 2,
                                                    (w0 + double(p.w[i])) / 2);
            }
            if (part.broken) break;
        }
    };
    const std::vector<Part> parts =
        device_ ? std::vector{moved_by_device(move_on)} : in_fixed_ranges<Part>(p.size(), move_range);

    OfAllRanks all{};
    std::size_t fastest = 0, densest = 0, thinnest = 0;
    std::optional<std::size_t> broken;
    std::vector<PushSum> on_bodies(bodies_.size());
    std::vector<WallStrike> strikes;
    std::vector<std::int32_t> strike_columns;
    Struck struck;
    for (const Part& part : parts) {
        if (part.broken && !broken) broken = part.fastest;
        if (part.speed2 > all.fastest.value) all.fastest.value = part.speed2, fastest = part.fastest;
        if (-part.low > all.thinnest.value) all.thinnest.value = -part.low, thinnest = part.thinnest;
        if (part.high > all.densest.value) all.densest.value = part.high, densest = part.densest;
        all.relative2 = std::max(all.relative2, part.relative2);
        all.relative2_before = std::max(all.relative2_before, part.relative2_before);
        all.shift2 = std::max(all.shift2, part.shift2);
        all.acceleration2 = std::max(all.acceleration2, part.acceleration2);
        all.crossed += part.crossed;
        all.held += part.held;
        strikes.insert(strikes.end(), part.on_elastic.begin(), part.on_elastic.end());
        for (const std::size_t i : part.by) strike_columns.push_back(column_of(i));
        for (std::size_t b = 0; b < part.on_bodies.size(); ++b) on_bodies[b] += part.on_bodies[b];
    }
    all.broken = broken.has_value();
    if (device_) device_->bring_home({fastest, densest, thinnest});
    const auto note = [&](OfAllRanks::At& at, std::size_t i) {
        at.column = grid_.count();
        if (i < p.size()) at = {at.value, column_of(i), p.id[i], p.x[i], p.y[i], p.z[i]};
    };
    note(all.fastest, fastest), note(all.densest, densest), note(all.thinnest, thinnest);
    const double own_speed2 = all.fastest.value;
    ranks().add(std::span(&all, 1), std::span(on_bodies), std::span(waiting_loads_));
    if (!waiting_loads_.empty()) set_loads(waiting_loads_, moment_reference);
    waiting_loads_.clear();
    if (all.held > 0 && walls_.give_way()) struck.places = of_all_ranks(strikes, strike_columns);
    if (all.broken > 0)
        fail_together({broken, broken ? column_of(*broken) : 0,
                       "has a velocity, density or place that is not a number; often a time step or sound speed that "
                       "does not fit the flow"});

    for (std::size_t b = 0; b < on_bodies.size(); ++b) {
        const Impulse held{mass_ * on_bodies[b].push.value(), mass_ * on_bodies[b].turn.value()};
        walls_.add_load(b, {held.impulse / dt, Vec3::Zero(), held.turn / dt});
        struck.bodies.push_back(held);
    }
    ledger_.held += all.held;
    extremes_ = {};
    extremes_.speed = std::sqrt(all.fastest.value);
    extremes_.acceleration = std::sqrt(all.acceleration2);
    if (all.fastest.column < grid_.count())
        extremes_.fastest = all.fastest.id, extremes_.fastest_place = all.fastest.place();
    if (all.thinnest.value > 0)
        extremes_.density_deviation_low = -all.thinnest.value, extremes_.thinnest_place = all.thinnest.place();
    if (all.densest.value > 0)
        extremes_.density_deviation_high = all.densest.value, extremes_.densest_place = all.densest.place();
    if (control_) control_->add_crossed(mass_ * all.crossed.value());
    const double shift_travel = std::sqrt(all.shift2);
    life_.relative_speed = std::sqrt(all.relative2);
    life_.travel_in_stream += drifted * std::sqrt(all.relative2_before) + drift * life_.relative_speed + shift_travel;
    life_.wall_travel += drifted * wall_speed_ + drift * walls_.fastest();
    life_.travel += drifted * speed_before + drift * extremes_.speed + shift_travel;
    time_ += dt;
    ++steps_;
    if (extremes_.speed > largest_mach * c0) {
        const bool here = own_speed2 == all.fastest.value && fastest < p.size();
        fail_together({here ? std::optional(fastest) : std::nullopt, here ? column_of(fastest) : 0,
                       fmt::format("moves at {:.3g} m/s = {:.3g} c0; the sound speed is too low for this flow, or a "
                                   "wall was struck too hard",
                                   extremes_.speed, extremes_.speed / c0)});
    }
    check_density();
    return struck;
}

void Level::check_density() const {
    const double rho0 = setup_.rho0, most = setup_.largest_compression, least = -setup_.largest_rarefaction;
    const auto beyond = [&](double drho) { return drho > most * rho0 || drho < least * rho0; };
    if (!beyond(extremes_.density_deviation_high) && !beyond(extremes_.density_deviation_low)) return;
    Failing failing{{}, 0, {}};
    home();
    for (std::size_t i = 0; i < particles_.size() && !failing.at; ++i)
        if (is_active(particles_.kind[i]) && beyond(double(particles_.drho[i])))
            failing = {i, column_of(i),
                       fmt::format("has the density {:.4g} kg/m3, not {:.0f} to {:.0f} % of {:.4g}; often a sound "
                                   "speed that is too low or water caught between walls",
                                   rho0 + double(particles_.drho[i]), 100 + 100 * least, 100 + 100 * most, rho0)};
    fail_together(failing);
}

// --- stages ---------------------------------------------------------------------------------------------------------

void Level::begin_stages(bool freeze_diffusion) {
    const StepView view = step_view(time_);
    stages_.compression.resize(view.device, view.n);
    stages_.start.resize(view.device, view.n);
    stages_.mean.zeros(view.device, view.n);
    if (freeze_diffusion) stages_.diffusion.resize(view.device, view.n);
    stages_.loads.assign(bodies_.size(), {});
}

void Level::note_compression() {
    float* const compression = stages_.compression.data();
    if (!compression) return;
    const StepView view = step_view(time_);
    view.each(view.n, NoteCompression{view.rate, compression});
}

void Level::go_to_stage(double since) {
    const Stopwatch watch(timers_.update);
    const StepView view = step_view(time_);
    view.each(view.n, GoToStage{view.p, view.kind, stages_.start.data(), view.rate, since,
                                stream_velocity(time_ + since), stream_velocity(time_)});
}

void Level::add_stage(double weight, bool first, bool freeze_diffusion) {
    const Stopwatch watch(timers_.update);
    const StepView view = step_view(time_);
    view.each(view.n, AddStage{view.p, view.rate, stages_.start.data(), stages_.mean.data(), stages_.compression.data(),
                               freeze_diffusion ? stages_.diffusion.data() : nullptr, weight, first});
    for (std::size_t b = 0; b < stages_.loads.size(); ++b) stages_.loads[b] += weight * walls_.loads()[b];
}

void Level::end_stages() {
    walls_.set_loads(stages_.loads);
    const StepView view = step_view(time_);
    view.each(view.n, EndStages{view.p, view.rate, stages_.start.data(), stages_.mean.data()});
}

}  // namespace tw
