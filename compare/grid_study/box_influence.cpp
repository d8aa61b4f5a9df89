#include "compare/grid_study/box_influence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/metrics/box_walls.h"
#include "compare/report/numbers.h"
#include "methods/methods.h"
#include "record/force_names.h"

namespace tw {

namespace {

constexpr double noticed_change = 0.02;  ///< of a load; `check` warns from the same share on (scene/box/box_walls.h)

/// The run in a wider box that says something of this quantity, and the side that it is a variation of.
const Sensitivity* wider_box_of(const GridStudyQuantity& q) {
    for (const GridStudyValue& v : q.values)
        for (const Sensitivity& s : v.sensitivities)
            if (s.box && std::isfinite(s.uncertainty) && s.name.find("(as in") == s.name.npos) return &s;
    return nullptr;
}

std::string method_of_the_box(const GridStudy& grid_study) {
    for (const GridStudySide& side : grid_study.sides)
        if (std::ranges::any_of(side.variations,
                                [](const GridStudyVariation& v) { return v.box && v.refused.empty(); }))
            return method_label(side.method);
    return {};
}

}  // namespace

void add_measured_box(Comparison& c, const GridStudy& grid_study) {
    std::string changes;
    double largest = 0;
    const Sensitivity* run = nullptr;
    for (const char* load : {"lift", "drag", "total_drag", "trim_moment"}) {
        const auto q = std::ranges::find(grid_study.quantities, load, &GridStudyQuantity::name);
        const Sensitivity* s = q == grid_study.quantities.end() ? nullptr : wider_box_of(*q);
        if (!s || !(q->size > 0)) continue;
        run = s;
        double share = 0;
        for (const GridStudyValue& v : q->values) share = std::max(share, v.box / q->size);
        largest = std::max(largest, share);
        changes += fmt::format("{}{} by {}{:.1f} %", changes.empty() ? "" : ", ", lower_case_first(q->label),
                               std::abs(s->value) < std::abs(s->varied) ? "-" : "+", 100 * share);
    }
    if (!run || (c.walls.empty() && largest <= noticed_change)) return;
    c.walls = fmt::format(
        "{} {}; measured by {} at {} m ({}), extrapolated to open water, and part of the "
        "intervals of the values",
        in_a_channel(c) ? "the floor of the box changes" : "the walls of the box change", changes,
        method_of_the_box(grid_study), number_text(run->spacing), run->name);
}

}  // namespace tw
