#pragma once
#include <span>
#include <vector>

#include "sph_solver/bodies/body.h"
#include "sph_solver/domain/schedule.h"
#include "sph_solver/levels/level.h"
#include "sph_solver/pairs/level_pair.h"
#include "sph_solver/refinement/refinement.h"

namespace tw {

/// The levels of one particle size: one for each material, which meet by pairs and take all steps together.
struct RefinementLevel {
    std::vector<Level*> levels = {};  ///< the first is the water
    std::vector<LevelPair> pairs = {};
    Refinement* edge = nullptr;  ///< to the next finer refinement level; null: this is the finest

    Level& water() const { return *levels.front(); }
    void add(Level& level);
    bool lists_outlived() const;
    bool lists_due() const;
    void make_lists_due() const;
};

/// The time integration: a step of the coarsest refinement level and all that belongs to it. What there is are data:
/// refinement levels of one or several particle sizes, coarsest first, of one or two materials; schemes of one
/// evaluation or of several stages; and bodies of all kinds. Bodies move with the finest refinement level.
class Stepper {
public:
    /// `bodies` and all levels must outlive this.
    Stepper(std::vector<RefinementLevel> refinement_levels, const Bodies& bodies, const TimeOptions& options,
            const Vec3& moment_reference);

    void step() {
        begin_loads();
        advance(0, 0);
        end_loads();
    }
    /// Both pair loops of the only refinement level at the present state, for those who look at the fields before the
    /// first step.
    void look() { evaluate(refinement_levels_.front(), refinement_levels_.front().water().system().time, 0, 0); }
    /// Puts another material beside those of the only refinement level.
    void add(Level& level) { refinement_levels_.front().add(level); }

    /// What the water does to each body, see Simulation::load.
    const std::vector<Load>& loads() const { return loads_; }
    double structure_seconds() const { return structure_seconds_; }  ///< see Simulation::structure_seconds
    double bytes() const;                                            ///< of the pairs

private:
    /// A step of a refinement level, then two of the next finer one. `dt`: given by the coarser refinement level [s];
    /// 0: to be chosen.
    void advance(std::size_t refinement_level, double dt);
    /// Both pair loops of a refinement level as of the time `t`. On the way densities change for the time `compress` by
    /// the continuity equation, and places drift for `drift` [s].
    void evaluate(RefinementLevel& refinement_level, double t, double compress, double drift);
    /// Its second pair loop: pressures on walls, forces, and loads.
    void press(RefinementLevel& refinement_level, double t);
    /// Explicit Runge-Kutta: every stage starts anew from the step's begin with the rates of the stage before, and the
    /// step is made with the weighted mean of all; loads are that mean too. Bodies are where they are prescribed to be.
    void evaluate_stages(RefinementLevel& refinement_level, double dt);
    void find_neighbours(RefinementLevel& refinement_level, double drift);
    /// The smallest of what all levels and bodies bear, for the coarsest refinement level [s].
    double longest_step() const;
    void set_step(RefinementLevel& refinement_level, double dt) const;

    /// Lets bodies that ask for it try the step and hand over their acceleration, to which the water answers at once.
    void sub_iterate_bodies(RefinementLevel& refinement_level, const Schedule::Move& move, double t);
    /// Lets the water of the last evaluation kick the bodies, and moves them on.
    void move_bodies(const RefinementLevel& refinement_level, const Schedule::Move& move);
    /// Hands the forces of the last evaluation to a body.
    static void hand_over(const RefinementLevel& refinement_level, Body& body, std::size_t index);
    void give_impulses(const Level::Impulses& impulses);

    void begin_loads();
    void add_loads(std::size_t refinement_level, double kick);
    void end_loads();

    std::vector<RefinementLevel> refinement_levels_;
    const Bodies& bodies_;
    Schedule schedule_;
    double cfl_;
    Vec3 moment_reference_;
    int sub_iterations_ = 0;  ///< the most that a body asks for in a step
    double structure_seconds_ = 0;
    std::vector<Load> loads_;
    /// Time integrals of the loads by a refinement level's water in the present step [N s], and their time [s].
    struct TierLoads {
        std::vector<Load> sum;
        double over = 0;
    };
    std::vector<TierLoads> of_refinement_levels_;
};

}  // namespace tw
