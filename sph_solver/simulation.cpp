#include "sph_solver/simulation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/backend/for_particles.h"
#include "sph_solver/backend/threads.h"

namespace tw {
namespace {

/// Throws InputError for what the physics of the coupling has no answer to.
void refuse_unsolved(const SimulationSetup& setup, const Bodies& bodies) {
    if (!setup.zones.empty() && setup.scheme != Scheme::kick_drift_kick)
        throw InputError(
            "several sizes of particles need [sph] scheme \"kick_drift_kick\": fields at the edge between two sizes "
            "are "
            "linear in time over the coarse step, so more stages are no more accurate there, and symplectic Euler is "
            "of "
            "first order");
    if (all_fixed(bodies)) return;
    if (setup.partial_zones > 0)
        throw InputError(
            "beside moving bodies no particles may be finer than near_hull, and a [[refine]] asks for finer ones: a "
            "body is advanced with the particles of the one size around it, and finer ones would load it between its "
            "steps");
    const bool stages = !Schedule(setup.scheme).stages().empty();
    if (stages && !std::ranges::all_of(bodies, [](const auto& body) { return body->prescribed(); }))
        throw InputError(
            "free bodies need a time step with one evaluation, [sph] scheme \"kick_drift_kick\": their added mass is "
            "taken into account once a step, with an acceleration relaxed from step to step");
    if (setup.scheme != Scheme::kick_drift_kick &&
        std::ranges::any_of(bodies, [](const auto& body) { return body->is_deformable(); }))
        throw InputError(
            "elastic bodies need [sph] scheme \"kick_drift_kick\": water and structure meet in the middle of its "
            "drift");
}

}  // namespace

Simulation::Simulation(const SimulationSetup& setup, const Fluid& fluid, const Passes& passes)
    : Simulation(setup, std::span<const Fluid>(&fluid, 1), passes) {}

Simulation::Simulation(const SimulationSetup& setup, std::span<const Fluid> fluids, const Passes& passes)
    : setup_(setup),
      passes_(&passes),
      around_(std::make_unique<Surroundings>(static_cast<const Surroundings&>(setup))),
      bodies_(std::make_unique<Bodies>()) {
    const Threads own(setup.threads);
    const std::size_t finest = setup.zones.size();
    for (const BodySetup& body : setup.bodies) bodies_->push_back(Body::of(body));
    refuse_unsolved(setup, *bodies_);
    for (std::size_t k = 0; k <= finest; ++k) {
        LevelSetup level = setup;
        level.dp = std::ldexp(setup.dp, static_cast<int>(finest - k));
        levels_.push_back(std::make_unique<Level>(*around_, level, setup.effects, Schedule(setup.scheme), *bodies_,
                                                  *passes_, fluids[k]));
    }
    levels_.front()->share().refuse_idle(
        levels_.front()->system().ranks().size());  // finer ones may have few particles, or none yet
    refinements_.reserve(finest);
    for (std::size_t k = 0; k < finest; ++k)
        refinements_.emplace_back(*levels_[k], *levels_[k + 1], setup.zones[k], k > 0 ? &refinements_[k - 1] : nullptr);
    std::vector<RefinementLevel> refinement_levels(finest + 1);
    for (std::size_t k = 0; k <= finest; ++k) {
        refinement_levels[k].add(*levels_[k]);
        if (k < finest) refinement_levels[k].edge = &refinements_[k];
    }
    stepper_.emplace(std::move(refinement_levels), *bodies_, setup, setup.moment_reference);
    if (all_fixed(*bodies_)) return;
    collisions_.emplace(*bodies_, *around_, setup.dp);
    if (finest > 0) collisions_->stay_within(refinements_.back().zone());
    const WaterNear near{setup.rho0,  setup.dp,        setup.state_equation.c0, setup.gravity, setup.moment_reference,
                         setup.frame, setup.dimensions};
    for (std::size_t b = 0; b < bodies_->size(); ++b)
        if (!(*bodies_)[b]->fixed()) (*bodies_)[b]->meet(near, this->finest().system().walls.dummies(b));
}

Level& Simulation::add_gas(LevelSetup setup, const EffectOptions& effects, const Fluid& fluid) {
    const Threads own(setup_.threads);
    if (!refinements_.empty())
        throw InputError(
            setup.material +
            " beside the water needs particles of one size, [sph] levels = 1: at the edge between two sizes "
            "fields are interpolated within one material, and density and pressure gradient jump across the "
            "water's surface");
    gas_ = levels_
               .emplace_back(std::make_unique<Level>(*around_, std::move(setup), effects, Schedule(setup_.scheme),
                                                     *bodies_, *passes_, fluid))
               .get();
    gas_->share_pencils_with(level(0));
    stepper_->add(*gas_);
    return *gas_;
}

std::optional<std::size_t> Simulation::hull_index() const {
    const auto found = std::ranges::find_if(*bodies_, [](const auto& body) { return body->is_hull(); });
    if (found == bodies_->end()) return {};
    return static_cast<std::size_t>(found - bodies_->begin());
}

const Body* Simulation::hull() const {
    const std::optional<std::size_t> index = hull_index();
    return index ? (*bodies_)[*index].get() : nullptr;
}

void Simulation::step() {
    const Threads own(setup_.threads);
    try {
        stepper_->step();
    } catch (const RunError& failure) {
        refuse_collisions(setup_.dp,
                          fmt::format(". No whole particle of water was left between them: {}", failure.what()));
        throw;
    }
    if (!refinements_.empty()) follow_bodies();
    refuse_collisions(0, "");
}

void Simulation::refuse_collisions(double gap, const std::string& seen) const {
    if (!collisions_) return;
    if (const std::string collision = collisions_->found(gap); !collision.empty())
        throw RunError(
            fmt::format("{} at t = {:.6g} s (step {}), and what comes then is not solved: end the run "
                        "before it, or give the body more room{}",
                        collision, time(), steps(), seen));
}

void Simulation::mark_restart_point() {
    for (const auto& level : levels_) level->mark_restart_point();
}

void Simulation::follow_bodies() {
    for (const auto& level : levels_) level->follow_bodies();
    if (!setup_.zones_round) return;
    std::vector<MovedSolid> moving;
    for (const auto& body : *bodies_)
        if (!body->fixed()) moving.push_back(body->moved());
    std::vector<Zone> zones = setup_.zones_round(moving);
    for (std::size_t k = 0; k < refinements_.size(); ++k) refinements_[k].set_zone(std::move(zones[k]));
}

Load Simulation::load() const {
    Load sum;
    for (const Load& load : stepper_->loads()) sum += load;
    return sum;
}

/// Each point by the level that owns its place; a flux by the one that has the control volume.
void Simulation::sample_levels(PointSamples& points) {
    if (points.want_flux) return at_bodies().fields().sample(points);
    const std::size_t n = points.places.size();
    points.p.assign(n, 0);
    points.support.assign(n, 0);
    const auto within = [&](const Refinement& edge) {
        std::vector<char> yes(n);
        for_particles(n, [&](std::size_t i) { yes[i] = edge.zone().outside(points.places[i]) < 0; });
        return yes;
    };
    std::vector<char> reached(n, 1);
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        PointSamples own;
        std::vector<std::size_t> who;
        std::vector<char> finer = k < refinements_.size() ? within(refinements_[k]) : std::vector<char>(n, 0);
        for (std::size_t i = 0; i < n; ++i)
            if (reached[i] && !finer[i]) own.places.push_back(points.places[i]), who.push_back(i);
        reached = std::move(finer);
        levels_[k]->fields().sample(own);
        for (std::size_t j = 0; j < who.size(); ++j) {
            points.p[who[j]] = own.p[j];
            points.support[who[j]] = own.support[j];
        }
    }
}

