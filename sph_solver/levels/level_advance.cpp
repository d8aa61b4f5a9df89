// The last act of a step of one level: velocities, densities and places change; walls, limits and the clock.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/backend/stopwatch.h"
#include "sph_solver/levels/level.h"
#include "sph_solver/loops/inlet_wave.h"

namespace tw {

/// What all ranges of particles make of a step together, and then all ranks.
struct Level::OfAllParts {
    struct At {
        double value;         ///< the larger one counts, and of equal ones that of the pencil that comes first
        std::int32_t pencil;  ///< of the particle; it is one that no rank has where it is past the last pencil
        std::int64_t id;
        double x, y, z;
        At& operator+=(const At& other) {
            if (other.value > value || (other.value == value && other.pencil < pencil)) *this = other;
            return *this;
        }
        Vec3 place() const { return {x, y, z}; }
    };
    /// What ranks add.
    struct Sums {
        At fastest, densest, thinnest;
        double acceleration2, relative2, relative2_before, shift2;
        ExactVectorSum crossed;
        std::int64_t held;
        std::int64_t broken;

        Sums& operator+=(const Sums& other) {
            fastest += other.fastest, densest += other.densest, thinnest += other.thinnest;
            for (const auto of : {&Sums::acceleration2, &Sums::relative2, &Sums::relative2_before, &Sums::shift2})
                this->*of = std::max(this->*of, other.*of);
            crossed += other.crossed;
            held += other.held, broken += other.broken;
            return *this;
        }
    };
    Sums sums{};
    std::vector<PushSum> on_bodies;  ///< of particles held at walls
    // of this rank
    std::size_t fastest = 0, densest = 0, thinnest = 0;
    double own_speed2 = 0;
    std::optional<std::size_t> broken{};
    std::vector<WallImpulse> wall_impulses{};
    std::vector<std::int32_t> impulse_pencils{};
};

Level::Impulses Level::advance(const Schedule::Move& move, const Vec3& moment_reference) {
    const Stopwatch watch(timers_.advance);
    const double speed_before = system_.extremes.speed;
    const Move moving = move_on(move);
    system_.walls.note_motions();
    const auto held = [&](std::size_t i, Moved& part) { hold(i, moment_reference, part); };
    OfAllParts all = join(steps_->move(moving, held));
    carry_inlet(move);
    agree(all, moment_reference);
    Impulses impulses = impulses_on_bodies(all, move.kick);
    note_extremes(all);
    note_travel(all, move, speed_before);
    system_.time += move.kick;
    ++system_.steps;
    check_speed(all);
    check_density();
    return impulses;
}

Move Level::move_on(const Schedule::Move& move) {
    const auto [dt, drifted, drift] = move;
    const LevelSetup& s = system_.setup;
    Particles& p = system_.particles;
    return {.p = system_.state_view(),
            .kind = p.kind.data(),
            .rate = p.rate.data(),
            .shift_support = p.shift_support.data(),
            .trend = p.trend.empty() ? nullptr : p.trend.data(),
            .dt = dt,
            .drifted = drifted,
            .drift = drift,
            .stream_before = system_.stream_velocity(system_.time),
            .stream_after = system_.stream_velocity(system_.time + dt),
            .outlet_share = system_.around.stream ? system_.around.stream->behind_share : 1,
            .inlet_has_wave = system_.inlet_has_wave(),
            .shifts = s.shifting > 0,
            .shifting_support = s.shifting_support,
            .shift_step = ShiftStep(s.shifting, dt, system_.h, s.dp),
            .stages = stages_.mean()};
}

/// The wave that enters with the stream. Places are then those of the step's end.
void Level::carry_inlet(const Schedule::Move& move) {
    if (!system_.inlet_has_wave()) return;
    const auto [dt, drifted, drift] = move;
    const Stream& stream = *system_.around.stream;
    const double before = system_.time, after = before + dt;
    const StepView view = steps_->step_view(before);
    const double moved = drifted + drift;
    system_.with_wave_of_inlet([&]<class Wave>(const WaveOfInlet<Wave>& of) {
        view.each(view.n, CarryInlet<Wave>{.p = view.p,
                                           .kind = view.kind,
                                           .of = of,
                                           .before = stream.wave_at(before),
                                           .middle = stream.wave_at(before + dt / 2),
                                           .after = stream.wave_at(after),
                                           .moved = moved});
    });
}

/// The last resort at a wall: a particle so near that no pressure can stop it in time loses its velocity towards the
/// wall (a plastic impact; the body gets the impulse), and is put back on the surface if this step took it through. The
/// distance carried along is checked against the surface first.
std::optional<Level::Held> Level::hold_at_wall(std::size_t i) {
    Particles& p = system_.particles;
    PackedWallNormal& r = system_.particles.wall_normal[i];
    const Walls::Nearest found =
        system_.walls.nearest(Vec3(p.x[i], p.y[i], p.z[i]), Vec3(p.u[i], p.v[i], p.w[i]), system_.setup.dp);
    if (found.normal.distance < no_wall.distance) {
        found.note(p.view(), i);
    } else {
        r.distance = static_cast<float>(system_.setup.dp);
    }
    const double approach = system_.leaving(i, {p.u[i], p.v[i], p.w[i]});
    if (r.distance >= Move::held_at_wall_over_dp * system_.setup.dp || approach >= 0) return {};
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

void Level::hold(std::size_t i, const Vec3& moment_reference, Moved& part) {
    const Particles& p = system_.particles;
    const auto held = hold_at_wall(i);
    if (!held || p.kind[i] != Kind::fluid || !share_.owns(i)) return;
    ++part.held;
    part.on_bodies.resize(system_.bodies.size());
    const Vec3 place(p.x[i], p.y[i], p.z[i]);
    part.on_bodies[held->body].add(held->lost, place - moment_reference);
    if (system_.walls.any_deformable()) {
        part.on_elastic.push_back({held->body, held->triangle, place, system_.mass * held->lost});
        part.by.push_back(i);
    }
}

/// Of this rank.
Level::OfAllParts Level::join(const std::vector<Moved>& parts) const {
    OfAllParts all{.on_bodies = std::vector<PushSum>(system_.bodies.size())};
    OfAllParts::Sums& sums = all.sums;
    for (const Moved& part : parts) {
        if (part.broken && !all.broken) all.broken = part.fastest;
        if (part.speed2 > sums.fastest.value) sums.fastest.value = part.speed2, all.fastest = part.fastest;
        if (-part.low > sums.thinnest.value) sums.thinnest.value = -part.low, all.thinnest = part.thinnest;
        if (part.high > sums.densest.value) sums.densest.value = part.high, all.densest = part.densest;
        sums.relative2 = std::max(sums.relative2, part.relative2);
        sums.relative2_before = std::max(sums.relative2_before, part.relative2_before);
        sums.shift2 = std::max(sums.shift2, part.shift2);
        sums.acceleration2 = std::max(sums.acceleration2, part.acceleration2);
        sums.crossed += part.crossed;
        sums.held += part.held;
        all.wall_impulses.insert(all.wall_impulses.end(), part.on_elastic.begin(), part.on_elastic.end());
        for (const std::size_t i : part.by) all.impulse_pencils.push_back(share_.pencil_of(i));
        for (std::size_t b = 0; b < part.on_bodies.size(); ++b) all.on_bodies[b] += part.on_bodies[b];
    }
    sums.broken = all.broken.has_value();
    all.own_speed2 = sums.fastest.value;
    return all;
}

/// With the other ranks. Ends the run where one has a particle that is broken.
void Level::agree(OfAllParts& all, const Vec3& moment_reference) {
    const Particles& p = system_.particles;
    steps_->copy_to_host({all.fastest, all.densest, all.thinnest});
    const auto note = [&](OfAllParts::At& at, std::size_t i) {
        at.pencil = system_.grid.count();
        if (i < p.size()) at = {at.value, share_.pencil_of(i), p.id[i], p.x[i], p.y[i], p.z[i]};
    };
    OfAllParts::Sums& sums = all.sums;
    note(sums.fastest, all.fastest), note(sums.densest, all.densest), note(sums.thinnest, all.thinnest);
    system_.ranks().add(std::span(&sums, 1), std::span(all.on_bodies), loads_.waiting());
    loads_.settle(moment_reference);
    if (sums.held > 0 && system_.walls.any_deformable())
        all.wall_impulses = share_.of_all_ranks(all.wall_impulses, all.impulse_pencils);
    if (sums.broken > 0)
        share_.fail_together({all.broken, all.broken ? share_.pencil_of(*all.broken) : 0,
                              "has a velocity, density or place that is not a number; often a time step or sound speed "
                              "that does not fit the flow"});
}

/// What held particles give to the bodies.
Level::Impulses Level::impulses_on_bodies(OfAllParts& all, double dt) {
    Impulses impulses;
    if (all.sums.held > 0 && system_.walls.any_deformable()) impulses.places = std::move(all.wall_impulses);
    for (std::size_t b = 0; b < all.on_bodies.size(); ++b) {
        const PushSum& on_body = all.on_bodies[b];
        const Impulse held{system_.mass * on_body.push.value(), system_.mass * on_body.turn.value()};
        system_.walls.add_load(b, {held.impulse / dt, Vec3::Zero(), held.turn / dt});
        impulses.bodies.push_back(held);
    }
    system_.ledger.held += all.sums.held;
    if (system_.control) system_.control->add_crossed(system_.mass * all.sums.crossed.value());
    return impulses;
}

void Level::note_extremes(const OfAllParts& all) {
    const OfAllParts::Sums& sums = all.sums;
    Extremes& e = system_.extremes;
    e = {};
    e.speed = std::sqrt(sums.fastest.value);
    e.acceleration = std::sqrt(sums.acceleration2);
    if (sums.fastest.pencil < system_.grid.count()) e.fastest = sums.fastest.id, e.fastest_place = sums.fastest.place();
    if (sums.thinnest.value > 0)
        e.density_deviation_low = -sums.thinnest.value, e.thinnest_place = sums.thinnest.place();
    if (sums.densest.value > 0) e.density_deviation_high = sums.densest.value, e.densest_place = sums.densest.place();
}

/// How long the lists hold.
void Level::note_travel(const OfAllParts& all, const Schedule::Move& move, double speed_before) {
    const auto [dt, drifted, drift] = move;
    ListLife& life = system_.near.life;
    const double shift_travel = std::sqrt(all.sums.shift2);
    life.relative_speed = std::sqrt(all.sums.relative2);
    life.travel_in_stream +=
        drifted * std::sqrt(all.sums.relative2_before) + drift * life.relative_speed + shift_travel;
    life.wall_travel += drifted * system_.wall_speed + drift * system_.walls.fastest();
    life.since_walls += dt;
    life.travel += drifted * speed_before + drift * system_.extremes.speed + shift_travel;
}

void Level::check_speed(const OfAllParts& all) const {
    const double speed = system_.extremes.speed, c0 = system_.setup.state_equation.c0;
    if (speed <= largest_mach * c0) return;
    const bool here = all.own_speed2 == all.sums.fastest.value && all.fastest < system_.particles.size();
    share_.fail_together({here ? std::optional(all.fastest) : std::nullopt, here ? share_.pencil_of(all.fastest) : 0,
                          fmt::format("moves at {:.3g} m/s = {:.3g} c0; the sound speed is too low for this flow, or "
                                      "the impact on a wall was too violent",
                                      speed, speed / c0)});
}

void Level::check_density() const {
    const double rho0 = system_.setup.rho0, most = system_.setup.largest_compression,
                 least = -system_.setup.largest_rarefaction;
    const auto beyond = [&](double drho) { return drho > most * rho0 || drho < least * rho0; };
    if (!beyond(system_.extremes.density_deviation_high) && !beyond(system_.extremes.density_deviation_low)) return;
    RankShare::Failing failing{{}, 0, {}};
    const Particles& p = fields_.particles();
    for (std::size_t i = 0; i < p.size() && !failing.at; ++i)
        if (is_active(p.kind[i]) && beyond(double(p.drho[i])))
            failing = {i, share_.pencil_of(i),
                       fmt::format("has the density {:.4g} kg/m3, not {:.0f} to {:.0f} % of {:.4g}; often a sound "
                                   "speed that is too low or water caught between walls",
                                   rho0 + double(p.drho[i]), 100 + 100 * least, 100 + 100 * most, rho0)};
    share_.fail_together(failing);
}

}  // namespace tw
