#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/levels/particle_system.h"
#include "sph_solver/levels/rank_share.h"
#include "sph_solver/levels/step_maker.h"

namespace tw {

/// What others ask of a level's particles. These may be in the memory of a device, and those of other ranks elsewhere:
/// what is asked for comes to the host first.
class LevelFields {
public:
    /// All must outlive this; another maker may take the place of the one that `steps` owns.
    LevelFields(const ParticleSystem& system, const RankShare& share, const std::unique_ptr<StepMaker>& steps)
        : system_(system), share_(share), steps_(steps) {}

    /// Those that this process holds: all, or its own and copies of those near them (RankShare::owns).
    const Particles& particles() const {
        steps_->copy_all_to_host();
        return system_.particles;
    }
    /// The same where only places, velocities and kinds are asked for: less has to come from a device.
    const Particles& particles_in_motion() const {
        steps_->copy_motion_to_host();
        return system_.particles;
    }
    double pressure(std::size_t i) const;  ///< [Pa]

    // --- of all ranks together
    std::int64_t count() const {
        return system_.ranks().many() ? share_.total() : static_cast<std::int64_t>(system_.particles.size());
    }
    KindCounts kinds() const;
    /// Calls `add(sum, i)` for every particle; `Sum` as that of sum_over.
    template <class Sum, class Add>
    Sum sum_over_all(const Add& add) const {
        return system_.ranks().sum(sum_over<Sum>(system_.particles.size(), [&](Sum& sum, std::size_t i) {
            if (share_.owns(i)) add(sum, i);
        }));
    }
    /// See RankShare::gathered.
    Particles gathered() const {
        steps_->copy_all_to_host();
        return share_.gathered();
    }
    /// Mean pressure of the particles in the uppermost 2h of the domain [Pa]; 0 where there are none.
    double lid_pressure() const;

    // --- at places that are none of the particles
    /// Whether an evaluation has left what `sample` works with.
    bool can_be_sampled() const { return !system_.particles.gradient_pressure.empty(); }
    /// Pressure, Shepard sum and (where the points want it) carried pressure at points, from the present packed
    /// arrays.
    void sample(PointSamples& points) const;
    /// Velocity and density of the particles at places near them, as they are between two pair loops. The lists must
    /// not be due. Of several ranks all call it, each with places of its own.
    void interpolate(FieldsAt& at) const { steps_->interpolate(at); }

private:
    const ParticleSystem& system_;
    const RankShare& share_;
    const std::unique_ptr<StepMaker>& steps_;
};

}  // namespace tw
