#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/bodies/wall_pushes.h"
#include "sph_solver/bodies/walls.h"
#include "sph_solver/domain/extremes.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/domain/schedule.h"
#include "sph_solver/domain/surroundings.h"
#include "sph_solver/effects/effect.h"
#include "sph_solver/fields/fields_to_set.h"
#include "sph_solver/fields/particles.h"
#include "sph_solver/ghosts/ghosts.h"
#include "sph_solver/ghosts/open_boundaries.h"
#include "sph_solver/levels/control_volume.h"
#include "sph_solver/levels/device_steps.h"
#include "sph_solver/levels/edges_at_home.h"
#include "sph_solver/levels/fields_at.h"
#include "sph_solver/loops/after_first_sweep.h"
#include "sph_solver/loops/count_kinds.h"
#include "sph_solver/loops/stages.h"
#include "sph_solver/loops/surface.h"
#include "sph_solver/neighbours/list_life.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/parallel/decomposition.h"
#include "sph_solver/parallel/halo.h"

namespace tw {

struct EffectOptions;

struct Timers {
    double lists = 0, gradient = 0, walls = 0, forces = 0, effects = 0, update = 0;  ///< [s] wall
    std::int64_t evaluations = 0, rebuilds = 0;
};

/// One material on particles of one size: its particles, records, neighbour lists, walls, ghosts, effects and time
/// step. Others act on it from above (pairs/, edge_steps.h); it refers to one to share columns (share_columns_with).
///
/// An evaluation of the rates takes two sweeps over the pairs, in this order (schedule.h says for how long what moves):
///
///   refresh           records of the particles and their images; lists, where they are due
///   first_sweep       at (x, u): div u, density gradient, kernel support;   rho -= compress rho div u;   x += drift u
///                     p = p(rho); effects change it
///   second_sweep      wall pressure; acceleration a, density diffusion D; effects add to them
///   advance           u += kick a;   rho += kick D;   x += drift u + shift;   walls, limits
///
/// So the velocity that compresses is the one that the pressure has just made (sound is carried without growth), and
/// the density gradient of the diffusion is one compression older than the density, which leaves water at rest alone
/// all the same.
class Level {
public:
    /// The particles start at the stream's velocity at t = 0 (at rest when it is ramped), under hydrostatic pressure.
    /// `around` and `bodies` must outlive the level.
    Level(const Surroundings& around, LevelSetup setup, const EffectOptions& effects, const Schedule& schedule,
          const Bodies& bodies, const Passes& passes, const Fluid& fluid);

    const LevelSetup& setup() const { return setup_; }
    double mass() const { return mass_; }  ///< of one particle [kg]
    double h() const { return h_; }
    double time() const { return time_; }
    double dt() const { return dt_; }
    std::int64_t steps() const { return steps_; }
    /// Those that this process holds: all, or its own and copies of those near them (`owns`).
    const Particles& particles() const { return home(); }
    /// The same where only places, velocities and kinds are asked for: less has to come from a device.
    const Particles& particles_in_motion() const {
        if (device_) device_->bring_motion_home();
        return particles_;
    }
    /// To give the particles another state than a run starts with, or between two steps.
    FieldsToSet fields_to_set();
    /// From now on a device makes the steps, see device_steps.h; before the first step.
    void leave_steps_to(std::unique_ptr<DeviceSteps> device) { device_ = std::move(device); }
    DeviceSteps* device() { return device_.get(); }  ///< null: this processor makes the steps
    const Comm& ranks() const;
    /// Throws InputError where so many ranks are more than the columns with particles; before the first step.
    void refuse_idle(int ranks) const;
    bool owns(std::size_t i) const { return own_.empty() || own_[i] != 0; }
    std::size_t copies() const { return halo_.received(); }
    std::int64_t live_pairs(const Group& g) const;  ///< that each of a group's particles meets, useful or not
    /// Particles of all ranks together.
    std::int64_t count() const { return ranks().many() ? total_ : static_cast<std::int64_t>(particles_.size()); }
    /// Calls `add(sum, i)` for every particle, and sums over all ranks; `Sum` as that of sum_over.
    template <class Sum, class Add>
    Sum sum_over_all(const Add& add) const {
        return ranks().sum(sum_over<Sum>(particles_.size(), [&](Sum& sum, std::size_t i) {
            if (owns(i)) add(sum, i);
        }));
    }
    /// From now on the columns go to the ranks as those of another level of the same columns do, which has its lists made
    /// first.
    void share_columns_with(Level& leading) { leading.following_ = this, columns_of_ = &leading; }
    /// All particles of all ranks, in the order in which one process holds them; on the first rank, elsewhere none.
    Particles gathered() const;
    KindCounts kinds() const;  ///< of the particles of all ranks
    double pressure(std::size_t i) const {
        const Particles& p = home();
        return double(setup_.state_equation.pressure(setup_.rho0, p.drho[i])) +
               (around_.at_rest ? around_.at_rest->at(p.z[i]) : 0);
    }
    const Ledger& ledger() const { return ledger_; }
    const Extremes& extremes() const { return extremes_; }
    const Timers& timers() const { return timers_; }
    const Walls& walls() const { return walls_; }
    const Passes& passes() const { return passes_; }
    std::span<const std::unique_ptr<Effect>> effects() const { return effects_; }
    double visited_per_particle() const;  ///< pairs that a sweep works through, useful or not
    double bytes() const;                 ///< memory of state, lists and walls, on a device too
    double bytes_on_device() const { return device_ ? device_->bytes() : 0; }
    /// The larger of the fastest particle's speed and the stream's [m/s].
    double reference_speed() const;
    int dimensions() const { return around_.dimensions; }
    const Box& domain() const { return around_.domain; }
    /// Kernel support of a particle at the last evaluation [-].
    double support(std::size_t i) const { return double(home().shift_support[i].support); }
    /// Density that the weight of one row of particles makes at rest, rho0 g dp / c0^2 [kg/m3].
    double density_of_row() const;
    /// Acceleration of all water alike now: gravity and the stream's [m/s2].
    Vec3 body_force() const;
    /// For so many particles that are added: the first of their numbers.
    std::int64_t take_ids(std::int64_t count) {
        const std::int64_t first = ledger_.next_id;
        ledger_.next_id += count;
        return first;
    }
    /// Mean pressure of the particles in the uppermost 2h of the domain [Pa]; 0 where there are none.
    double lid_pressure() const;

