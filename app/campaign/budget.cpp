#include "app/campaign/budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "app/arguments/output.h"
#include "base/errors.h"
#include "compare/report/numbers.h"
#include "text/units.h"

namespace tw::app {
namespace {

constexpr int steps_of_two = 8;
constexpr int farthest = 4 * steps_of_two;  ///< sixteen times the scene's sizes, or a sixteenth

double scale_at(int step) { return std::pow(2, static_cast<double>(step) / steps_of_two); }

/// The family at so many times the scene's sizes; none: the scene does not allow all of its runs.
std::optional<PaidSizes> sizes_at(GridStudySizes family, double scale) {
    family.request.overrides.scale_resolution = scale;
    const GridStudyPlan plan = plan_grid_study(family, {});
    if (scale > 1 && !plan.left_out.empty()) return {};
    PaidSizes sizes{scale, std::numeric_limits<double>::infinity(), 0};
    for (const GridStudyJob& job : plan.jobs) {
        sizes.seconds += job.run.plan.seconds(job.run.method);
        sizes.near_hull = std::min(sizes.near_hull, job.run.plan.scene.resolution.near_hull);
    }
    return sizes;
}

}  // namespace

double budget_seconds(const std::string& budget) {
    if (budget.empty()) return std::numeric_limits<double>::infinity();
    try {
        if (const double seconds = quantity(budget, "s"); seconds > 0) return seconds;
    } catch (const UnitError& e) { throw InputError(fmt::format("--budget {}: {}", budget, e.what())); }
    throw InputError(fmt::format("--budget {}: expected a time above 0, e.g. 2h", budget));
}

PaidSizes sizes_for_budget(const GridStudySizes& family, double budget) {
    std::optional<PaidSizes> best = sizes_at(family, 1);
    double cheapest = best->seconds;
    const bool own_fits = cheapest <= budget;
    if (!own_fits) best.reset();
    /// Of a step, whether it takes too long, or is too fine for this machine; it may also be too coarse for the scene.
    const auto too_dear = [&](int step) {
        std::optional<PaidSizes> sizes;
        try {
            sizes = sizes_at(family, scale_at(step));
        } catch (const InputError&) {}
        if (!sizes) return step < 0;
        cheapest = std::min(cheapest, sizes->seconds);
        if (sizes->seconds > budget) return true;
        best = sizes;
        return false;
    };
    int low = 0, high = farthest;  // too dear, and not
    if (own_fits) {
        high = 0;
        // Time goes with h^-4 at most: what starts a run, and meshes, grow more slowly.
        low = std::min(-1, static_cast<int>(std::ceil(steps_of_two / 4.0 * std::log2(cheapest / budget))) - 1);
        while (low > -farthest && !too_dear(low)) high = low--;
    }
    while (low + 1 < high) {
        const int step = std::midpoint(low, high);
        (too_dear(step) ? low : high) = step;
    }
    if (best) return *best;
    throw InputError(fmt::format("--budget {}: no sizes that the scene allows fit; the cheapest found need {}",
                                 time_text(budget), about_text(cheapest)));
}

std::string first_impression(const GridStudySizes& family, const PaidSizes& sizes, const Scene& scene) {
    constexpr double of_beam = 0.1, rounding = 1.001;
    if (!scene.hull || scene.motion.kind != Motion::Kind::stream || scene.domain.dimensions == 2) return {};
    const double least = of_beam * scene.hull->beam;
    if (!(sizes.near_hull > rounding * least)) return {};
    std::optional<PaidSizes> tenth;
    try {
        tenth = sizes_at(family, sizes.scale * least / sizes.near_hull);
    } catch (const InputError&) {}
    return fmt::format(
        "! near_hull is the beam over {:.2g}: forces from less than ten sizes across the beam are a first "
        "impression{}\n",
        scene.hull->beam / sizes.near_hull,
        tenth ? fmt::format("; ten take {} (--budget {:.0f}min)", about_text(tenth->seconds),
                            std::ceil(1.05 * tenth->seconds / 60))
              : "");
}

}  // namespace tw::app
