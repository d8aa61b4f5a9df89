#pragma once
#include "sph_solver/levels/level.h"

namespace tw {

/// A level's particles as its own files see them, for tests of what no other code can bring about.
struct LevelInsides {
    static Particles& particles(Level& level) { return level.particles_; }
};

}  // namespace tw
