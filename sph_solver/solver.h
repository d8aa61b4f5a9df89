#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meshes/query.h"
#include "meshes/surface.h"
#include "sph_solver/measure/control_volume.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/ghosts/mirrors.h"
#include "sph_solver/ghosts/stream.h"
#include "sph_solver/neighbours/columns.h"
#include "sph_solver/backend/pass_data.h"
#include "sph_solver/particles/particles.h"
#include "sph_solver/effects/air.h"
#include "sph_solver/effects/effects.h"
#include "sph_solver/equations/state_equation.h"

namespace tw {

/// How a step is made: time_step.cpp, README.md ("The time step"), table in docs/validation.md ("Schemes").
enum class Scheme {
    symplectic_euler,      ///< one evaluation
    kick_drift_kick,       ///< one evaluation, its first sweep in the middle of the drift
    predictor_corrector,   ///< two: the explicit midpoint rule
    rk4_frozen_diffusion,  ///< four: Runge-Kutta, with the density diffusion of its first stage throughout
};

/// Beyond these a run is stopped: density deviation over rho0, and speed over c0 [-].
inline constexpr double largest_density_deviation = 0.3, largest_mach = 1.0;

/// Everything the engine needs to know, in SI units.
struct SolverSetup {
    const char* name = "particle";  ///< in messages
    int dimensions = 3;
    double dp = 0;  ///< particle spacing [m]
    double h_over_dp = 1.5;
    double rho0 = 1000;
    Vec3 gravity{0, 0, -9.81};
    StateEquation state_equation;
    double delta = 0.1;   ///< density diffusion
    double alpha = 0.01;  ///< artificial viscosity
    Scheme scheme = Scheme::kick_drift_kick;
    double cfl = 0.7;  ///< dt = cfl h / (c0 + |u|); kick-drift-kick is stable to about 1.5
    double shifting = 1;
    /// Kernel support sum_j V_j W_ij (walls and images counted; 1 in the interior, about 0.75 at a flat free surface)
    /// below which a particle counts as free surface and bears no tension.
    double surface_support = 0.9;
    /// From this support on a wall that comes nearer compresses the water, in full at 1.
    double touch_support = 0.9;
    /// Shifting acts from this support on; near the free surface only along it.
    double shifting_support = 0.95;
    /// Inside the water (kernel support above `shifting_support`, no wall within reach) p_j - p_i in place of p_j + p_i
    /// where p_i < 0: no clumping under tension, but pairs no longer cancel there.
    bool tension_control = false;
    /// Particles move freely inside; mirror planes lie on its faces.
    Box domain;
    Mirrors mirrors;
    std::optional<Stream> stream;
    std::vector<Surface> solids;  ///< closed, fixed; loads are those on all of them together
    /// Velocity of each solid's surface along itself, as of a belt [m/s]; empty: at rest. Felt by water that walls hold
    /// (effect viscosity, no slip).
    std::vector<Vec3> sliding;
    Vec3 moment_reference = Vec3::Zero();
    EffectOptions effects;
    /// A run whose density leaves rho0 by more than these shares of it is stopped.
    double largest_compression = largest_density_deviation, largest_rarefaction = largest_density_deviation;
    int threads = 0;
};

/// Force and moment of the water on the solids, as solved (a half model's half).
struct Load {
    Vec3 force = Vec3::Zero();     ///< [N] (per metre of width in two dimensions)
    Vec3 friction = Vec3::Zero();  ///< the part of it that is viscous [N]
    Vec3 moment = Vec3::Zero();    ///< about the setup's reference [N m]
};

/// What left and entered since the start, in particles.
struct Ledger {
    std::int64_t in = 0, out = 0, lost = 0;
    std::int64_t held = 0;  ///< times that a particle was stopped at a wall (see Solver::hold_at_wall), not particles
};

/// Beyond these the run goes on and its certificate says that the sound speed is too low: speed over c0 (the density's
/// error grows with its square) and compression [-].
inline constexpr double trusted_mach = 0.15, trusted_compression = 0.05;
/// The same of a gas, which may be compressed: speed over its sound speed [-].
inline constexpr double trusted_air_mach = 0.5;

/// Extremes of one step, for the gates and the time step.
struct Extremes {
    double speed = 0, acceleration = 0, density_deviation_low = 0, density_deviation_high = 0;
    std::int64_t fastest = -1;  ///< id of the fastest particle
    Vec3 fastest_place = Vec3::Zero(), densest_place = Vec3::Zero(), thinnest_place = Vec3::Zero();
};

struct Timers {
    double lists = 0, gradient = 0, walls = 0, forces = 0, effects = 0, update = 0;  ///< [s] wall
    std::int64_t evaluations = 0, rebuilds = 0;
};

/// Initial particles: places and depth below the surface of their block [m].
struct Fluid {
    std::vector<Vec3> places;
    std::vector<double> depth;
};
/// The lattice of spacing dp in each block, outside the solids.
Fluid fill_with_fluid(const SolverSetup& setup, const std::vector<Box>& blocks);
/// The same lattice in what the blocks of water leave of the domain; depth from the highest block's top.
Fluid fill_with_air(const SolverSetup& setup, const std::vector<Box>& water);

/// Delta-SPH of one level of particles, two sweeps over the pairs an evaluation. In time by default kick-drift-kick,
/// where the first sweep lies in the middle of the drift:
///
///   x += dt/2 u;   sweep 1 at (x, u):  div u, density gradient, kernel support;   rho -= dt rho div u
///   x += dt/2 u;   p = p(rho); wall pressure
///   sweep 2 at (x, rho): acceleration a, density diffusion D;      u += dt a;  rho += dt D;  x += shift
///
/// So the velocity that compresses is the one the pressure has just made (sound is carried without growth), and the
/// density gradient of the diffusion is one compression older than the density, which leaves water at rest alone all
/// the same.
class Solver {
public:
    /// The particles start at the stream's velocity at t = 0 (at rest when it is ramped), under hydrostatic pressure.
    Solver(SolverSetup setup, const Fluid& fluid);