    // --- a step, called by Simulation in this order
    bool lists_outlived() const;
    /// How far a particle may have come since the lists were made, up to where the next evaluation sees it [m].
    double travel_ahead() const;
    /// The walls likewise [m].
    double wall_travel_ahead() const;
    bool lists_due() const { return life_.over; }
    void make_lists_due() { life_.over = true; }
    void mark_restart_point();  ///< see Simulation
    void follow_bodies() { walls_.follow(quanta_); }
    void refresh(double drift);
    /// `other`: sums over another level's particles, one entry a particle; null: there is none.
    void first_sweep(double t, double compress, double drift, const OtherSums* other);
    void second_sweep(double t);
    /// Of several ranks: the rates are whole, and told to who holds copies.
    void tell_rates() { halo_.tell(particles_.rate.data(), particles_.shift_support.data()); }
    /// Loads on bodies that stay where they are may wait for the end of `advance`.
    void gather_loads(const Vec3& moment_reference);
    /// Of the level's water on the dummies of one body, in the order in which the walls hold them
    /// (loops/force_on_dummies.h) [N]. Their sum is the pressure's part of the body's load, to the rounding of single
    /// precision; what edges release (edge_release.h) is not in them.
    std::vector<Vec3> forces_on_dummies(std::size_t body);
    void set_step(double dt) { dt_ = dt; }
    /// What particles that a wall had to hold did to the bodies in a step.
    struct Struck {
        std::vector<Impulse> bodies;       ///< each of them
        std::vector<WallStrike> places{};  ///< of elastic ones
    };
    /// Throws RunError: not a number, density or Mach number out of bounds.
    Struck advance(const Schedule::Move& move, const Vec3& moment_reference);

    // --- where levels of two sizes meet; before the first step
    /// A finer level's zone lies in this one, and particles that are nearer to it than `with_children` [m] have children.
    void begin_over(const Zone& finer, double with_children);
    /// This level's zone lies in a coarser one, and particles outside it are guards.
    void begin_within(const Zone& own);
    EdgeSteps& edges();  ///< of a level that has begun so

    // --- what all ranks have of something that some of this level's particles bring
    /// Of several ranks all of it, with indices in the order in which one process holds all; else `own`.
    std::vector<Located> of_all_ranks(std::vector<Located> own) const;
    std::int64_t among_all(std::size_t i) const;  ///< that index of one that this process owns
    /// The one that has it; nothing: another process owns it.
    std::optional<std::size_t> owned(std::int64_t among_all) const;
    /// The numbers 0, 1, ... of things of all ranks, each by a particle, in the order of these; `by` names those of the
    /// own things in ascending order.
    struct Numbers {
        std::vector<std::int64_t> own;
        std::int64_t all;
    };
    Numbers number_by_column(const std::vector<std::int32_t>& by) const;
    /// Where all ranks hold all particles still: leaves each to one of them, until the level's lists are made.
    void share_out();

