#include "sph_solver/time/stepper.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "sph_solver/time/limits.h"

namespace tw {

void RefinementLevel::add(Level& level) {
    for (Level* other : levels) pairs.emplace_back(*other, level);
    levels.push_back(&level);
}

bool RefinementLevel::lists_outlived() const {
    return std::ranges::any_of(levels, [](const Level* level) { return level->lists_outlived(); }) ||
           std::ranges::any_of(pairs, [](const LevelPair& pair) { return pair.lists_outlived(); });
}

bool RefinementLevel::lists_due() const {
    return std::ranges::any_of(levels, [](const Level* level) { return level->system().near.life.over; });
}

void RefinementLevel::make_lists_due() const {
    for (Level* level : levels) level->make_lists_due();
}

Stepper::Stepper(std::vector<RefinementLevel> refinement_levels, const Bodies& bodies, const TimeOptions& options,
                 const Vec3& moment_reference)
    : refinement_levels_(std::move(refinement_levels)),
      bodies_(bodies),
      schedule_(options.scheme),
      cfl_(options.cfl),
      moment_reference_(moment_reference),
      loads_(bodies.size()) {
    for (const auto& body : bodies) sub_iterations_ = std::max(sub_iterations_, body->sub_iterations());
}

// --- a step ---------------------------------------------------------------------------------------------------------

void Stepper::advance(std::size_t k, double dt) {
    RefinementLevel& refinement_level = refinement_levels_[k];
    const bool finest = refinement_level.edge == nullptr;
    const double before = refinement_level.water().system().dt;
    if (refinement_level.lists_outlived()) refinement_level.make_lists_due();

    const auto [after, compress, drift] = schedule_.evaluation(before);
    const double t = refinement_level.water().system().time + after;
    if (schedule_.stages().empty()) {
        evaluate(refinement_level, t, compress, drift);
        set_step(refinement_level, dt > 0 ? dt : longest_step());
    } else {
        evaluate_stages(refinement_level, dt);
    }

    const Schedule::Move move = schedule_.move(before, refinement_level.water().system().dt);
    if (finest) {
        sub_iterate_bodies(refinement_level, move, t);
        move_bodies(refinement_level, move);
    }
    std::vector<Level::Impulses> impulses;
    for (Level* level : refinement_level.levels) impulses.push_back(level->advance(move, moment_reference_));
    add_loads(k, move.kick);
    if (finest) {
        for (const Level::Impulses& by_level : impulses) give_impulses(by_level);
        return;
    }

    // The fine level's last evaluation was half its step before its present places, the coarse level's half its step.
    const double fine_before = refinement_levels_[k + 1].water().system().dt, first = move.kick / 2,
                 second = refinement_level.water().system().dt / 2;
    refinement_level.edge->prolong(move.kick, (before + fine_before) / 2);
    advance(k + 1, first);
    advance(k + 1, second);
    refinement_level.edge->restrict_over(move.kick, fine_before / 2 + first - before / 2);
}

void Stepper::evaluate(RefinementLevel& refinement_level, double t, double compress, double drift) {
    find_neighbours(refinement_level, drift);
    for (LevelPair& pair : refinement_level.pairs) pair.meet(t);
    for (Level* level : refinement_level.levels) {
        const OtherSums* other = nullptr;
        for (const LevelPair& pair : refinement_level.pairs)
            if (const OtherSums* sums = pair.sums_for(*level)) other = sums;
        level->first_pair_loop(t, compress, drift, other);
    }
    if (!refinement_level.edge)
        for (const auto& body : bodies_) body->look_ahead(drift);
    press(refinement_level, t);
}

void Stepper::press(RefinementLevel& refinement_level, double t) {
    for (Level* level : refinement_level.levels) level->second_pair_loop(t);
    for (LevelPair& pair : refinement_level.pairs) pair.press(t);
    for (Level* level : refinement_level.levels) level->maker().exchange_rates();
    for (Level* level : refinement_level.levels) level->loads().gather(moment_reference_);
}

void Stepper::evaluate_stages(RefinementLevel& refinement_level, double dt) {
    const bool freeze = schedule_.freezes_diffusion();
    const double start = refinement_level.water().system().time;
    if (refinement_level.lists_due()) find_neighbours(refinement_level, refinement_level.water().system().dt);
    for (Level* level : refinement_level.levels) level->stages().begin(freeze);
    std::vector<std::vector<double>> bodies_at_start;
    for (const auto& body : bodies_) bodies_at_start.push_back(body->state());
    const auto place_bodies = [&](double since) {
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            bodies_[b]->restore(bodies_at_start[b]);
            bodies_[b]->look_ahead(since);
        }
    };
    for (const Stage& stage : schedule_.stages()) {
        const bool first = &stage == &schedule_.stages().front();
        const double since = first ? 0 : stage.c * refinement_level.water().system().dt;
        if (!first)
            for (Level* level : refinement_level.levels) level->stages().go_to(since);
        place_bodies(since);
        evaluate(refinement_level, start + since, 0, 0);
        if (first) set_step(refinement_level, dt > 0 ? dt : longest_step());
        for (Level* level : refinement_level.levels) level->stages().add(stage.weight, first, freeze);
    }
    for (Level* level : refinement_level.levels) level->stages().end();
    place_bodies(0);
}

