#include "compare/sweep/over_the_speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/report/numbers.h"
#include "compare/report/svg_plot.h"
#include "methods/methods.h"
#include "record/force_names.h"

namespace tw {

namespace {

constexpr const char* shown[] = {"total_drag",   "drag", "effective_power", "resistance_coefficient", "lift",
                                 "running_trim", "rise", "transom_sinkage", "wetted_length"};

/// The runs of one hull and trim by the same methods, slowest first.
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

/// One for each formula. What the scene gives as measured belongs to the scene's own speed.
std::vector<Curve> of_references(const Members& members, const std::string& quantity) {
    std::vector<Curve> curves;
    for (std::size_t k = 0; k < members.size(); ++k)
        for (const Reference& r : members[k]->references) {
            if (r.quantity != quantity || r.of_one_run || r.measured || !r.in_range) continue;
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
std::string drawn(const Members& members, const Quantity& q, const std::string& title,
                  const std::vector<Curve>& curves) {
    Plot plot{.title = title, .x_label = "speed [m/s]"};
    plot.y_label = lower_case_first(q.label) + (q.unit == "-" ? "" : " [" + q.unit + "]");
    plot.width = 460, plot.height = 320;
    std::vector<double> speeds;
    for (const SweepMember* m : members) speeds.push_back(m->speed);
    for (std::size_t s = 0; s < curves.size(); ++s) {
        PlotLine line{curves[s].name, s, speeds, curves[s].value, false, false, true},
            low{"", s, speeds, {}, false, true}, high = low;
        for (std::size_t k = 0; k < speeds.size(); ++k) {
            low.y.push_back(curves[s].value[k] - curves[s].half_width[k]);
            high.y.push_back(curves[s].value[k] + curves[s].half_width[k]);
        }
        for (PlotLine* l : {&low, &high, &line}) plot.lines.push_back(std::move(*l));
    }
    return "<figure>" + svg(plot) + "</figure>";
}

/// None: fewer than two speeds.
ReportTable table_of(const Members& members, const std::string& series) {
    ReportTable table{"Over the speed" + (series.empty() ? "" : ", " + series),
                      {words("Quantity"), words("unit"), words("by")}};
    for (const SweepMember* m : members) table.columns.push_back(numbers(number_text(m->speed, 4) + " m/s"));
    std::string plots;
    for (const char* name : shown) {
        const auto with =
            std::ranges::find_if(members, [&](const SweepMember* m) { return find(*m, name) != nullptr; });
        if (with == members.end()) continue;
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
        plots += drawn(members, q, q.label + (series.empty() ? "" : ", " + series), curves);
    }
    if (!plots.empty()) table.picture = "<div class=\"pair\">" + plots + "</div>";
    table.notes.push_back("± and broken lines: the 95 % intervals of the values, as far as they are known.");
    return table;
}

}  // namespace

std::vector<ReportTable> over_the_speed(const Sweep& sweep) {
    std::vector<std::string> all;
    for (const SweepMember& m : sweep.members)
        if (std::ranges::find(all, m.series) == all.end()) all.push_back(m.series);
    std::vector<ReportTable> tables;
    for (const std::string& series : all) {
        Members members;
        for (const SweepMember& m : sweep.members) {
            const bool compared = !m.methods.empty() && (members.empty() || m.methods == members.front()->methods);
            if (m.series == series && std::isfinite(m.speed) && compared) members.push_back(&m);
        }
        std::ranges::stable_sort(members, {}, &SweepMember::speed);
        if (members.size() < 2) continue;
        if (ReportTable table = table_of(members, series); !table.rows.empty()) tables.push_back(std::move(table));
    }
    return tables;
}

}  // namespace tw