    /// Puts a gas (effects/air.h) beside the water; before the first step. A lid closes the domain: what flies up
    /// bounces, the gas stays. Throws InputError for a scheme in stages, or where there is no room for gas.
    void add_air(const AirOptions& air, const Fluid& fluid);
    /// The gas as a solver of its own, stepped by this one; null when there is none.
    const Solver* air() const { return air_.get(); }
    Particles& air_particles() { return air_->particles_; }

    void step();  ///< throws RunError: NaN, density or Mach number out of bounds, particle through a wall
    double time() const { return time_; }
    std::int64_t steps() const { return steps_; }
    double dt() const { return dt_; }
    const SolverSetup& setup() const { return setup_; }
    const Particles& particles() const { return particles_; }
    Particles& particles() { return particles_; }
    double pressure(std::size_t i) const { return setup_.state_equation.pressure(setup_.rho0, particles_.drho[i]); }
    /// Mean pressure of a gas in the uppermost 2h of the domain [Pa].
    double lid_pressure() const;
    double mass() const { return mass_; }  ///< of one particle [kg]
    double h() const { return h_; }
    const Load& load() const { return load_; }
    const Ledger& ledger() const { return ledger_; }
    const Extremes& extremes() const { return extremes_; }
    const Timers& timers() const { return timers_; }
    double visited_per_particle() const;  ///< pairs that a sweep works through, useful or not
    std::size_t wall_particles() const { return wall_place_.size(); }
    double bytes() const;  ///< memory of state, lists and walls

    /// Fields at points from the present particles; valid until the next step. Not part of the time integration. The
    /// pressure is that of both phases, relative to that under the lid where there is air; the support the water's.
    /// `want_flux` needs a control volume.
    void sample(PointSamples& points);
    void set_control_volume(const Box& box) {
        control_ = ControlVolume(box);
        rebuild_due_ = true;
    }
    ControlVolume* control_volume() { return control_ ? &*control_ : nullptr; }

    /// The state a restart needs; a restart goes on bitwise the same when `mark_restart_point()` was called at that
    /// moment in both.
    struct Restart {
        double time = 0, dt = 0;
        std::int64_t steps = 0;
        Ledger ledger;
        Extremes extremes;
        std::int64_t next_id = 0;
        ControlVolume::State control;
    };
    Restart restart_state() const;
    void mark_restart_point() { rebuild_due_ = true; }
    void restore(const Restart& state, Particles particles);
    void restore_air(const Restart& state, Particles particles) { air_->restore(state, std::move(particles)); }

private:
    static constexpr double skin_over_dp = 0.3;       ///< slack of the particle lists
    static constexpr double wall_skin_over_dp = 0.6;  ///< slack of the lists between particles and walls

