#include "sph_solver/time/stepper.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "sph_solver/time/limits.h"

namespace tw {

void Tier::add(Level& level) {
    for (Level* other : levels) pairs.emplace_back(*other, level);
    levels.push_back(&level);
}

bool Tier::lists_outlived() const {
    return std::ranges::any_of(levels, [](const Level* level) { return level->lists_outlived(); }) ||
           std::ranges::any_of(pairs, [](const LevelPair& pair) { return pair.lists_outlived(); });
}

bool Tier::lists_due() const {
    return std::ranges::any_of(levels, [](const Level* level) { return level->lists_due(); });
}

void Tier::make_lists_due() const {
    for (Level* level : levels) level->make_lists_due();
}

Stepper::Stepper(std::vector<Tier> tiers, const Bodies& bodies, const TimeOptions& options,
                 const Vec3& moment_reference)
    : tiers_(std::move(tiers)),
      bodies_(bodies),
      schedule_(options.scheme),
      cfl_(options.cfl),
      moment_reference_(moment_reference),
      loads_(bodies.size()) {
    for (const auto& body : bodies) rehearsals_ = std::max(rehearsals_, body->rehearsals());
}

// --- a step ---------------------------------------------------------------------------------------------------------

void Stepper::advance(std::size_t k, double dt) {
    Tier& tier = tiers_[k];
    const bool finest = tier.edge == nullptr;
    const double before = tier.water().dt();
    if (tier.lists_outlived()) tier.make_lists_due();

    const auto [after, compress, drift] = schedule_.evaluation(before);
    const double t = tier.water().time() + after;
    if (schedule_.stages().empty()) {
        evaluate(tier, t, compress, drift);
        set_step(tier, dt > 0 ? dt : longest_step());
    } else {
        evaluate_stages(tier, dt);
    }

    const Schedule::Move move = schedule_.move(before, tier.water().dt());
    if (finest) {
        rehearse_bodies(tier, move, t);
        move_bodies(tier, move);
    }
    std::vector<Level::Struck> struck;
    for (Level* level : tier.levels) struck.push_back(level->advance(move, moment_reference_));
    add_loads(k, move.kick);
    if (finest) {
        for (const Level::Struck& by_level : struck) strike_bodies(by_level);
        return;
    }

    // The fine level's last evaluation was half its step before its present places, the coarse level's half its step.
    const double fine_before = tiers_[k + 1].water().dt(), first = move.kick / 2, second = tier.water().dt() / 2;
    tier.edge->prolong(move.kick, (before + fine_before) / 2);
    advance(k + 1, first);
    advance(k + 1, second);
    tier.edge->restrict_over(move.kick, fine_before / 2 + first - before / 2);
}

void Stepper::evaluate(Tier& tier, double t, double compress, double drift) {
    find_neighbours(tier, drift);
    for (LevelPair& pair : tier.pairs) pair.meet(t);
    for (Level* level : tier.levels) {
        const OtherSums* other = nullptr;
        for (const LevelPair& pair : tier.pairs)
            if (const OtherSums* sums = pair.sums_for(*level)) other = sums;
        level->first_sweep(t, compress, drift, other);
    }
    if (!tier.edge)
        for (const auto& body : bodies_) body->look_ahead(drift);
    press(tier, t);
}

void Stepper::press(Tier& tier, double t) {
    for (Level* level : tier.levels) level->second_sweep(t);
    for (LevelPair& pair : tier.pairs) pair.press(t);
    for (Level* level : tier.levels) level->tell_rates();
    for (Level* level : tier.levels) level->gather_loads(moment_reference_);
}

void Stepper::evaluate_stages(Tier& tier, double dt) {
    const bool freeze = schedule_.freezes_diffusion();
    const double start = tier.water().time();
    if (tier.lists_due()) find_neighbours(tier, tier.water().dt());
    for (Level* level : tier.levels) level->begin_stages(freeze);
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
        const double since = first ? 0 : stage.c * tier.water().dt();
        if (!first)
            for (Level* level : tier.levels) level->go_to_stage(since);
        place_bodies(since);
        evaluate(tier, start + since, 0, 0);
        if (first) set_step(tier, dt > 0 ? dt : longest_step());
        for (Level* level : tier.levels) level->add_stage(stage.weight, first, freeze);
    }
    for (Level* level : tier.levels) level->end_stages();
    place_bodies(0);
}

