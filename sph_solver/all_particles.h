#pragma once
#include <vector>

#include "sph_solver/simulation.h"

namespace tw {

/// The particles of all sizes at one moment, as one process holds them: of several ranks, which all make this, on the
/// first one, and elsewhere none.
class AllParticles {
public:
    explicit AllParticles(const Simulation& simulation) : simulation_(simulation) {
        for (const auto& level : simulation.levels())
            if (level->system().ranks().many()) gathered_.push_back(level->fields().gathered());
    }
    const Particles& of(std::size_t level) const {
        return gathered_.empty() ? simulation_.level(level).fields().particles() : gathered_[level];
    }

private:
    const Simulation& simulation_;
    std::vector<Particles> gathered_;  ///< by level; empty where this process has all
};

}  // namespace tw
