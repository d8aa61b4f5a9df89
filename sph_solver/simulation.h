#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sph_solver/bodies/body.h"
#include "sph_solver/bodies/collisions.h"
#include "sph_solver/effects/effects.h"
#include "sph_solver/levels/level.h"
#include "sph_solver/refinement/refinement.h"
#include "sph_solver/time/stepper.h"

namespace tw {

/// Everything a run of the engine starts from: the surroundings, the first level (the water), the bodies and the time
/// stepping. SI units.
struct SimulationSetup : Surroundings, LevelSetup, TimeOptions {
    EffectOptions effects;  ///< of the water
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
    Vec3 moment_reference = Vec3::Zero();  ///< [m]
    int threads = 0;                       ///< that make the steps; 0: as many as work already
};

/// The blocks of water: those that touch or overlap are one water, divided into boxes that do not overlap.
std::vector<std::vector<Box>> waters_of(const SimulationSetup& setup, std::span<const Box> blocks);
/// A lattice of about dp that fills each block, outside the bodies: its cells are stretched or pressed to go into the
/// block a whole number of times.
Fluid fill_with_fluid(const SimulationSetup& setup, const std::vector<Box>& blocks);
/// The same for each level of the setup's zones, coarsest first: those that stand in its zone, and the buffer particles
/// round it.
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
    /// what cannot be coupled.
    Simulation(const SimulationSetup& setup, std::span<const Fluid> levels, const Passes& passes = tw::passes());

    /// Puts a gas beside the water, on particles of the same size; before the first step.
    /// Throws InputError where the water has several sizes.
    Level& add_gas(LevelSetup setup, const EffectOptions& effects, const Fluid& fluid);

    void step();  ///< throws RunError, see Level::advance; and when a body that moves touches another solid

    const SimulationSetup& setup() const { return setup_; }
    const Passes& passes() const { return *passes_; }
    Surroundings& surroundings() { return *around_; }
    std::span<const std::unique_ptr<Level>> levels() const { return levels_; }
    Level& level(std::size_t k) { return *levels_[k]; }
    const Level& level(std::size_t k) const { return *levels_[k]; }
    const Bodies& bodies() const { return *bodies_; }
    const Body& body(std::size_t b) const { return *(*bodies_)[b]; }
    const Body* hull() const;                       ///< the body that is the scene's hull; null: there is none
    std::optional<std::size_t> hull_index() const;  ///< among the bodies
    /// The level of gas; null: there is none.
    const Level* gas() const { return gas_; }
    Level* gas() { return gas_; }

    double time() const { return level(0).system().time; }
    double dt() const { return level(0).system().dt; }
    std::int64_t steps() const { return level(0).system().steps; }
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
    const Load& load(std::size_t body) const { return stepper_->loads()[body]; }
    Load load() const;
    double bytes() const;
    double bytes_on_device() const;  ///< of those
    /// Processor time that elastic bodies took since the start or the restart, all threads together: the water's forces
    /// on their dummies and their own steps [s].
    double structure_seconds() const { return stepper_->structure_seconds(); }

    // of the first level: all the water where particles have one size
    const Particles& particles() const { return level(0).fields().particles(); }
    FieldsToSet fields_to_set() { return level(0).fields_to_set(); }
    double pressure(std::size_t i) const { return level(0).fields().pressure(i); }
    double mass() const { return level(0).system().mass; }
    double h() const { return level(0).system().h; }
    const Ledger& ledger() const { return level(0).system().ledger; }
    const Extremes& extremes() const { return level(0).system().extremes; }
    const Timers& timers() const { return level(0).timers(); }
    void set_control_volume(ControlVolume volume) { at_bodies().set_control_volume(std::move(volume)); }
    ControlVolume* control_volume() { return at_bodies().control_volume(); }
    const ControlVolume* control_volume() const {
        const std::optional<ControlVolume>& volume = at_bodies().system().control;
        return volume ? &*volume : nullptr;
    }

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
    /// Throws RunError where a body touches another solid or is within `gap` [m] of that; `seen` is added to its words.
    void refuse_collisions(double gap, const std::string& seen) const;
    void sample_levels(PointSamples& points);

    SimulationSetup setup_;
    const Passes* passes_;
    std::unique_ptr<Surroundings> around_;  // what follows refers to these two
    std::unique_ptr<Bodies> bodies_;
    std::vector<std::unique_ptr<Level>> levels_;  // the first are the water
    Level* gas_ = nullptr;                        // one of them
    std::vector<Refinement> refinements_;         // the k-th joins levels k and k + 1
    std::optional<Stepper> stepper_;
    std::optional<Collisions> collisions_;  // where a body moves
};

}  // namespace tw
