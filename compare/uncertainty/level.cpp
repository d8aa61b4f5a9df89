#include "compare/uncertainty/level.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace tw {

std::vector<Level> finest_first(std::vector<Level> levels) {
    if (levels.empty()) throw InputError("no level found; expected at least one pair of spacing and value");
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const Level& l = levels[i];
        if (!std::isfinite(l.spacing) || l.spacing <= 0)
            throw InputError(
                fmt::format("level {}: spacing {} found; expected a finite number above zero", i + 1, l.spacing));
        if (!std::isfinite(l.value))
            throw InputError(fmt::format("level {} (spacing {}): value {} found; expected a finite number", i + 1,
                                         l.spacing, l.value));
    }
    std::ranges::sort(levels, {}, &Level::spacing);
    for (std::size_t i = 1; i < levels.size(); ++i)
        if (levels[i].spacing <= levels[i - 1].spacing * (1 + 1e-6))
            throw InputError(fmt::format("two levels of spacing {} found; expected a different spacing on every level",
                                         levels[i].spacing));
    return levels;
}

std::string to_string(Convergence convergence) {
    switch (convergence) {
        case Convergence::unknown: return "unknown";
        case Convergence::unchanged: return "unchanged";
        case Convergence::monotone: return "monotone";
        case Convergence::oscillatory: return "oscillatory";
        case Convergence::divergent: return "divergent";
        case Convergence::scattered: return "scattered";
    }
    return {};
}

bool same_but_for_rounding(double a, double b, double size) { return std::abs(a - b) <= 1e-13 * size; }

}  // namespace tw
