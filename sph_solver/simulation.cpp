#include "sph_solver/simulation.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/bodies/elastic/elastic_body.h"
#include "sph_solver/bodies/elastic/forces_on_dummies.h"
#include "sph_solver/time/limits.h"

namespace tw {

Simulation::Simulation(const SimulationSetup& setup, const Fluid& fluid, const Passes& passes)
    : Simulation(setup, std::span<const Fluid>(&fluid, 1), passes) {}

Simulation::Simulation(const SimulationSetup& setup, std::span<const Fluid> fluids, const Passes& passes)
    : setup_(setup),
      passes_(&passes),
      schedule_(setup.scheme),
      around_(std::make_unique<Surroundings>(static_cast<const Surroundings&>(setup))),
      bodies_(std::make_unique<std::vector<Body>>()) {
    if (setup.threads > 0) omp_set_num_threads(setup.threads);
    const std::size_t finest = setup.zones.size();
    if (finest > 0 && setup.scheme != Scheme::kick_drift_kick)
        throw InputError("levels of particle size need [sph] scheme \"kick_drift_kick\"");
    for (const BodySetup& body : setup.bodies) bodies_->emplace_back(body);
    loads_.resize(bodies_->size());
    for (std::size_t k = 0; k <= finest; ++k) {
        LevelSetup level = setup;
        level.dp = std::ldexp(setup.dp, static_cast<int>(finest - k));
        levels_.push_back(std::make_unique<Level>(*around_, level, schedule_, *bodies_, *passes_, fluids[k]));
    }
    refinements_.reserve(finest);
    for (std::size_t k = 0; k < finest; ++k)
        refinements_.emplace_back(*levels_[k], *levels_[k + 1], setup.zones[k], k > 0 ? &refinements_[k - 1] : nullptr);
    if (std::ranges::all_of(*bodies_, [](const Body& body) { return body.fixed(); })) return;
    if (setup.partial_zones > 0)
        throw InputError(
            "beside bodies that move no particles are finer than theirs: a [[refine]] finer than near_hull");
    if (!schedule_.stages().empty())
        throw InputError("bodies that move need a time step of one evaluation: [sph] scheme \"kick_drift_kick\"");
    if (std::ranges::any_of(*bodies_, [](const Body& body) { return body.elastic() != nullptr; })) {
        if (finest > 0) throw InputError("elastic bodies need particles of one size: [sph] levels = 1");
        if (setup.scheme != Scheme::kick_drift_kick)
            throw InputError("elastic bodies need [sph] scheme \"kick_drift_kick\"");
    }
    contacts_.emplace(*bodies_, *around_, setup.dp);
    if (finest > 0) contacts_->stay_within(refinements_.back().zone());
    for (std::size_t b = 0; b < bodies_->size(); ++b) {
        if ((*bodies_)[b].fixed()) continue;
        if (ElasticBody* elastic = (*bodies_)[b].elastic()) {
            elastic->set_water(setup.rho0, setup.dp, setup.state_equation.c0);
            coupling_iterations_ = std::max(coupling_iterations_, elastic->setup().coupling.iterations);
            continue;
        }
        WaterShell shell = this->finest().walls().shell(b, setup.rho0);
        shell.spacing = setup.dp;
        shell.sound_speed = setup.state_equation.c0;
        (*bodies_)[b].set_shell(shell);
    }
}

Level& Simulation::add_level(LevelSetup setup, const Fluid& fluid) {
    if (!refinements_.empty())
        throw InputError(setup.material + " beside the water needs particles of one size: [sph] levels = 1");
    if (!schedule_.stages().empty())
        throw InputError(setup.material +
                         " beside the water needs a time step of one evaluation: [sph] scheme \"kick_drift_kick\" or "
                         "\"symplectic_euler\"");
    levels_.push_back(std::make_unique<Level>(*around_, std::move(setup), schedule_, *bodies_, *passes_, fluid));
    for (std::size_t k = 0; k + 1 < levels_.size(); ++k) pairs_.emplace_back(*levels_[k], *levels_.back());
    return *levels_.back();
}

void Simulation::step() {
    if (!refinements_.empty()) {
        of_levels_.assign(refinements_.size() + 1, {std::vector<Load>(loads_.size()), 0});
        step_level(0, 0);
        for (std::size_t b = 0; b < loads_.size(); ++b) {
            loads_[b] = {};
            for (const LevelLoads& level : of_levels_) loads_[b] += (1 / level.over) * level.sum[b];
        }
        follow_bodies();
        return refuse_contact();
    }
    if (lists_outlived()) make_lists_due();
    if (!schedule_.stages().empty()) return step_in_stages();
    const double before = dt();
    const auto [after, compress, drift] = schedule_.evaluation(before);
    evaluate(time() + after, compress, drift);
    gather_loads();
    choose_time_step();
    const Schedule::Move move = schedule_.move(before, dt());
    for (int k = 1; k < coupling_iterations_; ++k) {
        rehearse_bodies(move);
        press(time() + after);
        gather_loads();
    }
    const std::vector<Load> pressed = level(0).walls().loads;
    move_bodies(move);
    for (const auto& level : schedule_.due(levels_)) level->advance(move, setup_.moment_reference);
    strike_bodies(pressed, move.kick);
    take_loads();
    refuse_contact();
}

void Simulation::refuse_contact() const {
    if (!contacts_) return;
    if (const std::string contact = contacts_->found(); !contact.empty())
        throw RunError(
            fmt::format("{} at t = {:.6g} s (step {}), and what comes then is not solved: end the run "
                        "before it, or give the body more room",
                        contact, time(), steps()));
}

void Simulation::push(ElasticBody& elastic, std::size_t b) {
    level(0).walls().push(elastic, b, forces_on_dummies(level(0), b));
    for (const Walls::Contact& c : level(0).walls().contacts)
        if (c.body == b) elastic.press(c.triangle, c.place, c.force);
}

namespace {
/// Adds the processor time of a scope, all threads together [s].
class ProcessorTime {
public:
    explicit ProcessorTime(double& sum) : sum_(sum) {}
    ~ProcessorTime() { sum_ += double(std::clock() - from_) / CLOCKS_PER_SEC; }
    ProcessorTime(const ProcessorTime&) = delete;
    ProcessorTime& operator=(const ProcessorTime&) = delete;

private:
    double& sum_;
    std::clock_t from_ = std::clock();
};
}  // namespace

void Simulation::rehearse_bodies(const Schedule::Move& move) {
    for (std::size_t b = 0; b < bodies_->size(); ++b) {
        ElasticBody* elastic = (*bodies_)[b].elastic();
        if (!elastic || elastic->setup().coupling.iterations == 1) continue;
        const ProcessorTime spent(structure_seconds_);
        push(*elastic, b);
        elastic->rehearse(move.kick, move.drift, setup_.gravity);
    }
}

void Simulation::move_bodies(const Schedule::Move& move) {
    for (std::size_t b = 0; b < bodies_->size(); ++b) {
        Body& body = (*bodies_)[b];
        if (ElasticBody* elastic = body.elastic()) {
            const ProcessorTime spent(structure_seconds_);
            push(*elastic, b);
            elastic->advance(move.kick, 2 * move.drifted, move.drift, setup_.gravity);
            continue;
        }
        const Load& load = finest().walls().loads[b];
        body.kick(load.force, load.moment, setup_.moment_reference, setup_.gravity, move.kick);
        body.drift(move.drift);
    }
}

void Simulation::strike_bodies(const std::vector<Load>& before, double kick) {
    for (const Walls::Blow& blow : level(0).walls().blows)
        if (ElasticBody* elastic = (*bodies_)[blow.body].elastic())
            elastic->strike(blow.triangle, blow.place, blow.impulse);
    for (std::size_t b = 0; b < bodies_->size(); ++b) {
        const Load& load = finest().walls().loads[b];
        (*bodies_)[b].strike(kick * (load.force - before[b].force), kick * (load.moment - before[b].moment),
                             setup_.moment_reference);
    }
}

void Simulation::take_loads() {
    for (std::size_t b = 0; b < loads_.size(); ++b) loads_[b] = level(0).walls().loads[b];
}

void Simulation::step_level(std::size_t k, double dt) {
    Level& level = *levels_[k];
    const bool is_finest = k == refinements_.size();
    if (level.lists_outlived()) level.make_lists_due();
    const double before = level.dt();
    const auto [after, compress, drift] = schedule_.evaluation(before);
    level.refresh(drift);
    if (!is_finest) refinements_[k].relabel();
    const double t = level.time() + after;
    level.first_sweep(t, compress, drift, nullptr);
    if (is_finest)
        for (Body& body : *bodies_) body.drift(drift);
    level.second_sweep(t);
    level.gather_loads(setup_.moment_reference);
    if (dt == 0) {
        dt = stable_step(level, setup_.cfl);
        for (std::size_t j = 1; j < levels_.size(); ++j)
            dt = std::min(dt, std::ldexp(stable_step(*levels_[j], setup_.cfl), static_cast<int>(j)));
        for (const Body& body : *bodies_)
            dt = std::min(dt, std::ldexp(body.stable_step(), static_cast<int>(refinements_.size())));
    }
    level.set_step(dt);
    const Schedule::Move move = schedule_.move(before, dt);
    const std::vector<Load> pressed = level.walls().loads;
    if (is_finest) move_bodies(move);
    level.advance(move, setup_.moment_reference);
    for (std::size_t b = 0; b < loads_.size(); ++b) of_levels_[k].sum[b] += move.kick * level.walls().loads[b];
    of_levels_[k].over += move.kick;
    if (is_finest) return strike_bodies(pressed, move.kick);
    // The fine level's last evaluation was half its step before its present places, the coarse level's half its step.
    const double fine_before = levels_[k + 1]->dt(), first = move.kick / 2, second = dt / 2;
    refinements_[k].prolong(move.kick, (before + fine_before) / 2);
    step_level(k + 1, first);
    step_level(k + 1, second);
    refinements_[k].restrict_over(move.kick, fine_before / 2 + first - before / 2);
}

void Simulation::evaluate(double t, double compress, double drift) {
    const auto due = schedule_.due(levels_);
    const bool lists_due = std::ranges::any_of(due, [](const auto& level) { return level->lists_due(); });
    if (lists_due) {
        make_lists_due();
        for (Body& body : *bodies_) body.note_surface();
    }
    for (const auto& level : due) level->refresh(drift);
    for (LevelPair& pair : pairs_) {
        if (lists_due) pair.find_neighbours();
        pair.meet(t);
    }
    for (const auto& level : due) {
        const OtherSums* other = nullptr;
        for (const LevelPair& pair : pairs_)
            if (const OtherSums* sums = pair.sums_for(*level)) other = sums;
        level->first_sweep(t, compress, drift, other);
    }
    for (Body& body : *bodies_) body.drift(drift);
    press(t);
}

void Simulation::press(double t) {
    for (const auto& level : schedule_.due(levels_)) level->second_sweep(t);
    for (LevelPair& pair : pairs_) pair.press(t);
}

/// Explicit Runge-Kutta: every stage starts anew from the step's begin with the rates of the stage before, and the step
/// is made with the weighted mean of all. The load is that mean too.
void Simulation::step_in_stages() {
    Level& level = *levels_.front();
    const bool freeze = schedule_.freezes_diffusion();
    level.begin_stages(freeze);
    std::vector<Load> mean(bodies_->size());
    for (const Stage& stage : schedule_.stages()) {
        const bool first = &stage == &schedule_.stages().front();
        if (!first) level.go_to_stage(stage.c * dt());
        evaluate(time() + (first ? 0 : stage.c * dt()), 0, 0);
        gather_loads();
        for (std::size_t b = 0; b < mean.size(); ++b) mean[b] += stage.weight * level.walls().loads[b];
        if (first) choose_time_step();
        level.add_stage(stage.weight, first, freeze);
    }
    level.end_stages(mean);
    level.advance({dt(), 0, dt()}, setup_.moment_reference);
    take_loads();
}

void Simulation::gather_loads() {
    for (const auto& level : levels_) level->gather_loads(setup_.moment_reference);
}

/// All levels take the smallest of their steps.
void Simulation::choose_time_step() {
    double dt = stable_step(*levels_.front(), setup_.cfl);
    for (const auto& level : levels_) dt = std::min(dt, stable_step(*level, setup_.cfl));
    for (const Body& body : *bodies_) dt = std::min(dt, body.stable_step());
    for (const Body& body : *bodies_) dt = body.step_within(dt);
    for (const auto& level : levels_) level->set_step(dt);
}

bool Simulation::lists_outlived() const {
    return std::ranges::any_of(levels_, [](const auto& level) { return level->lists_outlived(); }) ||
           std::ranges::any_of(pairs_, [](const LevelPair& pair) { return pair.lists_outlived(); });
}

void Simulation::make_lists_due() {
    for (const auto& level : levels_) level->make_lists_due();
}

void Simulation::mark_restart_point() { make_lists_due(); }

void Simulation::follow_bodies() {
    for (const auto& level : levels_) level->follow_bodies();
    if (!setup_.zones_round) return;
    std::vector<MovedSolid> moving;
    for (const Body& body : *bodies_)
        if (!body.fixed()) moving.push_back(body.moved());
    std::vector<Zone> zones = setup_.zones_round(moving);
    for (std::size_t k = 0; k < refinements_.size(); ++k) refinements_[k].set_zone(std::move(zones[k]));
}

Load Simulation::load() const {
    Load sum;
    for (const Load& load : loads_) sum += load;
    return sum;
}

Load Simulation::load_of_level(std::size_t k) const {
    Load sum;
    for (const Load& load : level(k).walls().loads) sum += load;
    return sum;
}

/// Each point by the level that owns its place; a flux by the one that has the control volume.
void Simulation::sample_levels(PointSamples& points) {
    if (points.want_flux) return at_bodies().sample(points);
    const std::size_t n = points.places.size();
    points.p.assign(n, 0);
    points.support.assign(n, 0);
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        PointSamples own;
        std::vector<std::size_t> who;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3& x = points.places[i];
            const bool reached = k == 0 || refinements_[k - 1].zone().outside(x) < 0;
            if (reached && (k == refinements_.size() || refinements_[k].zone().outside(x) >= 0))
                own.places.push_back(x), who.push_back(i);
        }
        levels_[k]->sample(own);
        for (std::size_t j = 0; j < who.size(); ++j) {
            points.p[who[j]] = own.p[j];
            points.support[who[j]] = own.support[j];
        }
    }
}

void Simulation::sample(PointSamples& points) {
    if (!refinements_.empty()) return sample_levels(points);
    if (!level(0).has_records()) evaluate(time(), 0, 0);
    level(0).sample(points);
    if (levels_.size() == 1) return;
    const std::size_t n = points.places.size();
    std::vector<float> sum(n, 0), weight(n, 0);
    double lid = 0;
    for (const auto& level : levels_) {
        PointSamples of_level{points.places, false, {}, {}, {}};
        level->sample(of_level);
        for (std::size_t k = 0; k < n; ++k) {
            sum[k] += of_level.p[k] * of_level.support[k];
            weight[k] += of_level.support[k];
        }
        if (level->setup().shut_in) lid = level->lid_pressure();
    }
    for (std::size_t k = 0; k < n; ++k)
        if (weight[k] > 0) points.p[k] = sum[k] / weight[k] - static_cast<float>(lid);
}

double Simulation::bytes() const {
    double sum = 0;
    for (const auto& level : levels_) sum += level->bytes();
    for (const LevelPair& pair : pairs_) sum += double(pair.bytes());
    return sum;
}

}  // namespace tw