/// Records of who is where now and, where lists are due, those lists, good for a drift of `drift` [s]. And who is what at
/// the edge of the next finer tier.
void Stepper::find_neighbours(Tier& tier, double drift) {
    const bool due = tier.lists_due();
    if (due) {
        tier.make_lists_due();
        if (!tier.edge)
            for (const auto& body : bodies_) body->note_surface();
    }
    for (Level* level : tier.levels) level->refresh(drift);
    if (tier.edge) tier.edge->relabel();
    if (!due) return;
    for (LevelPair& pair : tier.pairs) pair.find_neighbours();
}

double Stepper::longest_step() const {
    const int finest = static_cast<int>(tiers_.size()) - 1;
    double dt = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < tiers_.size(); ++k)
        for (const Level* level : tiers_[k].levels)
            dt = std::min(dt, std::ldexp(stable_step(*level, cfl_), static_cast<int>(k)));
    for (const auto& body : bodies_) dt = std::min(dt, std::ldexp(body->stable_step(), finest));
    for (const auto& body : bodies_) dt = std::ldexp(body->step_within(std::ldexp(dt, -finest)), finest);
    return dt;
}

void Stepper::set_step(Tier& tier, double dt) const {
    for (Level* level : tier.levels) level->set_step(dt);
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
PointSamples felt(const Tier& tier, std::vector<Vec3> places) {
    PointSamples all{std::move(places), false, {}, {}, {}};
    tier.water().sample(all);
    for (std::size_t other = 1; other < tier.levels.size(); ++other) {
        PointSamples of{all.places, false, {}, {}, {}};
        tier.levels[other]->sample(of);
        for (std::size_t k = 0; k < all.p.size(); ++k) {
            const float both = all.support[k] + of.support[k];
            if (both > 0) all.p[k] = (all.support[k] * all.p[k] + of.support[k] * of.p[k]) / both;
            all.support[k] = both;
        }
    }
    return all;
}
}  // namespace

void Stepper::hand_over(const Tier& tier, Body& body, std::size_t b) {
    Load load = tier.water().walls().loads()[b];
    for (std::size_t other = 1; other < tier.levels.size(); ++other) load += tier.levels[other]->walls().loads()[b];
    body.take(load);
    if (std::vector<Vec3> places = body.feels_at(); !places.empty()) body.take(felt(tier, std::move(places)));
    if (!body.takes_forces_of_dummies()) return;
    for (Level* level : tier.levels) {
        body.take(*level->walls().attached(b), level->forces_on_dummies(b));
        for (const WallPush& push : level->walls().pushes())
            if (push.body == b) body.take(push);
    }
}

void Stepper::rehearse_bodies(Tier& tier, const Schedule::Move& move, double t) {
    for (int k = 0; k < rehearsals_; ++k) {
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            if (bodies_[b]->rehearsals() == 0) continue;
            const ProcessorTime spent(structure_seconds_);
            hand_over(tier, *bodies_[b], b);
            bodies_[b]->rehearse({move.kick, move.drifted, move.drift});
        }
        press(tier, t);
    }
}

void Stepper::move_bodies(const Tier& tier, const Schedule::Move& move) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ProcessorTime spent(structure_seconds_);
        hand_over(tier, *bodies_[b], b);
        bodies_[b]->move({move.kick, move.drifted, move.drift});
    }
}

void Stepper::strike_bodies(const Level::Struck& struck) {
    for (const WallStrike& strike : struck.places) bodies_[strike.body]->strike(strike);
    for (std::size_t b = 0; b < bodies_.size(); ++b) bodies_[b]->strike(struck.bodies[b]);
}

// --- loads ----------------------------------------------------------------------------------------------------------

void Stepper::begin_loads() { of_tiers_.assign(tiers_.size(), {std::vector<Load>(loads_.size()), 0}); }

void Stepper::add_loads(std::size_t k, double kick) {
    for (std::size_t b = 0; b < loads_.size(); ++b) of_tiers_[k].sum[b] += kick * tiers_[k].water().walls().loads()[b];
    of_tiers_[k].over += kick;
}

/// A single tier has made one step, with loads that need no mean.
void Stepper::end_loads() {
    if (tiers_.size() == 1) {
        loads_ = tiers_.front().water().walls().loads();
        return;
    }
    for (std::size_t b = 0; b < loads_.size(); ++b) {
        loads_[b] = {};
        for (const TierLoads& tier : of_tiers_) loads_[b] += (1 / tier.over) * tier.sum[b];
    }
}

double Stepper::bytes() const {
    double sum = 0;
    for (const Tier& tier : tiers_)
        for (const LevelPair& pair : tier.pairs) sum += double(pair.bytes());
    return sum;
}

}  // namespace tw
