#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/bodies/wall_pushes.h"
#include "sph_solver/domain/schedule.h"
#include "sph_solver/fields/fields_to_set.h"
#include "sph_solver/levels/particle_system.h"
#include "sph_solver/levels/rank_share.h"
#include "sph_solver/levels/step_maker.h"
#include "sph_solver/loops/stages.h"

namespace tw {

/// Where the time of a level's steps goes, by the clock [s].
struct Timers {
    double lists = 0, pruning = 0;    ///< made anew, with sorting, images and the nearest walls; in between
    double gradient = 0, forces = 0;  ///< the two pair loops
    double walls = 0;                 ///< places and pressures of dummies
    double effects = 0;
    double update = 0;   ///< packed arrays, images, density and pressure
    double advance = 0;  ///< the end of a step
    std::int64_t evaluations = 0, rebuilds = 0;

    double sum() const { return lists + pruning + gradient + forces + walls + effects + update + advance; }
};

/// One material on particles of one size, in time. What its particles are is a ParticleSystem; what of them this
/// process holds, a RankShare; how the parts of a step are made, a StepMaker: the processor, or a device. Level is the
/// order in which these act, and what others see. Others act on it from above (pairs/, edge_steps.h).
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
    /// From now on somebody else makes the steps, of this level's `system`; before the first step.
    void leave_steps_to(std::unique_ptr<StepMaker> maker) { steps_ = std::move(maker); }
    /// For who makes the steps, and tests: all others see the level by what follows.
    ParticleSystem& system() { return system_; }
    RankShare& share() { return share_; }
    StepMaker& maker() { return *steps_; }

    // --- what it is
    const LevelSetup& setup() const { return system_.setup; }
    double mass() const { return system_.mass; }  ///< of one particle [kg]
    double h() const { return system_.h; }
    double time() const { return system_.time; }
    double dt() const { return system_.dt; }
    std::int64_t steps() const { return system_.steps; }
    int dimensions() const { return system_.around.dimensions; }
    const Box& domain() const { return system_.around.domain; }
    const Kernel& kernel() const { return system_.kernel; }
    const FixedPoint& fixed_point() const { return system_.fixed_point; }
    const PencilGrid& grid() const { return system_.grid; }
    const Passes& passes() const { return system_.passes; }
    const Walls& walls() const { return system_.walls; }
    std::span<const std::unique_ptr<Effect>> effects() const { return system_.effects; }
    const Ledger& ledger() const { return system_.ledger; }
    const Extremes& extremes() const { return system_.extremes; }
    const Timers& timers() const { return timers_; }
    const std::vector<Cluster>& clusters() const { return system_.near.clusters; }
    std::int64_t live_pairs(const Cluster& g) const { return system_.live_pairs(g); }

    // --- its particles
    /// Those that this process holds: all, or its own and copies of those near them (`owns`).
    const Particles& particles() const { return on_host(); }
    /// The same where only places, velocities and kinds are asked for: less has to come from a device.
    const Particles& particles_in_motion() const {
        steps_->copy_motion_to_host();
        return system_.particles;
    }
    /// To give the particles another state than a run starts with, or between two steps.
    FieldsToSet fields_to_set();
    /// Particles of all ranks together.
    std::int64_t count() const {
        return ranks().many() ? share_.total() : static_cast<std::int64_t>(system_.particles.size());
    }
    KindCounts kinds() const;  ///< of the particles of all ranks
    double pressure(std::size_t i) const;
    /// Shepard sum of a particle at the last evaluation [-].
    double support(std::size_t i) const { return double(on_host().shift_support[i].support); }
    bool has_packed_arrays() const { return !system_.particles.gradient_pressure.empty(); }
    double visited_per_particle() const;  ///< pairs that a pair loop works through, useful or not
    double bytes() const;                 ///< memory of state, lists and walls, on a device too
    double bytes_on_device() const { return steps_->bytes_on_device(); }
    /// The larger of the fastest particle's speed and the stream's [m/s].
    double reference_speed() const;
    double density_of_row() const { return system_.density_of_row(); }
    /// Acceleration of all water alike now: gravity and the stream's [m/s2].
    Vec3 body_force() const;
    /// Mean pressure of the particles in the uppermost 2h of the domain [Pa]; 0 where there are none.
    double lid_pressure() const;
    /// For so many particles that are added: the first of their numbers.
    std::int64_t take_ids(std::int64_t count) {
        const std::int64_t first = system_.ledger.next_id;
        system_.ledger.next_id += count;
        return first;
    }
    /// Shepard sum below which a particle counts as free surface.
    void set_surface_support(double support) { system_.setup.surface_support = support; }
    void set_control_volume(ControlVolume volume);
    ControlVolume* control_volume() { return system_.control ? &*system_.control : nullptr; }
    const ControlVolume* control_volume() const { return system_.control ? &*system_.control : nullptr; }

    // --- what of it this process holds, see RankShare
    const Comm& ranks() const { return system_.ranks(); }
    void refuse_idle(int ranks) const { share_.refuse_idle(ranks); }
    bool owns(std::size_t i) const { return share_.owns(i); }
    std::size_t copies() const { return share_.copies(); }
    void share_pencils_with(Level& leading) { share_.share_pencils_with(leading.share_); }
    Particles gathered() const {
        on_host();
        return share_.gathered();
    }
    /// Calls `add(sum, i)` for every particle, and sums over all ranks; `Sum` as that of sum_over.
    template <class Sum, class Add>
    Sum sum_over_all(const Add& add) const {
        return ranks().sum(sum_over<Sum>(system_.particles.size(), [&](Sum& sum, std::size_t i) {
            if (owns(i)) add(sum, i);
        }));
    }

