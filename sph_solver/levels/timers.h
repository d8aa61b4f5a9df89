#pragma once
#include <cstdint>

namespace tw {

/// Where the time of a level's steps goes, by the clock [s].
struct Timers {
    double lists = 0, pruning = 0;    ///< made anew, with sorting, images and the nearest walls; in between
    double gradient = 0, forces = 0;  ///< the two pair loops
    double walls = 0;                 ///< places and pressures of dummies
    double effects = 0;
    double update = 0;   ///< packed arrays, images, density and pressure
    double advance = 0;  ///< the end of a step
    std::int64_t evaluations = 0, rebuilds = 0;

    double sum() const { return lists + pruning + gradient + forces + walls + effects + update + advance; }
};

}  // namespace tw
