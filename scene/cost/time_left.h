#pragma once
#include <algorithm>

namespace tw {

/// Wall time that a run still takes [s]: as predicted for the whole run at first, by the rate so far from a fifth of it
/// on. First steps say little: caches are cold, and water may have yet to come to the finer particles.
/// `done`, `left`: shares of the run; `wall`: what the done one took [s]; `predicted`: 0 where nothing is.
inline double time_left(double done, double left, double wall, double predicted) {
    if (!(done > 0)) return left * predicted;
    const double trust = predicted > 0 ? std::min(1.0, done / 0.2) : 1;
    return left * (trust * wall / done + (1 - trust) * predicted);
}

}  // namespace tw