void Simulation::sample(PointSamples& points) {
    if (!refinements_.empty()) return sample_levels(points);
    const Level& water = level(0);  // of which a rank may hold nothing
    if (water.system().ranks().sum(std::int64_t{water.fields().can_be_sampled()}) == 0) stepper_->look();
    level(0).fields().sample(points);
    if (levels_.size() == 1) return;
    const std::size_t n = points.places.size();
    std::vector<float> sum(n, 0), weight(n, 0);
    double lid = 0;
    for (const auto& level : levels_) {
        PointSamples of_level{points.places, false, {}, {}, {}};
        level->fields().sample(of_level);
        for (std::size_t k = 0; k < n; ++k) {
            sum[k] += of_level.p[k] * of_level.support[k];
            weight[k] += of_level.support[k];
        }
        if (level->system().setup.shut_in) lid = level->fields().lid_pressure();
    }
    for (std::size_t k = 0; k < n; ++k)
        if (weight[k] > 0) points.p[k] = sum[k] / weight[k] - static_cast<float>(lid);
}

double Simulation::bytes_on_device() const {
    double sum = 0;
    for (const auto& level : levels_) sum += level->maker().bytes_on_device();
    return sum;
}

double Simulation::bytes() const {
    double sum = stepper_->bytes();
    for (const auto& level : levels_) sum += level->bytes();
    return sum;
}

}  // namespace tw
