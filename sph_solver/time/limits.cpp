#include "sph_solver/time/limits.h"

#include <algorithm>
#include <cmath>

#include "sph_solver/levels/level.h"

namespace tw {

double stable_step(const Level& level, double cfl) {
    // Chosen, not derived: the Courant number of the first engine, kept when that of sound was raised (decision 003).
    constexpr double acceleration_limit = 0.45;
    const LevelSetup& s = level.system().setup;
    const double c0 = s.state_equation.c0, h = level.system().h, a = level.system().extremes.acceleration;
    double dt = cfl * h / (c0 + std::max(level.system().reference_speed(), level.system().walls.fastest()));
    if (a > 0) dt = std::min(dt, acceleration_limit * std::sqrt(h / a));
    if (s.alpha > 0) dt = std::min(dt, 0.25 * h * h / (s.alpha * h * c0));
    for (const auto& effect : level.system().effects) dt = std::min(dt, effect->largest_step(s, h));
    return dt;
}

}  // namespace tw
