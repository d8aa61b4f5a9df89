#include "compare/sweep/swept_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "compare/report/numbers.h"
#include "compare/report/svg_plot.h"
#include "methods/methods.h"
#include "record/force_names.h"

namespace tw {

namespace {

constexpr const char* over_speed[] = {"total_drag",   "drag", "effective_power", "resistance_coefficient", "lift",
                                      "running_trim", "rise", "transom_sinkage", "wetted_length"};
constexpr const char* over_wave_length[] = {
    "heave_response:",  "heave_phase:",      "heave_over_wave:",     "pitch_response:",
    "pitch_phase:",     "pitch_over_wave:",  "acceleration_centre:", "acceleration_bow:",
    "added_resistance", "added_trim",        "added_rise",           "wave_force_",
    "wave_drift_",      "wave_transmission", "wave_reflection",      "wave_without:",
    "run_up:"};

/// A number that a sweep varies: its name, its unit, which of a member's it is, and the names of the quantities that are
/// shown over it, or their beginnings where they have a colon or end with '_'.
struct Axis {
    const char *name, *unit;
    SweptNumber SweepMember::*number;
    std::span<const char* const> shown;
};
constexpr Axis axes[] = {{"speed", "m/s", &SweepMember::speed, over_speed},
                         {"wave length", "m", &SweepMember::wave_length, over_wave_length}};

/// The runs of one series by the same methods, in the order of the axis.
using Members = std::vector<const SweepMember*>;

/// One quantity by one method or formula; NaN where it is not known.
struct Curve {
    std::string name;
    std::vector<double> value, half_width;  ///< of each member [unit of the quantity]
    std::size_t known = 0;

