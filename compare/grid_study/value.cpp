#include "compare/grid_study/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/report/numbers.h"

namespace tw {

namespace {

constexpr double scheme_order = 2;
/// Of the particles' pairs and of what a water raster holds: the last digits of a value, over its size.
constexpr double single_precision = 1e-6;

}  // namespace

std::map<std::string, double> inputs_of(const std::vector<Sensitivity>& sensitivities) {
    std::map<std::string, std::pair<double, int>> squares;
    for (const Sensitivity& s : sensitivities)
        if (!s.input.empty() && std::isfinite(s.uncertainty)) {
            auto& [sum, ends] = squares[s.input];
            sum += s.uncertainty * s.uncertainty;
            ++ends;
        }
    std::map<std::string, double> inputs;
    for (const auto& [name, square] : squares) inputs[name] = std::sqrt(square.first / square.second);
    return inputs;
}

GridStudyValue value_of(const std::vector<GridStudySide>& sides, std::size_t k, const std::string& name, double scale) {
    const GridStudySide& side = sides[k];
    GridStudyValue v;
    std::vector<const GridStudyRun*> known;
    for (const GridStudyRun& run : side.runs) {
        const Quantity* q = find_quantity(run, name);
        if (!q || !q->values[0].known || !q->not_resolved.empty()) {
            const std::string why = !q ? "not measured" : q->values[0].known ? q->not_resolved : q->values[0].why_not;
            v.absent.push_back(fmt::format("{} m: {}", number_text(run.spacing), why));
            continue;
        }
        known.push_back(&run);
        const double value = q->values[0].value;
        v.levels.push_back(
            {run.spacing, value, q->values[0].half_width, single_precision * std::max(std::abs(value), scale)});
        v.half_widths.push_back(q->values[0].half_width);
    }
    if (v.levels.empty()) return v;
    v.statistical = v.half_widths.front();
    v.estimate = estimate(v.levels, scheme_order);
    v.sensitivities = sensitivities_of(sides, k, name, v.levels.front().value, scale);
    for (const Sensitivity& s : v.sensitivities)
        if (double& sum = s.box ? v.box : v.choices; std::isfinite(s.uncertainty) && s.input.empty())
            sum = std::hypot(sum, s.uncertainty);
    for (const auto& [input, U] : inputs_of(v.sensitivities)) v.input = std::hypot(v.input, U);
    v.own = std::hypot(std::hypot(v.statistical, v.estimate.uncertainty), v.choices);  // of three, NaN may get lost
    v.uncertainty = std::hypot(v.own, std::hypot(v.box, v.input));
    std::vector<CostPoint> points;
    for (std::size_t i = 0; i < v.estimate.uncertainties.size(); ++i) {
        const double U = std::hypot(v.estimate.uncertainties[i], v.half_widths[i]);
        if (no_more_than_rounding(U, v.levels[i].value)) continue;  // rounding follows no line
        points.push_back({known[i]->spacing, known[i]->seconds, U, known[i]->core_seconds, known[i]->memory});
    }
    v.cost_in_cores = cost_of_accuracy(points, &CostPoint::core_seconds);
    v.cost_in_memory = cost_of_accuracy(points, &CostPoint::memory);
    v.cost = cost_of_accuracy(std::move(points));
    return v;
}

}  // namespace tw