    // --- a step, called by Simulation in this order
    bool lists_outlived() const;
    /// How far a particle may have come since the lists were made, up to where the next evaluation sees it [m].
    double travel_ahead() const;
    /// The walls likewise [m].
    double wall_travel_ahead() const;
    bool lists_due() const { return system_.near.life.over; }
    void make_lists_due() { system_.near.life.over = true; }
    void mark_restart_point();  ///< see Simulation
    void follow_bodies() { system_.walls.follow(system_.fixed_point); }
    void refresh(double drift);
    /// `other`: sums over another level's particles, one entry a particle; null: there is none.
    void first_pair_loop(double t, double compress, double drift, const OtherSums* other);
    void second_pair_loop(double t);
    /// Of several ranks: the rates are whole, and sent to the ranks with copies (halo exchange).
    void exchange_rates() { steps_->exchange_rates(); }
    /// Loads on bodies that stay where they are may wait for the end of `advance`.
    void gather_loads(const Vec3& moment_reference);
    /// Of the level's water on the dummies of one body, in the order in which the walls hold them
    /// (loops/force_on_dummies.h) [N]. Their sum is the pressure's part of the body's load, to the rounding of single
    /// precision; what edges release (edge_release.h) is not in them.
    std::vector<Vec3> forces_on_dummies(std::size_t body);
    void set_step(double dt) { system_.dt = dt; }
    /// What particles that a wall had to hold did to the bodies in a step.
    struct Impulses {
        std::vector<Impulse> bodies;        ///< each of them
        std::vector<WallImpulse> places{};  ///< of elastic ones
    };
    /// Throws RunError: not a number, density or Mach number out of bounds.
    Impulses advance(const Schedule::Move& move, const Vec3& moment_reference);

    // --- steps in stages (explicit Runge-Kutta) instead of one evaluation
    void begin_stages(bool freeze_diffusion);
    void go_to_stage(double since);
    void add_stage(double weight, bool first, bool freeze_diffusion);
    /// Back to the step's begin, with the mean rates and loads of all stages.
    void end_stages();

    // --- where levels of two sizes meet; before the first step
    /// A finer level's zone lies in this one, and particles that are nearer to it than `with_children` [m] have
    /// daughters.
    void begin_over(const Zone& finer, double with_daughters);
    /// This level's zone lies in a coarser one, and particles outside it are buffer particles.
    void begin_within(const Zone& own);
    EdgeSteps& edges() { return *steps_; }  ///< of a level that has begun so
    using Numbers = RankShare::Numbers;
    Numbers number_by_pencil(const std::vector<std::int32_t>& by) const { return share_.number_by_pencil(by); }
    std::vector<Located> of_all_ranks(std::vector<Located> own) const { return share_.of_all_ranks(std::move(own)); }
    std::int64_t among_all(std::size_t i) const { return share_.among_all(i); }
    std::optional<std::size_t> owned(std::int64_t among_all) const { return share_.owned(among_all); }

    // --- what others ask of its fields
    /// For loops of others, by who makes the steps.
    StepView step_view(double t) { return steps_->step_view(t); }
    FirstPairLoopData first_pair_loop_data() { return system_.first_pair_loop_data(); }
    SecondPairLoopData second_pair_loop_data(double t) { return system_.second_pair_loop_data(t); }
    /// Pressure, Shepard sum and (where the points want it) carried pressure at points, from the present packed
    /// arrays.
    void sample(PointSamples& points) const;
    /// Velocity and density of the particles at places near them, as they are between two pair loops. The lists must
    /// not be due. Of several ranks all call it, each with places of its own.
    void interpolate(FieldsAt& at) { steps_->interpolate(at); }

    /// What a restart needs beside the particles.
    struct State {
        double time = 0, dt = 0;  ///< [s]
        std::int64_t steps = 0;
        Ledger ledger;
        Extremes extremes;
    };
    State state() const;
    void restore(const State& state, Particles particles);
    /// Takes particles out of the run by their ids, of which so many that are `active` count as out, and goes on as
    /// after a restart. Of several ranks all call it with the ids of all, once their lists are made.
    void take_out(std::vector<std::int64_t> ids, std::int64_t active);

private:
    /// The particles, as they are now.
    const Particles& on_host() const {
        steps_->copy_all_to_host();
        return system_.particles;
    }
    void start_anew();  ///< with other particles than before
    /// Calls `act(effect, view)` for each effect, with what it sees of the step at time t.
    template <class Act>
    void each_effect(double t, const Act& act) {
        if (system_.effects.empty()) return;
        const StepView view = steps_->step_view(t);
        for (const auto& effect : system_.effects) act(*effect, view);
    }
    void note_compression();   ///< of a stage
    void put_walls(double t);  ///< where they are at a time

    // --- the parts of `advance`
    Move move_on(const Schedule::Move& move);
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

    // --- loads
    WallPushes push_particles();
    /// Of all ranks: pressed, rubbed and by bodies, one for each body.
    void set_loads(std::span<const PushSum> sums, const Vec3& moment_reference);
    void add_archimedes(std::size_t b, const Vec3& moment_reference, Load& load) const;

    ParticleSystem system_;
    RankShare share_;
    std::unique_ptr<StepMaker> steps_;
    Schedule schedule_;
    Timers timers_;
    std::vector<PushSum> waiting_loads_;  ///< of this rank; empty: none wait
    LoopArray<V3<double>> forces_on_dummies_;

    /// Of steps in stages only, else empty.
    struct {
        LoopArray<StageStart> start;
        LoopArray<StageMean> mean;
        LoopArray<float> compression, diffusion;  ///< see AddStage
        std::vector<Load> loads;                  ///< mean
    } stages_;
};

}  // namespace tw
