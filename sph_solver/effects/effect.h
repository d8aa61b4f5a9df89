#pragma once
#include <cstddef>
#include <limits>
#include <vector>

#include "sph_solver/fields/particles.h"
#include "sph_solver/ghosts/ghosts.h"
#include "sph_solver/parallel/halo.h"
#include "sph_solver/sweeps/passes.h"
#include "sph_solver/sweeps/views.h"

namespace tw {

struct LevelSetup;
struct Surroundings;
class Walls;

/// What an effect sees of one step, and what it may change: the pressure before the forces, and the rates after them.
/// Indices run over the particles, then over their mirror images; wall dummies have their own.
struct StepView {
    const Surroundings& around;
    const LevelSetup& level;
    Particles& particles;  ///< an effect changes what it has brought, else nothing
    WaterView water;
    WallView dummies;                ///< of the walls
    GradientPressureRecord* stress;  ///< may be changed before the forces
    RateRecord* rate;                ///< may be changed after them
    const Passes& passes;
    const std::vector<Group>& groups;
    const Walls& walls;
    const Ghosts& ghosts;
    const Comm& ranks;
    const Halo& halo;  ///< of the particles: what a sweep has left has to be told before anybody reads it
    double h, mass, time;

    std::size_t count() const { return particles.size(); }
    bool at_surface(std::size_t i) const { return (water.surface[i / 32] >> (i % 32) & 1u) != 0; }
};

/// One physical effect that a scene may do without. It is built only when it is on: off, it costs no array, no byte of
/// a restart file and no instruction of the passes, because it sweeps the neighbours in a pass of its own. What
/// it has to remember between steps is a quantity of the particles (`brings`), which a restart file holds as well.
class Effect {
public:
    virtual ~Effect() = default;
    /// What the level's particles have because of it.
    virtual With brings() const { return With::water; }
    /// The first sweep's sums are there, and the marks at the free surface; densities have not changed yet.
    virtual void after_first_sweep(const StepView&) {}
    /// Density and pressure are those of this step; `stress[i].p` of the particles may be changed.
    virtual void change_pressure(const StepView&) {}
    /// All forces of the engine itself are in `rate`; adds to it.
    virtual void add_rates(const StepView&) {}
    /// Largest stable step of this effect alone [s].
    virtual double largest_step(const LevelSetup&, double /*h*/) const {
        return std::numeric_limits<double>::infinity();
    }
    /// What the walls did to the water in `add_rates`, group by group as in SecondSweepData; empty: nothing.
    virtual const std::vector<WallLoad>& wall_loads() const {
        static const std::vector<WallLoad> none;
        return none;
    }
    virtual std::size_t bytes() const { return 0; }
};

}  // namespace tw