    // --- steps in stages (explicit Runge-Kutta) instead of one evaluation
    void begin_stages(bool freeze_diffusion);
    void go_to_stage(double since);
    void add_stage(double weight, bool first, bool freeze_diffusion);
    /// Back to the step's begin, with the mean rates and loads of all stages.
    void end_stages();

    // --- what the sweeps of level pairs and effects read
    WaterView water_view() const;
    WallView wall_view() const;
    FirstSweepData first_sweep_data();
    SecondSweepData second_sweep_data(double t);
    StepView step_view(double t);  ///< of who makes the steps
    const std::vector<Group>& groups() const { return groups_; }
    const ColumnGrid& grid() const { return grid_; }
    const Quanta& quanta() const { return quanta_; }
    const Kernel& kernel() const { return kernel_; }
    /// Where neighbours among this level's particles and images are looked for.
    std::vector<Source> sources() const;

    /// Pressure, kernel support and (where the points want it) carried pressure at points, from the present records.
    void sample(PointSamples& points) const;
    /// Velocity and density of the particles at places near them, as they are between two sweeps. The lists must
    /// not be due. Of several ranks all call it, each with places of its own.
    void interpolate(FieldsAt& at);
    /// Kernel support below which a particle counts as free surface.
    void set_surface_support(double support) { setup_.surface_support = support; }
    bool has_records() const { return !particles_.gradient_pressure.empty(); }

    void set_control_volume(ControlVolume volume) {
        control_ = std::move(volume);
        particles_.bring(With::control_volume);
        make_lists_due();
    }
    ControlVolume* control_volume() { return control_ ? &*control_ : nullptr; }
    const ControlVolume* control_volume() const { return control_ ? &*control_ : nullptr; }

    /// What a restart needs beside the particles.
    struct State {
        double time = 0, dt = 0;
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
    friend class LevelOnDevice;
    friend class EdgesAtHome;
    friend struct LevelInsides;                          ///< of tests
    static constexpr double held_at_wall_over_dp = 0.1;  ///< nearer than this a particle is not let towards a wall

    /// The particles, as they are now.
    const Particles& home() const {
        if (device_) device_->bring_all_home();
        return particles_;
    }
    void start_anew();  ///< with other particles than before
    StateView state_view() {
        Particles& p = particles_;
        return {p.x.data(), p.y.data(), p.z.data(), p.u.data(), p.v.data(), p.w.data(), p.drho.data()};
    }
    void rebuild(double drift);
    void prune(double drift);
    void find_normals();
    /// How far lists that are made now look among particles, and between those and walls [m].
    struct ReachesOfLists {
        Reaches among, to_walls;
    };
    ReachesOfLists reaches_of_lists(double drift) const;
    double reach_of_normals() const { return 2 * kernel_.support() + setup_.dp; }  ///< of `find_normals` [m]
    [[noreturn]] void fail_through_wall(std::optional<std::size_t> particle);
    void update_records();
    void note_compression();   ///< of a stage
    void put_walls(double t);  ///< where they are at a time
    void mark_surface();
    /// Distance from which a neighbour may come within the support during `drift` [s] [m].
    double reach_among(double drift) const { return kernel_.support() + 2 * drift * life_.relative_speed; }
    double reach_to_walls(double drift) const {
        return kernel_.support() + drift * (extremes_.speed + walls_.fastest());
    }
    /// Speed away from the wall that particle i has near, relative to that wall, when it moves with `u` [m/s].
    double leaving(std::size_t i, const V3<double>& u) const {
        const Particles& p = particles_;
        const V3<double> n = normal_of(p.wall_normal[i]);
        const double of_water = dot(u, n);
        if (p.wall_body.empty()) return of_water;
        const std::int32_t triangle = p.wall_triangle.empty() ? -1 : p.wall_triangle[i];
        const Vec3 of_wall = walls_.velocity_at(p.wall_body[i], {p.x[i], p.y[i], p.z[i]}, triangle);
        return of_water - dot(V3<double>{of_wall.x(), of_wall.y(), of_wall.z()}, n);
    }
    ToQuanta to_quanta() const {
        const Vec3& o = quanta_.origin;
        return {o.x(), o.y(), o.z(), quanta_.per_metre, static_cast<float>(mass_), static_cast<float>(setup_.rho0)};
    }
    AfterFirstSweep after_first_sweep(double compress, double drift);
    LacksSupport lacks_support() const {
        const Particles& p = particles_;
        return {p.kind.data(), p.trend.empty() ? nullptr : p.trend.data(), p.shift_support.data(),
                setup_.surface_support};
    }
    StepView step_view_here(double t);
    /// Calls `act(effect, view)` for each effect, with what it sees of the step at time t.
    template <class Act>
    void each_effect(double t, const Act& act) {
        if (effects_.empty()) return;
        const StepView view = step_view(t);
        for (const auto& effect : effects_) act(*effect, view);
    }
    ExtrapolateData extrapolation() const;  ///< from the present records; the caller says where to
    InterpolateData interpolation() const;  ///< the caller says of whom, where to and what
    Reaches reaches_of_interpolation() const;
    double reach_of_others() const;           ///< how far other levels look in this one while its lists hold [m]
    TakeGiving giving(const Asking& asking);  ///< the caller says where to
    void interpolate_here(FieldsAt& at);      ///< from the particles that this process holds
    void interpolate_together(FieldsAt& at);  ///< each place on the rank that owns its column
    double stream_velocity(double t) const { return around_.stream ? around_.stream->velocity(t) : 0; }

