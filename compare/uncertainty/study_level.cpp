#include "compare/uncertainty/study_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace tw {

std::vector<StudyLevel> finest_first(std::vector<StudyLevel> levels) {
    if (levels.empty()) throw InputError("no size found; expected at least one pair of spacing and value");
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const StudyLevel& l = levels[i];
        if (!std::isfinite(l.h) || l.h <= 0)
            throw InputError(
                fmt::format("level {}: spacing {} found; expected a finite number above zero", i + 1, l.h));
        if (!std::isfinite(l.value))
            throw InputError(
                fmt::format("level {} (spacing {}): value {} found; expected a finite number", i + 1, l.h, l.value));
    }
    std::ranges::sort(levels, {}, &StudyLevel::h);
    for (std::size_t i = 1; i < levels.size(); ++i)
        if (levels[i].h <= levels[i - 1].h * (1 + 1e-6))
            throw InputError(
                fmt::format("two rows of spacing {} found; expected a different spacing in every row", levels[i].h));
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
        case Convergence::irregular: return "irregular";
    }
    return {};
}

bool same_but_for_rounding(const StudyLevel& a, const StudyLevel& b, double size) {
    return std::abs(a.value - b.value) <= 1e-13 * size + a.rounding + b.rounding;
}

bool equal_within_noise(std::span<const StudyLevel> levels) {
    const double size = largest_magnitude(levels);
    for (std::size_t i = 0; i < levels.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const StudyLevel &a = levels[i], &b = levels[j];
            if (!same_but_for_rounding(a, b, size) &&
                std::abs(a.value - b.value) > std::hypot(a.half_width, b.half_width) + a.rounding + b.rounding)
                return false;
        }
    return true;
}

double largest_magnitude(std::span<const StudyLevel> levels) {
    double size = 0;
    for (const StudyLevel& l : levels) size = std::max(size, std::abs(l.value));
    return size;
}

}  // namespace tw
