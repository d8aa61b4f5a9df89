#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sph_solver/bodies/body.h"
#include "sph_solver/bodies/contact.h"
#include "sph_solver/pairs/level_pair.h"
#include "sph_solver/particles/level.h"
#include "sph_solver/refinement/refinement.h"
#include "sph_solver/time/schedule.h"

namespace tw {

/// Everything a run of the engine starts from: the surroundings, the first level (the water), the bodies and the time
/// stepping. SI units.
struct SimulationSetup : Surroundings, LevelSetup, TimeOptions {
    std::vector<BodySetup> bodies;
    /// Where the water belongs to finer particles at the start, the widest zone first; each halves the spacing, dp is
    /// that in the last. A body's load is that of each level's active particles. No edge is within 8 spacings of the
    /// coarse side of another edge, of an inlet, or (unless the zone goes on through it) of an outlet. Empty: all
    /// particles have one size.
    std::vector<Zone> zones;
    /// The last so many of them hold only parts of what is round the bodies; 0 where a body moves.
    std::size_t partial_zones = 0;
    /// As many zones for where the moving bodies are at some time, in the order of `bodies`. Asked after each step of
    /// the coarsest level. Not given: the zones stay.
    std::function<std::vector<Zone>(std::span<const MovedSolid> moving)> zones_round;
    Vec3 moment_reference = Vec3::Zero();
    int threads = 0;  ///< 0: as OpenMP chooses
};

/// The lattice of spacing dp in each block, outside the bodies.
Fluid fill_with_fluid(const SimulationSetup& setup, const std::vector<Box>& blocks);
/// The same for each level of the setup's zones, coarsest first: those that stand in its zone, and the guards round it.
std::vector<Fluid> fill_levels(const SimulationSetup& setup, const std::vector<Box>& blocks);
/// The same lattice in what the blocks of water leave of the domain; depth from the highest block's top.
Fluid fill_with_air(const SimulationSetup& setup, const std::vector<Box>& water);

/// A run of the engine: owns levels of particles, the pairs of levels that meet, bodies and the schedule, and steps
/// them. Any number of threads gives the same bits.
class Simulation {
public:
    /// One level of particles of the setup's material, whose setup has no zones. `passes`: the instruction set.
    Simulation(const SimulationSetup& setup, const Fluid& fluid, const Passes& passes = tw::passes());
    /// Levels of several sizes of particles, see SimulationSetup::zones and `fill_levels`. Throws InputError for
    /// another scheme than kick-drift-kick. Bodies that move need a scheme of one evaluation.
    Simulation(const SimulationSetup& setup, std::span<const Fluid> levels, const Passes& passes = tw::passes());

    /// Puts another material beside the levels that are there, on particles of the same size; before the first step.
    /// Throws InputError for a scheme in stages.
    Level& add_level(LevelSetup setup, const Fluid& fluid);

    void step();  ///< throws RunError, see Level::advance; and when a body that moves touches another solid

    const SimulationSetup& setup() const { return setup_; }
    const Passes& passes() const { return *passes_; }
    Surroundings& surroundings() { return *around_; }
    std::span<const std::unique_ptr<Level>> levels() const { return levels_; }
    Level& level(std::size_t k) { return *levels_[k]; }
    const Level& level(std::size_t k) const { return *levels_[k]; }
    const std::vector<Body>& bodies() const { return *bodies_; }
    std::vector<Body>& bodies() { return *bodies_; }

    double time() const { return level(0).time(); }
    double dt() const { return level(0).dt(); }
    std::int64_t steps() const { return level(0).steps(); }
    /// Levels of water, coarsest first: those before any other material.
    std::span<const std::unique_ptr<Level>> water() const { return {levels_.data(), refinements_.size() + 1}; }
    const Level& finest() const { return *levels_[refinements_.size()]; }
    Level& finest() { return *levels_[refinements_.size()]; }
    /// The finest level that holds all that is round the bodies.
    const Level& at_bodies() const { return *levels_[refinements_.size() - setup_.partial_zones]; }
    Level& at_bodies() { return *levels_[refinements_.size() - setup_.partial_zones]; }
    std::span<const Refinement> refinements() const { return refinements_; }
    std::span<Refinement> refinements() { return refinements_; }

