#include "compare/uncertainty/runaway.h"

#include <fmt/format.h>

#include <cmath>

#include "compare/statistics/student_t.h"
#include "compare/uncertainty/triplet.h"

namespace tw {

namespace {

std::string of_three(std::span<const StudyLevel> levels) {
    const Triplet t = finest_triplet(levels);
    const double l21 = std::log(t.r21), l32 = std::log(t.r32), finest = t.eps21 / l21, coarser = t.eps32 / l32;
    if (t.convergence == Convergence::unchanged || coarser == 0 || !(finest / coarser >= 2 * (1 - 1e-9))) return {};
    // The half width of finest - 2 coarser, of the values' own noise and rounding.
    const double of_1 = 1 / l21, of_2 = 1 / l21 + 2 / l32, of_3 = 2 / l32;
    const double U = std::hypot(levels[0].half_width * of_1, levels[1].half_width * of_2, levels[2].half_width * of_3) +
                     levels[0].rounding * of_1 + levels[1].rounding * of_2 + levels[2].rounding * of_3;
    if (std::abs(finest - 2 * coarser) < U) return {};
    return fmt::format("the changes grow {:.2g}-fold from the coarser pair of sizes to the finest", finest / coarser);
}

/// |b|/s_b of phi = c + b ln h by least squares; infinite where the values lie on the line.
double significance_of_slope(std::span<const StudyLevel> levels) {
    const auto n = static_cast<double>(levels.size());
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (const StudyLevel& l : levels) x += std::log(l.h) / n, y += l.value / n;
    for (const StudyLevel& l : levels) {
        const double dx = std::log(l.h) - x, dy = l.value - y;
        xx += dx * dx, xy += dx * dy, yy += dy * dy;
    }
    const double RSS = std::max(0.0, yy - xy * xy / xx);
    return std::abs(xy / xx) / std::sqrt(RSS / (n - 2) / xx);
}

}  // namespace

std::string why_running_away(std::span<const StudyLevel> levels, const EcaHoekstra& eca) {
    if (equal_within_noise(levels)) return {};
    if (levels.size() == 3) return of_three(levels);
    if (eca.convergence != Convergence::divergent) return {};
    const double t = significance_of_slope(levels), t_95 = student_t_95(static_cast<double>(levels.size()) - 2);
    return t > t_95 ? eca.why_not : "";
}

}  // namespace tw