/// Packed arrays of who is where now and, where lists are due, those lists, good for a drift of `drift` [s]. And who is
/// what at the edge of the next finer refinement level.
void Stepper::find_neighbours(RefinementLevel& refinement_level, double drift) {
    const bool due = refinement_level.lists_due();
    if (due) {
        refinement_level.make_lists_due();
        if (!refinement_level.edge)
            for (const auto& body : bodies_) body->note_surface();
    }
    for (Level* level : refinement_level.levels) level->refresh(drift);
    if (refinement_level.edge) refinement_level.edge->relabel();
    if (!due) return;
    for (LevelPair& pair : refinement_level.pairs) pair.find_neighbours();
}

double Stepper::longest_step() const {
    const int finest = static_cast<int>(refinement_levels_.size()) - 1;
    double dt = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < refinement_levels_.size(); ++k)
        for (const Level* level : refinement_levels_[k].levels)
            dt = std::min(dt, std::ldexp(stable_step(*level, cfl_), static_cast<int>(k)));
    for (const auto& body : bodies_) dt = std::min(dt, std::ldexp(body->stable_step(), finest));
    for (const auto& body : bodies_) dt = std::ldexp(body->step_within(std::ldexp(dt, -finest)), finest);
    return dt;
}

void Stepper::set_step(RefinementLevel& refinement_level, double dt) const {
    for (Level* level : refinement_level.levels) level->set_step(dt);
}

// --- bodies ---------------------------------------------------------------------------------------------------------

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

/// By all materials, each with its share of the support.
PointSamples felt(const RefinementLevel& refinement_level, std::vector<Vec3> places) {
    PointSamples all{std::move(places), false, {}, {}, {}};
    refinement_level.water().fields().sample(all);
    for (std::size_t other = 1; other < refinement_level.levels.size(); ++other) {
        PointSamples of{all.places, false, {}, {}, {}};
        refinement_level.levels[other]->fields().sample(of);
        for (std::size_t k = 0; k < all.p.size(); ++k) {
            const float both = all.support[k] + of.support[k];
            if (both > 0) all.p[k] = (all.support[k] * all.p[k] + of.support[k] * of.p[k]) / both;
            all.support[k] = both;
        }
    }
    return all;
}
}  // namespace

void Stepper::hand_over(const RefinementLevel& refinement_level, Body& body, std::size_t b) {
    Load load = refinement_level.water().system().walls.loads()[b];
    for (std::size_t other = 1; other < refinement_level.levels.size(); ++other)
        load += refinement_level.levels[other]->system().walls.loads()[b];
    body.take(load);
    if (std::vector<Vec3> places = body.feels_at(); !places.empty())
        body.take(felt(refinement_level, std::move(places)));
    if (!body.takes_forces_of_dummies()) return;
    for (Level* level : refinement_level.levels) {
        body.take(*level->system().walls.attached(b), level->loads().on_dummies(b));
        for (const WallPush& push : level->system().walls.pushes())
            if (push.body == b) body.take(push);
    }
}

void Stepper::sub_iterate_bodies(RefinementLevel& refinement_level, const Schedule::Move& move, double t) {
    for (int k = 0; k < sub_iterations_; ++k) {
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            if (bodies_[b]->sub_iterations() == 0) continue;
            const ProcessorTime spent(structure_seconds_);
            hand_over(refinement_level, *bodies_[b], b);
            bodies_[b]->sub_iterate({move.kick, move.drifted, move.drift});
        }
        press(refinement_level, t);
    }
}

void Stepper::move_bodies(const RefinementLevel& refinement_level, const Schedule::Move& move) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ProcessorTime spent(structure_seconds_);
        hand_over(refinement_level, *bodies_[b], b);
        bodies_[b]->move({move.kick, move.drifted, move.drift});
    }
}

void Stepper::give_impulses(const Level::Impulses& impulses) {
    for (const WallImpulse& impulse : impulses.places) bodies_[impulse.body]->take_impulse(impulse);
    for (std::size_t b = 0; b < bodies_.size(); ++b) bodies_[b]->take_impulse(impulses.bodies[b]);
}

// --- loads ----------------------------------------------------------------------------------------------------------

void Stepper::begin_loads() {
    of_refinement_levels_.assign(refinement_levels_.size(), {std::vector<Load>(loads_.size()), 0});
}

void Stepper::add_loads(std::size_t k, double kick) {
    for (std::size_t b = 0; b < loads_.size(); ++b)
        of_refinement_levels_[k].sum[b] += kick * refinement_levels_[k].water().system().walls.loads()[b];
    of_refinement_levels_[k].over += kick;
}

/// A single refinement level has made one step, with loads that need no mean.
void Stepper::end_loads() {
    if (refinement_levels_.size() == 1) {
        loads_ = refinement_levels_.front().water().system().walls.loads();
        return;
    }
    for (std::size_t b = 0; b < loads_.size(); ++b) {
        loads_[b] = {};
        for (const TierLoads& refinement_level : of_refinement_levels_)
            loads_[b] += (1 / refinement_level.over) * refinement_level.sum[b];
    }
}

double Stepper::bytes() const {
    double sum = 0;
    for (const RefinementLevel& refinement_level : refinement_levels_)
        for (const LevelPair& pair : refinement_level.pairs) sum += double(pair.bytes());
    return sum;
}

}  // namespace tw