    /// What the water does to a body, and to all of them together, in the last step; with levels of several sizes the
    /// sum over the levels of the mean over each one's steps in it.
    const Load& load(std::size_t body) const { return loads_[body]; }
    Load load() const;
    /// What level k did in its last step.
    Load load_of_level(std::size_t k) const;
    double bytes() const;
    /// Processor time that elastic bodies took since the start or the restart, all threads together: the water's forces
    /// on their dummies and their own steps [s].
    double structure_seconds() const { return structure_seconds_; }

    // of the first level: all the water where particles have one size
    const Particles& particles() const { return level(0).particles(); }
    Particles& particles() { return level(0).particles(); }
    double pressure(std::size_t i) const { return level(0).pressure(i); }
    double mass() const { return level(0).mass(); }
    double h() const { return level(0).h(); }
    const Ledger& ledger() const { return level(0).ledger(); }
    const Extremes& extremes() const { return level(0).extremes(); }
    const Timers& timers() const { return level(0).timers(); }
    void set_control_volume(ControlVolume volume) { at_bodies().set_control_volume(std::move(volume)); }
    ControlVolume* control_volume() { return at_bodies().control_volume(); }
    const ControlVolume* control_volume() const { return at_bodies().control_volume(); }

    /// Fields at points from the present particles; valid until the next step. Not part of the time integration. The
    /// pressure is that of all levels, relative to that under the lid where a level is shut in; the support is the
    /// first level's. `want_flux` needs a control volume.
    void sample(PointSamples& points);

    /// A restart goes on bitwise the same when this was called at that moment in both.
    void mark_restart_point();
    /// Puts dummies and zones where the bodies are now, so that the next time step is chosen by how fast those are.
    /// Called after a restart, and by each step of levels of several sizes.
    void follow_bodies();

private:
    /// Both sweeps at the present state of all levels, as of the time `t`. On the way the density changes for the time
    /// `compress` by the continuity equation, and the places for `drift` [s].
    void evaluate(double t, double compress, double drift);
    /// Its second sweep: pressures on walls, and forces.
    void press(double t);
    void step_in_stages();
    /// A step of level k, then two of the next finer one. `dt`: given by the coarser level; 0: to be chosen.
    void step_level(std::size_t k, double dt);
    void gather_loads();
    void take_loads();
    /// Hands the water's forces of the last evaluation to an elastic body.
    void push(ElasticBody& elastic, std::size_t body);
    /// Lets elastic bodies that ask for it try the step and hand over their acceleration (ElasticBody::rehearse).
    void rehearse_bodies(const Schedule::Move& move);
    /// Lets the water of the last evaluation kick the bodies, and moves them on.
    void move_bodies(const Schedule::Move& move);
    /// Throws RunError where a body touches another solid.
    void refuse_contact() const;
    /// What particles held at walls did to the bodies in Level::advance, which adds it to the loads `before`.
    void strike_bodies(const std::vector<Load>& before, double kick);
    void choose_time_step();
    void sample_levels(PointSamples& points);
    bool lists_outlived() const;
    void make_lists_due();

    SimulationSetup setup_;
    const Passes* passes_;
    Schedule schedule_;
    std::unique_ptr<Surroundings> around_;  // levels refer to these two
    std::unique_ptr<std::vector<Body>> bodies_;
    std::vector<std::unique_ptr<Level>> levels_;  // the first are the water
    std::vector<LevelPair> pairs_;
    std::vector<Refinement> refinements_;  // the k-th joins levels k and k + 1
    std::optional<Contacts> contacts_;     // where a body moves
    int coupling_iterations_ = 1;          // the most that an elastic body asks for
    double structure_seconds_ = 0;
    std::vector<Load> loads_;
    /// Time integrals of the loads by each level of water in the present step [N s], and their time [s].
    struct LevelLoads {
        std::vector<Load> sum;
        double over = 0;
    };
    std::vector<LevelLoads> of_levels_;
};

}  // namespace tw
