#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sph_solver/domain/schedule.h"
#include "sph_solver/fields/fields_to_set.h"
#include "sph_solver/levels/level_fields.h"
#include "sph_solver/levels/level_loads.h"
#include "sph_solver/levels/level_stages.h"
#include "sph_solver/levels/particle_system.h"
#include "sph_solver/levels/rank_share.h"
#include "sph_solver/levels/step_maker.h"
#include "sph_solver/levels/timers.h"

namespace tw {

/// One material on particles of one size, in time. What its particles are is a ParticleSystem; what of them this
/// process holds, a RankShare; how the parts of a step are made, a StepMaker: the processor, or a device. Level is the
/// order in which these act. Others read the particles by LevelFields, and act on them from above (pairs/,
/// edge_steps.h).
///
/// An evaluation of the rates takes two loops over the pairs, in this order (schedule.h says for how long what moves):
///
///   refresh           packed arrays of the particles and their images; lists, where they are due
///   first_pair_loop   at (x, u): div u, density gradient, Shepard sum;   rho -= compress rho div u;   x += drift u
///                     p = p(rho); effects change it
///   second_pair_loop  wall pressure; acceleration a, density diffusion D; effects add to them
///   advance           u += kick a;   rho += kick D;   x += drift u + shift;   walls, limits
///
/// So the velocity that compresses is the one that the pressure has just made (sound is carried without growth), and
/// the density gradient of the diffusion is one compression older than the density, which leaves water at rest alone
/// all the same.
class Level {
public:
    /// The particles start at the stream's velocity at t = 0 (at rest when it is ramped), under hydrostatic pressure.
    /// `around` and `bodies` must outlive the level. The processor makes the steps.
    Level(const Surroundings& around, LevelSetup setup, const EffectOptions& effects, const Schedule& schedule,
          const Bodies& bodies, const Passes& passes, const Fluid& fluid);
    /// From now on somebody else makes the steps: who `make` gives for this level's particles. Before the first step.
    using MakeMaker = std::function<std::unique_ptr<StepMaker>(ParticleSystem& system, RankShare& share)>;
    void leave_steps_to(const MakeMaker& make) { steps_ = make(system_, share_); }

    // --- its parts
    const ParticleSystem& system() const { return system_; }  ///< its particles are asked for by `fields`
    const RankShare& share() const { return share_; }
    const StepMaker& maker() const { return *steps_; }
    StepMaker& maker() { return *steps_; }  ///< for who acts on the level between the parts of a step
    const LevelFields& fields() const { return fields_; }
    LevelLoads& loads() { return loads_; }
    LevelStages& stages() { return stages_; }  ///< instead of one evaluation
    const Timers& timers() const { return timers_; }
    double bytes() const;  ///< memory of state, lists and walls, on a device too

    // --- before the first step
    /// Shepard sum below which a particle counts as free surface.
    void set_surface_support(double support) { system_.setup.surface_support = support; }
    void set_control_volume(ControlVolume volume);
    ControlVolume* control_volume() { return system_.control ? &*system_.control : nullptr; }
    void share_pencils_with(Level& leading) { share_.share_pencils_with(leading.share_); }
    /// A finer level's zone lies in this one, and particles that are nearer to it than `with_daughters` [m] have
    /// daughters.
    void begin_over(const Zone& finer, double with_daughters);
    /// This level's zone lies in a coarser one, and particles outside it are buffer particles.
    void begin_within(const Zone& own);

    // --- between two steps
    /// To give the particles another state than a run starts with.
    FieldsToSet fields_to_set();
    /// For so many particles that are added: the first of their numbers.
    std::int64_t take_ids(std::int64_t count);
    /// Takes particles out of the run by their ids, of which so many that are `active` count as out, and goes on as
    /// after a restart. Of several ranks all call it with the ids of all, once their lists are made.
    void take_out(std::vector<std::int64_t> ids, std::int64_t active);
    void mark_restart_point();  ///< see Simulation
    /// What a restart needs beside the particles.
    struct State {
        double time = 0, dt = 0;  ///< [s]
        std::int64_t steps = 0;
        Ledger ledger;
        Extremes extremes;
    };
    State state() const;
    void restore(const State& state, Particles particles);

    // --- a step, called by Stepper in this order
    bool lists_outlived() const;
    /// How far a particle may have come since the lists were made, up to where the next evaluation sees it [m].
    double travel_ahead() const;
    void make_lists_due() { system_.near.life.over = true; }
    void refresh(double drift);
    /// `other`: sums over another level's particles, one entry a particle; null: there is none.
    void first_pair_loop(double t, double compress, double drift, const OtherSums* other);
    void second_pair_loop(double t);
    void set_step(double dt) { system_.dt = dt; }
    /// What particles that a wall had to hold did to the bodies in a step.
    struct Impulses {
        std::vector<Impulse> bodies;        ///< each of them
        std::vector<WallImpulse> places{};  ///< of elastic ones
    };
    /// Throws RunError: not a number, density or Mach number out of bounds.
    Impulses advance(const Schedule::Move& move, const Vec3& moment_reference);
    void follow_bodies() { system_.walls.follow(system_.fixed_point); }

private:
    void start_anew();  ///< with other particles than before
    /// Calls `act(effect, view)` for each effect, with what it sees of the step at time t.
    template <class Act>
    void each_effect(double t, const Act& act) {
        if (system_.effects.empty()) return;
        const StepView view = steps_->step_view(t);
        for (const auto& effect : system_.effects) act(*effect, view);
    }
    void put_walls(double t);          ///< where they are at a time
    double wall_travel_ahead() const;  ///< as travel_ahead, of the walls [m]

    // --- the parts of `advance`
    Move move_on(const Schedule::Move& move);
    void carry_inlet(const Schedule::Move& move);
    struct Held {
        Vec3 lost;  ///< velocity of the particle, which the body gets by its mass [m/s]
        std::size_t body;
        std::int32_t triangle;
    };
    std::optional<Held> hold_at_wall(std::size_t i);
    void hold(std::size_t i, const Vec3& moment_reference, Moved& part);
    struct OfAllParts;
    OfAllParts join(const std::vector<Moved>& parts) const;
    void agree(OfAllParts& all, const Vec3& moment_reference);
    Impulses impulses_on_bodies(OfAllParts& all, double dt);
    void note_extremes(const OfAllParts& all);
    void note_travel(const OfAllParts& all, const Schedule::Move& move, double speed_before);
    void check_speed(const OfAllParts& all) const;
    void check_density() const;

    ParticleSystem system_;
    RankShare share_;
    std::unique_ptr<StepMaker> steps_;
    Schedule schedule_;
    Timers timers_;
    LevelFields fields_{system_, share_, steps_};
    LevelLoads loads_{system_, share_, steps_, schedule_};
    LevelStages stages_{system_, steps_, timers_};
};

}  // namespace tw
