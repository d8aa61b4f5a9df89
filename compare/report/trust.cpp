#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/checks/checks.h"
#include "compare/metrics/box_walls.h"
#include "compare/report/first_screen.h"
#include "compare/report/numbers.h"
#include "methods/methods.h"
#include "record/force_names.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

/// How far the values that miss a reference are from it, over the reference.
struct Miss {
    double nearest = HUGE_VAL, farthest = 0;
    std::size_t missed = 0, known = 0;
    std::string who;
    bool above = true, below = true;

    bool of_all() const { return missed == known; }
};

Miss miss_of(const Comparison& c, const Quantity& q, const Reference& r) {
    Miss miss;
    for (std::size_t s = 0; s < q.values.size(); ++s) {
        const MeanValue& m = q.values[s];
        if (!m.known || c.failed(s) || !std::isfinite(m.bar())) continue;
        ++miss.known;
        const double E = m.value - r.value;
        if (std::abs(E) <= std::hypot(m.bar(), r.half_width)) continue;
        ++miss.missed;
        miss.who += (miss.who.empty() ? "" : " and ") + method_label(c.names[s]);
        miss.nearest = std::min(miss.nearest, std::abs(E / r.value));
        miss.farthest = std::max(miss.farthest, std::abs(E / r.value));
        (E > 0 ? miss.below : miss.above) = false;
    }
    return miss;
}

/// "lift 35 to 40 % above it".
std::string how_far(const Quantity& q, const Miss& miss) {
    const std::string near = fmt::format("{:.0f}", 100 * miss.nearest),
                      far = fmt::format("{:.0f}", 100 * miss.farthest);
    return fmt::format("{} {} % {}", lower_case_first(q.label), near == far ? far : near + " to " + far,
                       miss.above   ? "above"
                       : miss.below ? "below"
                                    : "off");
}

/// What the scene gives as measured of the same quantity; null: nothing.
const Reference* measured_beside(const Comparison& c, const Reference& formula) {
    const auto found = std::ranges::find_if(
        c.references, [&](const Reference& r) { return r.measured && r.quantity == formula.quantity; });
    return found == c.references.end() || formula.measured ? nullptr : &*found;
}

/// " (measured: 13 % above)", of a measurement from a formula.
std::string measured_from(const Reference& measured, const Reference& formula) {
    const double E = measured.value / formula.value - 1;
    return fmt::format(" (measured: {:.0f} % {})", 100 * std::abs(E), E > 0 ? "above" : "below");
}

/// "the walls of the box (...) are expected to raise the lift by 12 %", without what a wider box would leave, or what
/// was measured in one.
std::string walls_of(const Comparison& c) { return c.walls.substr(0, c.walls.find(';')); }

/// "at the wetted lengths that the runs find it gives 2430 and 2500 N of lift".
std::string at_own_wetted_length(const Comparison& c) {
    std::string values, unit;
    for (const Reference& r : c.references)
        if (r.of_one_run && r.quantity == "lift")
            values += (values.empty() ? "" : " and ") + number_text(r.value), unit = r.unit;
    return values.empty()
               ? values
               : fmt::format("at the wetted lengths that the runs find it gives {} {} of lift", values, unit);
}

/// One line for each formula or measurement and those who miss it.
std::vector<Doubt> missed_references(const Comparison& c) {
    struct Line {
        std::string source, who;
        bool all;
        std::string quantities = {}, bias = {};
        bool measured = false;  // a measurement stands beside it, which decides what is grave
    };
    std::vector<Line> lines;
    for (const Quantity& q : c.quantities)
        for (const Reference& r : c.references) {
            if (r.quantity != q.name || !r.in_range || r.of_one_run || r.value == 0) continue;
            const Miss miss = miss_of(c, q, r);
            if (miss.missed == 0) continue;
            const bool all = miss.of_all() && miss.known > 1;
            auto line = std::ranges::find_if(
                lines, [&](const Line& l) { return l.source == r.source && l.who == miss.who && l.all == all; });
            if (line == lines.end()) line = lines.insert(line, {r.source, miss.who, all});
            line->quantities += (line->quantities.empty() ? "" : ", ") + how_far(q, miss);
            if (const Reference* m = measured_beside(c, r))
                line->quantities += measured_from(*m, r), line->measured = true;
            if (!r.bias.empty()) line->bias = r.bias;
        }
    std::ranges::stable_sort(lines, {}, [](const Line& l) { return !l.all; });
    std::vector<Doubt> doubts;
    for (const Line& l : lines) {
        const bool several = l.who.find(" and ") != std::string::npos;
        std::string text = fmt::format("{} {} outside {}: {}", l.all && c.sources.size() == 2 ? "Both methods" : l.who,
                                       several ? "lie" : "lies", l.source, l.quantities);
        const std::string walls = doubts.empty() ? walls_of(c) : "",
                          own = l.bias.empty() ? "" : at_own_wetted_length(c);
        for (const std::string& why : {l.bias, walls, own})
            if (!why.empty()) text += "; " + why;
        doubts.push_back({l.all && !l.measured, text + "."});
    }
    return doubts;
}

}  // namespace

std::vector<Doubt> doubts_of(const Comparison& c) {
    std::vector<Doubt> doubts = missed_references(c);
    for (const ValidityCheck& g : failed_checks(c.checks)) {
        const std::string unit = g.unit == "-" || g.unit.empty() ? "" : " " + unit_text(g.unit);
        doubts.push_back(
            {!g.warns, fmt::format("{}: {} {}{}, limit {}{}{}", method_label(g.source), g.name, number_text(g.value),
                                   unit, number_text(g.limit), unit, g.remark.empty() ? "" : "; " + g.remark)});
    }
    for (const std::string& banner : all_banners(c)) doubts.push_back({false, banner});
    return doubts;
}

}  // namespace tw
