#pragma once
#include <memory>

#include "sph_solver/levels/level.h"
#include "sph_solver/levels/on_processor.h"

namespace tw {

/// The particles of a level as who makes its steps has them: to be put into another order, or to be others than they
/// are. Before the first step.
inline ParticleSystem& system_to_change(Level& level) {
    ParticleSystem* system = nullptr;
    level.leave_steps_to([&](ParticleSystem& of_level, RankShare& share) {
        system = &of_level;
        return std::make_unique<LevelOnProcessor>(of_level, share);
    });
    return *system;
}

}  // namespace tw