    void add(double v, double U) {
        value.push_back(v), half_width.push_back(U);
        known += std::isfinite(v) ? 1 : 0;
    }
};

const Quantity* find(const SweepMember& m, const std::string& name) {
    const auto q = std::ranges::find(m.quantities, name, &Quantity::name);
    return q == m.quantities.end() ? nullptr : &*q;
}

Curve of_method(const Members& members, const std::string& quantity, std::size_t method) {
    Curve curve{method_label(members.front()->methods[method]), {}, {}};
    for (const SweepMember* m : members) {
        const Quantity* q = find(*m, quantity);
        const bool known = q && method < q->values.size() && q->values[method].known;
        curve.add(known ? q->values[method].value : nan, known ? q->values[method].bar() : nan);
    }
    return curve;
}

/// One for each formula and each measurement.
std::vector<Curve> of_references(const Members& members, const std::string& quantity) {
    std::vector<Curve> curves;
    for (std::size_t k = 0; k < members.size(); ++k)
        for (const Reference& r : members[k]->references) {
            if (r.quantity != quantity || r.of_one_run || !r.in_range) continue;
            auto curve = std::ranges::find(curves, r.source, &Curve::name);
            if (curve == curves.end()) curve = curves.insert(curve, {r.source, {}, {}});
            while (curve->value.size() < k) curve->add(nan, nan);
            if (curve->value.size() == k) curve->add(r.value, r.half_width);
        }
    for (Curve& curve : curves)
        while (curve.value.size() < members.size()) curve.add(nan, nan);
    return curves;
}

/// Values as dots with a line, and broken lines above and below for their intervals.
std::string drawn(const Members& members, const Axis& axis, const Quantity& q, const std::string& title,
                  const std::vector<Curve>& curves) {
    Plot plot{.title = title, .x_label = fmt::format("{} [{}]", axis.name, axis.unit)};
    plot.y_label = lower_case_first(q.label) + (q.unit == "-" ? "" : " [" + q.unit + "]");
    plot.width = 460, plot.height = 320;
    std::vector<double> places;
    for (const SweepMember* m : members) places.push_back((m->*axis.number).value);
    for (std::size_t s = 0; s < curves.size(); ++s) {
        PlotLine line{curves[s].name, s, places, curves[s].value, false, false, true},
            low{"", s, places, {}, false, true}, high = low;
        for (std::size_t k = 0; k < places.size(); ++k) {
            low.y.push_back(curves[s].value[k] - curves[s].half_width[k]);
            high.y.push_back(curves[s].value[k] + curves[s].half_width[k]);
        }
        for (PlotLine* l : {&low, &high, &line}) plot.lines.push_back(std::move(*l));
    }
    return "<figure>" + svg(plot) + "</figure>";
}

/// Names of the quantities that some member has, in the order in which the axis shows them.
std::vector<std::string> shown_of(const Members& members, const Axis& axis) {
    std::vector<std::string> names;
    for (const std::string name : axis.shown) {
        const bool beginning = name.find(':') != name.npos || name.ends_with('_');
        for (const SweepMember* m : members)
            for (const Quantity& q : m->quantities)
                if ((beginning ? q.name.starts_with(name) : q.name == name) &&
                    std::ranges::find(names, q.name) == names.end())
                    names.push_back(q.name);
    }
    return names;
}

/// Empty: no method has a value at two places.
ReportTable table_of(const Members& members, const Axis& axis, const std::string& series) {
    ReportTable table{fmt::format("Over the {}{}", axis.name, series.empty() ? "" : ", " + series),
                      {words("Quantity"), words("unit"), words("by")}};
    for (const SweepMember* m : members)
        table.columns.push_back(numbers(number_text((m->*axis.number).value, 4) + " " + axis.unit));
    std::string plots;
    for (const std::string& name : shown_of(members, axis)) {
        const auto with =
            std::ranges::find_if(members, [&](const SweepMember* m) { return find(*m, name) != nullptr; });
        const Quantity& q = *find(**with, name);
        std::vector<Curve> curves;
        for (std::size_t s = 0; s < members.front()->methods.size(); ++s) curves.push_back(of_method(members, name, s));
        if (std::ranges::none_of(curves, [](const Curve& c) { return c.known > 1; })) continue;
        for (Curve& c : of_references(members, name)) curves.push_back(std::move(c));
        for (const Curve& c : curves) {
            ReportRow row{{q.label, q.unit, c.name}};
            for (std::size_t k = 0; k < members.size(); ++k)
                row.cells.emplace_back(value_text(c.value[k], c.half_width[k]));
            table.rows.push_back(std::move(row));
        }
        plots += drawn(members, axis, q, q.label + (series.empty() ? "" : ", " + series), curves);
    }
    if (!plots.empty()) table.picture = "<div class=\"pair\">" + plots + "</div>";
    table.notes.push_back("± and broken lines: the 95 % intervals of the values, as far as they are known.");
    return table;
}

/// The members of one series, whose numbers differ.
Members members_of(const Sweep& sweep, const Axis& axis, const std::string& series) {
    Members members;
    for (const SweepMember& m : sweep.members) {
        const SweptNumber& at = m.*axis.number;
        const bool compared = !m.methods.empty() && (members.empty() || m.methods == members.front()->methods);
        if (at.series == series && std::isfinite(at.value) && compared) members.push_back(&m);
    }
    std::ranges::stable_sort(members, {}, [&](const SweepMember* m) { return (m->*axis.number).value; });
    return members;
}

}  // namespace

std::vector<ReportTable> swept_curves(const Sweep& sweep) {
    std::vector<ReportTable> tables;
    for (const Axis& axis : axes) {
        std::vector<std::string> all;
        for (const SweepMember& m : sweep.members)
            if (const std::string& series = (m.*axis.number).series; std::ranges::find(all, series) == all.end())
                all.push_back(series);
        for (const std::string& series : all) {
            const Members members = members_of(sweep, axis, series);
            if (members.size() < 2) continue;
            if (ReportTable table = table_of(members, axis, series); !table.rows.empty())
                tables.push_back(std::move(table));
        }
    }
    return tables;
}

}  // namespace tw