    /// Both sweeps at the present state, as of the time `t`. Between them the density changes for the time `compress`
    /// by the continuity equation, and the places for `drift` [s].
    void evaluate(double t, double compress, double drift = 0);
    /// Its parts: lists and records; first sweep and pressure; second sweep.
    void prepare(double drift);
    void first_sweep(double t, double compress, double drift);
    void second_sweep(double t);
    PassData pass_data(double t);
    StepView step_view(const PassData& d, double t) const;
    ExtrapolateData extrapolation() const;  ///< from the present records; the caller says where to
    /// Pressure of this phase, its support and (null: not) flux at places sorted by column.
    void extrapolate_to(const Source& sorted, std::vector<Group>& groups, std::vector<float>& p,
                        std::vector<float>& support, float* flux) const;
    /// Makes the lists anew, live as `prune` leaves them.
    void rebuild(double drift);
    /// Distance from which a neighbour may come within the support during `drift` [s] [m]; walls stand still.
    double reach_among(double drift) const { return kernel_.support() + 2 * drift * relative_speed_; }
    double reach_to_walls(double drift) const { return kernel_.support() + drift * extremes_.speed; }
    /// Leaves in the lists who is within reach now, or may be after `drift` [s] with the present velocities.
    void prune(double drift);
    std::vector<char> cross_open_boundaries();
    void build_wall();
    PlaceRecord place_record(std::size_t i) const {
        const Particles& p = particles_;
        return {quanta_.of(p.x[i], 0), quanta_.of(p.y[i], 1), quanta_.of(p.z[i], 2),
                static_cast<float>(mass_) / (static_cast<float>(setup_.rho0) + p.drho[i])};
    }
    bool lacks_support(std::size_t i) const { return shift_[i].support < setup_.surface_support; }
    void mark_surface();
    void update_records();
    /// Images of places and motions; `stress`: of all that the first sweep found, too.
    void update_mirror_images(bool stress);
    void find_normals();
    void gather_load();
    WallNormalRecord nearest_wall(std::size_t i, double reach) const;

    // the time step, time_step.cpp
    /// One stage of an explicit Runge-Kutta step: at t + c dt, reached with the rates of the stage before; its weight.
    struct Stage {
        double c, weight;
    };
    void step_symplectic_euler();
    void step_kick_drift_kick();
    void step_in_stages(std::span<const Stage> stages, bool freeze_diffusion);
    double reference_speed() const;
    void choose_time_step();
    /// How far a particle may have come since the lists were made, up to where the next evaluation sees it [m].
    double travel_ahead() const;
    bool lists_outlived() const;
    void go_to_stage(double since);
    void move(double dt, double drifted, double drift);
    void move_all(double dt, double drifted, double drift);
    std::optional<Vec3> hold_at_wall(std::size_t i);
    [[noreturn]] void fail_at(std::size_t i, const std::string& what) const;
    void check_bounds();

    SolverSetup setup_;
    double h_ = 0, mass_ = 0, time_ = 0, dt_ = 0;
    std::int64_t steps_ = 0, next_id_ = 0;
    Quanta quanta_;
    ColumnGrid grid_;
    Kernel kernel_;
    const Passes* passes_;
    std::vector<std::unique_ptr<Effect>> effects_;

    Particles particles_;
    std::optional<MirrorPlanes> mirror_planes_;
    std::vector<MirrorImage> images_;
    std::vector<PlaceRecord> place_;  // particles, then mirror images
    std::vector<VelocityDensityRecord> motion_;
    std::vector<GradientPressureRecord> stress_;
    std::vector<ShiftSupportRecord> shift_;
    std::vector<RateRecord> rate_;
    std::vector<WallNormalRecord> normal_;
    std::vector<CarriedShare> carried_;   // only with a control volume
    std::vector<std::uint32_t> surface_;  // see PassData
    std::vector<std::int32_t> start_, image_start_;
    std::vector<Group> groups_;
    NeighbourLists lists_, wall_lists_;
    std::vector<WallLoad> wall_load_;

    // solids
    std::vector<SurfaceQuery> queries_;
    std::vector<PlaceRecord> wall_place_;
    std::vector<float> wall_p_;
    std::vector<VelocityDensityRecord> wall_motion_;  // only when solids slide
    std::vector<std::int32_t> wall_start_;
    std::vector<Group> wall_groups_, live_wall_groups_;
    NeighbourLists wall_source_lists_;

    /// Of steps in stages only, else empty.
    struct {
        struct Start {
            double x, y, z;
            float u, v, w, drho;
        };
        struct Mean {
            double u, v, w, ax, ay, az, drho;  ///< velocity and rates, weighted over the stages
        };
        std::vector<Start> start;
        std::vector<Mean> mean;
        std::vector<float> compression, diffusion;  ///< -rho div u of this stage, D of the first [kg/m3/s]
    } stages_;

    std::unique_ptr<Solver> air_;
    Interface of_water_, of_air_;       // only with air
    const OtherSums* other_ = nullptr;  // what the other phase does to this one

    double travel_ = 0, travel_in_stream_ = 0;  ///< upper bounds since the last rebuild [m]
    double relative_speed_ = 0;                 ///< largest one relative to the stream after the last step [m/s]
    bool rebuild_due_ = true;
    std::optional<ControlVolume> control_;
    Load load_;
    Ledger ledger_;
    Extremes extremes_;
    Timers timers_;
};

}  // namespace tw
