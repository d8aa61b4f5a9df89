#pragma once
#include <span>
#include <vector>

#include "sph_solver/bodies/body.h"
#include "sph_solver/pairs/level_pair.h"
#include "sph_solver/levels/level.h"
#include "sph_solver/refinement/refinement.h"
#include "sph_solver/domain/schedule.h"

namespace tw {

/// The levels of one particle size: one for each material, which meet by pairs and take all steps together.
struct Tier {
    std::vector<Level*> levels = {};  ///< the first is the water
    std::vector<LevelPair> pairs = {};
    Refinement* edge = nullptr;  ///< to the next finer tier; null: this is the finest

    Level& water() const { return *levels.front(); }
    void add(Level& level);
    bool lists_outlived() const;
    bool lists_due() const;
    void make_lists_due() const;
};

/// The time integration: a step of the coarsest tier and all that belongs to it. What there is are data: tiers of one or
/// several particle sizes, coarsest first, of one or two materials; schemes of one evaluation or of several stages; and
/// bodies of all kinds. Bodies move with the finest tier.
class Stepper {
public:
    /// `bodies` and all levels must outlive this.
    Stepper(std::vector<Tier> tiers, const Bodies& bodies, const TimeOptions& options, const Vec3& moment_reference);

    void step() {
        begin_loads();
        advance(0, 0);
        end_loads();
    }
    /// Both sweeps of the only tier at the present state, for those who look at the fields before the first step.
    void look() { evaluate(tiers_.front(), tiers_.front().water().time(), 0, 0); }
    /// Puts another material beside those of the only tier.
    void add(Level& level) { tiers_.front().add(level); }

    /// What the water does to each body, see Simulation::load.
    const std::vector<Load>& loads() const { return loads_; }
    double structure_seconds() const { return structure_seconds_; }  ///< see Simulation::structure_seconds
    double bytes() const;                                            ///< of the pairs

private:
    /// A step of a tier, then two of the next finer one. `dt`: given by the coarser tier [s]; 0: to be chosen.
    void advance(std::size_t tier, double dt);
    /// Both sweeps of a tier as of the time `t`. On the way densities change for the time `compress` by the continuity
    /// equation, and places drift for `drift` [s].
    void evaluate(Tier& tier, double t, double compress, double drift);
    /// Its second sweep: pressures on walls, forces, and loads.
    void press(Tier& tier, double t);
    /// Explicit Runge-Kutta: every stage starts anew from the step's begin with the rates of the stage before, and the
    /// step is made with the weighted mean of all; loads are that mean too. Bodies are where they are prescribed to be.
    void evaluate_stages(Tier& tier, double dt);
    void find_neighbours(Tier& tier, double drift);
    /// The smallest of what all levels and bodies bear, for the coarsest tier [s].
    double longest_step() const;
    void set_step(Tier& tier, double dt) const;

    /// Lets bodies that ask for it try the step and hand over their acceleration, to which the water answers at once.
    void rehearse_bodies(Tier& tier, const Schedule::Move& move, double t);
    /// Lets the water of the last evaluation kick the bodies, and moves them on.
    void move_bodies(const Tier& tier, const Schedule::Move& move);
    /// Hands the forces of the last evaluation to a body.
    static void hand_over(const Tier& tier, Body& body, std::size_t index);
    void strike_bodies(const Level::Struck& struck);

    void begin_loads();
    void add_loads(std::size_t tier, double kick);
    void end_loads();

    std::vector<Tier> tiers_;
    const Bodies& bodies_;
    Schedule schedule_;
    double cfl_;
    Vec3 moment_reference_;
    int rehearsals_ = 0;  ///< the most that a body asks for in a step
    double structure_seconds_ = 0;
    std::vector<Load> loads_;
    /// Time integrals of the loads by a tier's water in the present step [N s], and their time [s].
    struct TierLoads {
        std::vector<Load> sum;
        double over = 0;
    };
    std::vector<TierLoads> of_tiers_;
};

}  // namespace tw
