#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/grid_study/steps.h"
#include "methods/methods.h"

namespace tw {

namespace {

/// Below this factor in time steps, or in the water's cross section, a choice has not changed what it was to change:
/// the share extrapolated from it would be more than six times the change seen.
constexpr double least_change = 1.2;

double steps_per_second(const GridStudyRun& run) { return run.duration > 0 ? run.steps / run.duration : run.steps; }

/// Width and depth of the water [m]; in two dimensions the width is 1.
double width_of(const GridStudyRun& run) { return run.domain.size() == 6 ? run.domain[3] - run.domain[2] : 1; }
double depth_of(const GridStudyRun& run) { return run.domain.size() < 4 ? 0 : -run.domain[run.domain.size() - 2]; }
double cross_section(const GridStudyRun& run) { return width_of(run) * depth_of(run); }

/// No face has come closer; the top is no wall of the water.
bool encloses(const std::vector<double>& wide, const std::vector<double>& box) {
    if (wide.size() != box.size()) return false;
    for (std::size_t k = 0; k + 1 < box.size(); ++k)
        if ((k % 2 == 0 ? box[k] - wide[k] : wide[k] - box[k]) < 0) return false;
    return true;
}

Sensitivity sensitivity_of(const GridStudySide& side, const GridStudyVariation& v, const std::string& name) {
    const auto base = std::ranges::find_if(side.runs, [&](const GridStudyRun& r) { return same_rung(r, v.run); });
    Sensitivity s{v.name, v.run.spacing, std::nan(""), std::nan(""), std::nan(""), v.box, v.refused, v.input};
    const Quantity *a = find_quantity(*base, name), *b = find_quantity(v.run, name);
    if (!a || !b || !a->values[0].known || !b->values[0].known) return s;
    s.value = a->values[0].value, s.varied = b->values[0].value;
    if (v.refused.empty()) s.uncertainty = v.factor * std::abs(s.varied - s.value);
    return s;
}

}  // namespace

const Quantity* find_quantity(const GridStudyRun& run, const std::string& name) {
    const auto q = std::ranges::find(run.quantities, name, &Quantity::name);
    return q == run.quantities.end() || q->values.empty() ? nullptr : &*q;
}

std::optional<GridStudyVariation> variation_between(const GridStudyRun& base, const GridStudyRun& varied) {
    if (const auto choice = variation_between(base.family, varied.family))
        return GridStudyVariation{choice->name, choice->factor, varied, choice->steps};
    if (!same_settings(base.family, varied.family) || !encloses(varied.domain, base.domain) ||
        !(cross_section(varied) > cross_section(base)))
        return {};
    const double by = std::max(width_of(varied) / width_of(base), depth_of(varied) / depth_of(base));
    return GridStudyVariation{fmt::format("box x {:.2g}", by), 1, varied, 1, true};
}

void weigh(GridStudyVariation& v, const GridStudyRun& base) {
    if (v.steps > 1 && v.run.steps > 0 && base.steps > 0) {
        const double taken = steps_per_second(v.run) / steps_per_second(base);
        if (taken < least_change)
            v.refused = fmt::format(
                "{:.0f} time steps instead of {:.0f}, {:.3g} times as many where {:.3g} times were "
                "meant: something else sets the step",
                v.run.steps, base.steps, taken, v.steps);
        else
            v.factor = 1 / (1 - 1 / std::min(taken, v.steps));
    }
    const double before = cross_section(base), after = cross_section(v.run);
    if (!v.box || !(before > 0)) return;
    if (after < least_change * before)
        v.refused = fmt::format("the water's cross section is {:.4g} m2 instead of {:.4g} m2", after, before);
    else
        v.factor = 1 / (1 - before / after);
}

std::vector<Sensitivity> sensitivities_of(const std::vector<GridStudySide>& sides, std::size_t k,
                                          const std::string& name, double finest, double scale) {
    std::vector<Sensitivity> all;
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (const GridStudyVariation& v : sides[i].variations) {
            if (i != k && !v.box) continue;
            Sensitivity s = sensitivity_of(sides[i], v, name);
            if (i != k) s.name += " (as in " + method_label(sides[i].method) + ")";
            if (const double size = std::max(std::abs(s.value), scale); v.box && size > 0)
                s.uncertainty *= std::max(std::abs(finest), scale) / size;
            all.push_back(std::move(s));
        }
    return all;
}

std::string steps_note(const GridStudySide& side) {
    if (side.runs.size() < 2) return {};
    const GridStudyRun &fine = side.runs.front(), &coarse = side.runs.back();
    if (!(fine.steps > 0) || !(coarse.steps > 0) || coarse.spacing < 1.3 * fine.spacing) return {};
    if (steps_per_second(fine) >= least_change * steps_per_second(coarse)) return {};
    std::string counts;
    for (const GridStudyRun& r : side.runs) counts += fmt::format("{}{:.0f}", counts.empty() ? "" : ", ", r.steps);
    return fmt::format(
        "{}: {} time steps at {} sizes, finest first: the step does not follow the spacing, so the discretisation "
        "error "
        "below is that of the spacing alone",
        method_label(side.method), counts, side.runs.size());
}

std::string unlike_sizes_note(const GridStudySide& side) {
    const auto sizes = [](const GridStudyRun& run) { return run.element_sizes; };
    const auto [least, most] = std::ranges::minmax(side.runs, {}, sizes);
    if (least.element_sizes == most.element_sizes) return {};
    std::string counts;
    for (const GridStudyRun& r : side.runs)
        counts += fmt::format("{}{:g} ({:.3g} in all) at {:.4g} m", counts.empty() ? "" : ", ", r.element_sizes,
                              r.elements, r.spacing);
    return fmt::format(
        "{}: sizes of particles in each run: {}: the runs are not similar, so the discretisation error "
        "below is not of the spacing alone",
        method_label(side.method), counts);
}

}  // namespace tw