    struct Held {
        Vec3 lost;  ///< velocity of the particle, which the body gets by its mass [m/s]
        std::size_t body;
        std::int32_t triangle;
    };
    /// Takes what is nearest as the wall of particle i.
    void note_wall(std::size_t i, const Walls::Nearest& near);
    std::optional<Held> hold_at_wall(std::size_t i);
    std::string text_of_failure(std::size_t i, const std::string& what) const;
    /// Ends the run on all ranks, which all call it, with the text of the one whose particle is first in order.
    struct Failing {
        std::optional<std::size_t> at;  ///< a particle that this rank holds; none: it has none that fails
        std::int64_t order;             ///< among those of all ranks
        std::string what;
    };
    [[noreturn]] void fail_together(const Failing& failing) const;
    void check_density() const;

    // --- ranks
    std::int32_t column_of(std::size_t i) const;   ///< in which it stood when it was sorted last
    std::function<bool(int)> own_columns() const;  ///< empty: all are
    void begin_whole();
    /// Lets particles go, and copies of others' particles; lists are due then. Empty: only the copies.
    void let_go(const std::vector<int>& gone);
    ColumnGrid blocks() const;
    void add_work(std::vector<std::int64_t>& of_columns) const;
    /// Puts what all ranks have of blows in the order of their columns.
    template <class Blow>
    std::vector<Blow> of_all_ranks(const std::vector<Blow>& own, const std::vector<std::int32_t>& columns) const;
    void agree_on_crossings(const Ledger& before, const std::vector<std::int32_t>& entered);
    void divide_columns();
    void hold_columns(const std::vector<std::int32_t>& staying, double reach);
    void note_own();
    void tell_first_sweep();
    /// Of all ranks: pressed, rubbed and by bodies, one for each body.
    void set_loads(std::span<const PushSum> sums, const Vec3& moment_reference);
    void add_archimedes(std::size_t b, const Vec3& moment_reference, Load& load) const;
    void tell_samples(PointSamples& points) const;
    WallPushes push_particles();

    const Surroundings& around_;
    LevelSetup setup_;
    Schedule schedule_;
    const Bodies& bodies_;
    const Passes& passes_;
    std::vector<std::unique_ptr<Effect>> effects_;

    double h_, mass_, time_ = 0, dt_ = 0;
    double wall_speed_ = 0;  ///< of the fastest dummy at the last evaluation [m/s]
    std::int64_t steps_ = 0;
    Kernel kernel_;
    float given_back_;  ///< [m], a of WaterTouch
    Quanta quanta_;
    ColumnGrid grid_;
    Particles particles_;
    Ghosts ghosts_;
    Walls walls_;
    std::vector<std::int32_t> start_;  ///< first particle of each column
    std::vector<Group> groups_;
    NeighbourLists lists_;
    ListLife life_;
    std::optional<ControlVolume> control_;
    Ledger ledger_;
    Extremes extremes_;
    Timers timers_;

    std::unique_ptr<DeviceSteps> device_;  ///< null: this processor makes the steps
    EdgesAtHome at_home_{*this};           ///< unless a device does

    /// Of several ranks only.
    Decomposition columns_;
    Level *columns_of_ = nullptr, *following_ = nullptr;  ///< see share_columns_with
    Halo halo_;
    bool whole_ = false;                       ///< all ranks hold all particles, until lists are made
    std::vector<char> own_;                    ///< of each particle; empty: all are
    std::int64_t total_ = 0;                   ///< particles of all ranks
    std::vector<std::int32_t> group_columns_;  ///< in which the groups stand
    std::vector<PushSum> waiting_loads_;       ///< of this rank; empty: none wait
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
