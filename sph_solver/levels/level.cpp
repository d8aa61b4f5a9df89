#include "sph_solver/levels/level.h"

#include <algorithm>
#include <cmath>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/backend/stopwatch.h"
#include "sph_solver/levels/on_processor.h"

namespace tw {

Level::Level(const Surroundings& around, LevelSetup setup, const EffectOptions& effects, const Schedule& schedule,
             const Bodies& bodies, const Passes& passes, const Fluid& fluid)
    : system_(around, std::move(setup), effects, bodies, passes, fluid),
      share_(system_),
      steps_(std::make_unique<LevelOnProcessor>(system_, share_)),
      schedule_(schedule) {}

void Level::set_control_volume(ControlVolume volume) {
    system_.control = std::move(volume);
    system_.particles.allocate(With::control_volume);
    make_lists_due();
}

// --- the lists
// --------------------------------------------------------------------------------------------------------

double Level::travel_ahead() const {
    return system_.near.life.travel + schedule_.looks_ahead() * system_.dt * system_.extremes.speed;
}

bool Level::lists_outlived() const {
    const double relative =
        system_.near.life.travel_in_stream + schedule_.looks_ahead() * system_.dt * system_.near.life.relative_speed;
    const double wall_slack = ListLife::wall_slack_over_dp * system_.setup.dp;
    // two particles may both have moved towards each other
    return 2 * relative > system_.near.life.slack || travel_ahead() + wall_travel_ahead() > wall_slack;
}

double Level::wall_travel_ahead() const {
    return system_.near.life.wall_travel + schedule_.looks_ahead() * system_.dt * system_.walls.fastest();
}

void Level::refresh(double drift) {
    ListLife& life = system_.near.life;
    system_.walls.follow(system_.fixed_point);
    if (life.over) {
        const Stopwatch watch(timers_.lists);
        ++timers_.rebuilds;
        life.slack = system_.slack_of_lists();
        steps_->make_lists(drift);
        life.travel = life.travel_in_stream = life.wall_travel = life.since_walls = 0;
        life.over = false;
        return;
    }
    {
        const Stopwatch watch(timers_.update);
        steps_->pack_state();
    }
    const Stopwatch watch(timers_.pruning);
    steps_->prune(drift);
    if (!system_.walls.found_at_every_step()) return;
    steps_->find_walls();
    life.since_walls = 0;
}

// --- an evaluation of the rates: what is summed in it, in which order, is pair_loops/right_hand_side.h
// ---------------------

void Level::first_pair_loop(double t, double compress, double drift, const OtherSums* other) {
    {
        const Stopwatch watch(timers_.gradient);
        steps_->first_pair_loop(other);
    }
    const Stopwatch watch(timers_.update);
    steps_->exchange_first_sums();
    steps_->mark_surface();
    each_effect(t, [](Effect& effect, const StepView& view) { effect.after_first_pair_loop(view); });
    stages_.note_compression();
    steps_->compress(compress, drift);
    each_effect(t, [](Effect& effect, const StepView& view) { effect.change_pressure(view); });
    steps_->refresh_images(t);
}

void Level::second_pair_loop(double t) {
    timers_.evaluations += static_cast<std::int64_t>(system_.particles.size() - share_.copies());
    if (!system_.walls.empty()) {
        const Stopwatch watch(timers_.walls);
        put_walls(t);
        steps_->press_walls();
        steps_->exchange_pressures();
    }
    {
        const Stopwatch watch(timers_.forces);
        steps_->second_pair_loop(t);
    }
    const Stopwatch watch(timers_.effects);
    each_effect(t, [](Effect& effect, const StepView& view) { effect.add_rates(view); });
    steps_->copy_loads_to_host();
}

void Level::put_walls(double t) {
    system_.wall_speed = system_.walls.fastest();
    system_.walls.follow(system_.fixed_point);
    if (system_.around.frame && !system_.walls.empty())
        system_.walls.feel(system_.around.force(t), system_.around.gravity);
}

double Level::bytes() const { return system_.bytes() + stages_.bytes() + steps_->bytes_on_device(); }

// --- where levels of two sizes meet
// -----------------------------------------------------------------------------------

void Level::begin_over(const Zone& finer, double with_daughters) {
    Particles& p = system_.particles;
    p.allocate(With::finer);
    for (std::size_t i = 0; i < p.size(); ++i)
        if (finer.outside({p.x[i], p.y[i], p.z[i]}) < with_daughters) p.daughters[i] = Daughters::all;
}

void Level::begin_within(const Zone& own) {
    Particles& p = system_.particles;
    p.allocate(With::coarser);
    for (std::size_t i = 0; i < p.size(); ++i)
        if (own.outside({p.x[i], p.y[i], p.z[i]}) >= 0) p.kind[i] = Kind::buffer;
}

// --- state
// ------------------------------------------------------------------------------------------------------------

Level::State Level::state() const {
    return {system_.time, system_.dt, system_.steps, system_.ledger, system_.extremes};
}

void Level::restore(const State& s, Particles particles) {
    system_.time = s.time, system_.dt = s.dt, system_.steps = s.steps;
    system_.ledger = s.ledger, system_.extremes = s.extremes;
    particles.allocate_as(system_.particles);  // what is not saved is made anew where it is asked for
    system_.particles = std::move(particles);
    share_.begin_on_first();
    steps_->note_changed_state();
    start_anew();
}

FieldsToSet Level::fields_to_set() {
    steps_->copy_all_to_host();
    steps_->note_changed_state();
    return FieldsToSet(system_.particles);
}

void Level::take_out(std::vector<std::int64_t> ids, std::int64_t active) {
    system_.ledger.out += active;
    steps_->copy_all_to_host();
    steps_->note_changed_state();
    std::ranges::sort(ids);
    std::vector<int> gone(system_.particles.size());
    for_particles(gone.size(),
                  [&](std::size_t i) { gone[i] = std::ranges::binary_search(ids, system_.particles.id[i]); });
    share_.let_go(gone);
    share_.take_out(static_cast<std::int64_t>(ids.size()));
    start_anew();
}

std::int64_t Level::take_ids(std::int64_t count) {
    const std::int64_t first = system_.ledger.next_id;
    system_.ledger.next_id += count;
    return first;
}

void Level::mark_restart_point() {
    if (!system_.particles.has(With::finer)) return make_lists_due();
    // a finer level has changed velocities since the last step: the lists reach as far as after a restart
    steps_->copy_all_to_host();
    start_anew();
}

void Level::start_anew() {
    const Particles& p = system_.particles;
    const double stream = system_.stream_velocity(system_.time);
    double relative2 = 0;  // to the last bit as Move notes it: the slack of the lists goes with it
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double u = p.u[i] - stream, v = p.v[i], w = p.w[i];
        relative2 = std::max(relative2, u * u + v * v + w * w);
    }
    system_.near.life.relative_speed = system_.ranks().largest(std::sqrt(relative2));
    make_lists_due();
}

}  // namespace tw
