#include "compare/metrics/forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/numbers.h"
#include "compare/metrics/quantity.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"
#include "record/force_names.h"
#include "record/record_numbers.h"
#include "statistics/flow_through.h"
#include "statistics/settled_loads.h"
#include "statistics/settled_mean.h"

namespace tw {

MeanValue mean_of(const RunRecord& record, const std::string& table, const std::string& column,
                  const CompareOptions& options, double allowed_error) {
    const Column* c = record.series(table, column);
    if (!c) {
        MeanValue none;
        none.why_not = not_given;
        return none;
    }
    SettledRules rules;
    rules.from = number_of(record, "mean_from", 0);
    rules.flow_through = flow_through_time(record);
    rules.fewest_flow_throughs = options.fewest_flow_throughs;
    rules.fewest_independent = options.fewest_independent;
    rules.largest_error = options.largest_error;
    rules.allowed_error = allowed_error;
    return settled_mean(record.tables.at(table).time, c->values, rules);
}

namespace {

/// Friction as a column of its own, or known to be in a measured drag (attribute friction).
bool has_friction(const RunRecord& record) {
    if (text_of(record, "friction") == "included") return true;
    const Column* c = record.series("forces", "fx_viscous");
    return c && std::ranges::any_of(c->values, [](double v) { return std::isfinite(v) && v != 0; });
}

using PerSource = std::function<MeanValue(const RunRecord&)>;

Quantity quantity(const Comparison& comparison, std::string name, std::string label, std::string unit,
                  std::string definition, const PerSource& value) {
    Quantity q = new_quantity(std::move(name), std::move(label), std::move(unit), std::move(definition));
    for (const RunRecord& r : comparison.sources) q.values.push_back(value(r));
    return q;
}

bool any_known(const Quantity& q) { return std::ranges::any_of(q.values, &MeanValue::known); }

/// A number beside the verdict: only where some source knows it.
void add_beside(Comparison& comparison, Quantity q) {
    if (!any_known(q)) return;
    beside(q);
    comparison.quantities.push_back(std::move(q));
}

/// Half width of a force from the uncertainty of the draft: numbers <name>_per_draft [N/m] times draft_uncertainty [m],
/// by default a tenth of the spacing at the hull, to which neither method places the waterline.
double draft_term(const Comparison& comparison, const std::string& name, std::string& text) {
    double term = 0;
    for (const RunRecord& r : comparison.sources) {
        const double slope = std::abs(number_of(r, name + "_per_draft", 0));
        const double draft =
            number_of(r, "draft_uncertainty", 0.1 * number_of(r, "near_hull", number_of(r, "spacing", 0)));
        if (slope * draft <= term) continue;
        term = slope * draft;
        text = fmt::format("draft known to {:.2g} mm at {:.3g} N per mm", 1e3 * draft, 1e-3 * slope);
    }
    return term;
}

struct Force {
    const char* name;
    std::string label;
    const char *unit, *column, *pressure;
    std::string definition;
};

void add_sph_measures(Comparison& comparison, const CompareOptions& options, const ForceNames& called,
                      const std::string& unit) {
    struct Measure {
        const char* name;
        std::string label;
        const char* column;
    };
    const std::string &up = called.up, &along = called.along;
    for (const Measure& m : {Measure{"lift_surface", up + " by surface pressure", "fz_surface"},
                             Measure{"lift_volume", up + " by control volume", "fz_volume"},
                             Measure{"drag_surface", along + " by surface pressure", "fx_surface"},
                             Measure{"drag_volume", along + " by control volume", "fx_volume"}})
        add_beside(comparison, quantity(comparison, m.name, m.label, unit,
                                        "a second, independent measure of the same force in the same run",
                                        [&](const RunRecord& r) { return mean_of(r, "forces", m.column, options); }));
    add_beside(comparison,
               quantity(comparison, "force_measure_spread",
                        fmt::format("Spread of the force measures ({})", lower_case_first(up)), "%",
                        "largest minus smallest of pair sum, surface pressure and control volume, over the pair sum",
                        [&](const RunRecord& r) {
                            const MeanValue sum = mean_of(r, "forces", "fz", options);
                            MeanValue spread;
                            spread.why_not = not_given;
                            if (!sum.known) return spread;
                            double low = sum.value, high = sum.value, u = sum.half_width;
                            bool other = false;
                            for (const char* c : {"fz_surface", "fz_volume"}) {
                                const MeanValue m = mean_of(r, "forces", c, options);
                                if (!m.known) continue;
                                other = true;
                                low = std::min(low, m.value);
                                high = std::max(high, m.value);
                                u = std::hypot(u, m.half_width);
                            }
                            if (!other || sum.value == 0) return spread;
                            spread = sum;
                            spread.value = 100 * (high - low) / std::abs(sum.value);
                            spread.half_width = 100 * u / std::abs(sum.value);
                            spread.second_opinion = std::numeric_limits<double>::quiet_NaN();
                            return spread;
                        }));
}

}  // namespace

void add_forces(Comparison& comparison, const CompareOptions& options) {
    const auto& sources = comparison.sources;
    if (std::ranges::none_of(sources, [](const RunRecord& r) { return r.tables.contains("forces"); })) return;
    // The load on a body that moves does not settle; metrics/bodies.h has its measures.
    if (std::ranges::any_of(sources, has_moving_bodies)) return;
    const auto has_drag = [](const RunRecord& r) { return r.series("forces", "fx") != nullptr; };
    const auto with_drag = std::ranges::count_if(sources, has_drag);
    const auto with_friction =
        std::ranges::count_if(sources, [&](const RunRecord& r) { return has_drag(r) && has_friction(r); });
    const bool some_with_friction = with_friction > 0 && with_friction < with_drag;
    const bool leave_friction_out = some_with_friction && std::ranges::all_of(sources, [](const RunRecord& r) {
                                        return !has_friction(r) || r.series("forces", "fx_pressure");
                                    });
    if (leave_friction_out)
        comparison.banners.push_back(
            "Only one method solves friction: drag and lift are compared without it (pressure parts); friction is "
            "listed "
            "below.");
    else if (some_with_friction)
        comparison.banners.push_back(
            "Only some sources include friction in their drag, and not all of them list its part: the drags compared "
            "here "
            "differ by it.");

    // Where friction is in no drag, drag is what the pressure makes; a source that lists no parts may have measured both.
    const bool pressure_alone =
        with_drag > 0 && std::ranges::all_of(sources, [&](const RunRecord& r) {
            return !has_drag(r) || (r.series("forces", "fx_pressure") && text_of(r, "friction") != "included" &&
                                    (leave_friction_out || !has_friction(r)));
        });

    // In two dimensions forces are per metre of span.
    const bool flat =
        std::ranges::any_of(sources, [](const RunRecord& r) { return number_of(r, "dimensions", 3) == 2; });
    const auto unit = [&](const char* of_whole) { return flat ? std::string(of_whole) + "/m" : of_whole; };
    const bool stream = std::ranges::any_of(sources, is_stream);
    const ForceNames called = force_names(stream);
    const std::string &up = called.up, &along = called.along, on = stream ? "on the whole hull" : "on the solids";
    double lift = 0;
    for (const Force& f :
         {Force{"lift", up, "N", "fz", "fz_pressure", "mean vertical force of the water " + on},
          Force{"drag", stream && pressure_alone ? "Pressure drag" : along, "N", "fx", "fx_pressure",
                "mean force of the water " + on + (stream ? " along the stream" : " along x")},
          Force{"trim_moment", called.moment, "N m", "my", nullptr,
                "mean moment of the water about one point for all sources (moment_reference), bow up positive; its "
                "target is "
                "taken of at least a tenth of lift times length"}}) {
        double length = 0;
        for (const RunRecord& r : sources) length = std::max(length, number_of(r, "length", 0));
        const bool moment = !f.pressure;
        Quantity q = quantity(comparison, f.name, f.label, unit(f.unit), f.definition, [&](const RunRecord& r) {
            const bool pressure_only =
                leave_friction_out && !moment && has_friction(r) && r.series("forces", f.pressure);
            MeanValue m =
                mean_of(r, "forces", pressure_only ? f.pressure : f.column, options, moment ? 1e-3 * lift * length : 0);
            widen_where_ended(r, m, moment ? 0.1 * lift * length : 0);
            return m;
        });
        if (leave_friction_out)
            q.remark = moment ? "friction included where solved" : "friction left out on both sides";
        if (std::string_view(f.name) == "lift")
            for (const MeanValue& m : q.values)
                if (m.known) lift = std::max(lift, std::abs(m.value));
        if (moment) q.scale = 0.1 * lift * length;
        if (std::ranges::none_of(sources, [&](const RunRecord& r) { return r.series("forces", f.column) != nullptr; }))
            continue;
        std::string shared_name;
        const double shared = draft_term(comparison, f.name, shared_name);
        if (stream || any_known(q))
            judge(q, comparison.names, comparison.agree_within, shared, shared_name);
        else
            beside(q);  // an event: metrics/tank_loads.h
        if (shared > 0) q.remark += (q.remark.empty() ? "" : "; ") + ("interval includes " + shared_name);
        comparison.quantities.push_back(std::move(q));
    }

    struct Beside {
        const char* name;
        std::string label;
        const char *unit, *table, *column;
        std::string definition;
    };
    const std::string &friction = called.friction, drag = lower_case_first(along);
    for (const Beside& b :
         {Beside{"drag_pressure", stream && !pressure_alone ? "Pressure drag" : along + " by pressure", "N", "forces",
                 "fx_pressure", "pressure part of the " + drag},
          Beside{"drag_friction", friction, "N", "forces", "fx_viscous",
                 "viscous part of the " + drag +
                     ", as if the wet faces touched water alone; zero where no physical viscosity is solved"},
          Beside{"drag_friction_uncorrected", friction + ", not corrected for air", "N", "forces",
                 "fx_viscous_uncorrected", "friction of the mixture of water and air at the wet faces"},
          Beside{"drag_air", along + " by air", "N", "forces", "fx_air",
                 "force of the air, of a method that solves it (a mesh: on the dry faces); not compared"},
          Beside{"lift_air", up + " by air", "N", "forces", "fz_air",
                 "force of the air, of a method that solves it (a mesh: on the dry faces); not compared"},
          Beside{"drag_total", along + ", air included", "N", "forces", "fx_total", "all faces; not compared"},
          Beside{"lift_total", up + ", air included", "N", "forces", "fz_total", "all faces; not compared"},
          Beside{"ventilation", "Share of air in the water at the hull", "-", "samples", "ventilation",
                 "share of air in what touches the wet part of the hull; friction is low in proportion"},
          Beside{"wetted_area", "Wetted area", "m2", "samples", "wetted_area", "area of the hull that water touches"}})
        add_beside(comparison,
                   quantity(comparison, b.name, b.label, *b.unit == '-' ? b.unit : unit(b.unit), b.definition,
                            [&](const RunRecord& r) { return mean_of(r, b.table, b.column, options, HUGE_VAL); }));
    add_sph_measures(comparison, options, called, unit("N"));
}

namespace {
/// A creep that would not count in the drag is no transient that has to be cut off, though it is seen in a series as
/// smooth as this.
MeanValue friction_by_line(const RunRecord& r, const CompareOptions& options) {
    const MeanValue alone = mean_of(r, "samples", "friction_line", options, HUGE_VAL);
    if (alone.known) return alone;
    const MeanValue drag = mean_of(r, "forces", "fx", options);
    if (!drag.known) return alone;
    return mean_of(r, "samples", "friction_line", options, options.largest_error * std::abs(drag.value));
}
}  // namespace

void add_total_drag(Comparison& comparison, const CompareOptions& options) {
    const Quantity* drag = comparison.find("drag");
    if (!drag) return;
    const std::string unit = drag->unit;
    const Quantity line =
        quantity(comparison, "friction_line", "Friction by a line", unit,
                 "friction of a flat plate (ITTC 1957) on what the method finds wet",
                 [&](const RunRecord& r) { return friction_by_line(r, options); });
    if (!any_known(line)) return;
    Quantity q = new_quantity(
        "total_drag", "Total drag", unit,
        "drag by pressure and friction: solved, or of a flat plate (ITTC 1957) on what the method finds wet");
    std::string coefficients;
    for (std::size_t i = 0; i < comparison.sources.size(); ++i) {
        const RunRecord& r = comparison.sources[i];
        MeanValue total = mean_of(r, "forces", "fx", options);
        widen_where_ended(r, total);
        const bool solved = has_friction(r);
        const MeanValue friction = solved ? mean_of(r, "forces", "fx_viscous", options, HUGE_VAL) : line.values[i];
        if (total.known && !solved) {
            if (friction.known) {
                total.value += friction.value;
                total.half_width = std::hypot(total.half_width, friction.half_width);
                total.second_opinion = nan;
            } else {
                total = friction;  // and why it is not known
            }
        }
        const double area = mean_of(r, "samples", "wetted_area", options, HUGE_VAL).value, U = number_of(r, "speed", 0),
                     whole = 0.5 * number_of(r, "density", 0) * U * U * area;
        if (total.known && friction.known && whole > 0)
            coefficients += fmt::format("{}{}: C_T {:.3g}, C_F {:.3g}", coefficients.empty() ? "" : "; ",
                                        method_label(comparison.names[i]), total.value / whole, friction.value / whole);
        q.values.push_back(total);
    }
    add_beside(comparison, line);
    std::string shared_name;
    const double shared = draft_term(comparison, "drag", shared_name);
    judge(q, comparison.names, comparison.agree_within, shared, shared_name);
    for (const std::string& more : {coefficients, shared > 0 ? "interval includes " + shared_name : std::string()})
        if (!more.empty()) q.remark += (q.remark.empty() ? "" : "; ") + more;
    comparison.quantities.push_back(std::move(q));
}

const Quantity* resistance_of(const Comparison& comparison) {
    if (const Quantity* total = comparison.find("total_drag")) return total;
    const bool solved =
        std::ranges::any_of(comparison.sources, is_stream) && std::ranges::all_of(comparison.sources, has_friction);
    const Quantity* drag = solved ? comparison.find("drag") : nullptr;
    return drag && drag->unit == "N" ? drag : nullptr;
}

void add_resistance(Comparison& comparison, const CompareOptions& options) {
    const Quantity* total = resistance_of(comparison);
    if (!total || total->unit != "N") return;
    Quantity power =
        new_quantity("effective_power", "Effective power", "W", "P_E = R_T U, the total drag times the speed");
    Quantity coefficient = new_quantity("resistance_coefficient", "Resistance coefficient", "-",
                                        "C_T = R_T / (1/2 rho S U^2), S: what the method finds wet");
    for (std::size_t i = 0; i < comparison.sources.size(); ++i) {
        const RunRecord& r = comparison.sources[i];
        const double U = number_of(r, "speed", 0);
        const auto times = [&](double factor) {
            MeanValue m = total->values[i];
            if (!m.known || !std::isfinite(factor)) {
                m = {};
                m.why_not = not_given;
                return m;
            }
            m.value *= factor, m.half_width *= factor, m.second_opinion = nan;
            return m;
        };
        const MeanValue S = mean_of(r, "samples", "wetted_area", options, HUGE_VAL);
        power.values.push_back(times(U > 0 ? U : nan));
        coefficient.values.push_back(
            times(U > 0 && S.known && S.value > 0 ? 1 / (0.5 * number_of(r, "density", 1000) * S.value * U * U) : nan));
    }
    add_beside(comparison, power);  // `total` is not valid from here on
    add_beside(comparison, coefficient);
}

void add_wetted_length(Comparison& comparison, const CompareOptions& options) {
    Quantity q = quantity(comparison, "wetted_length", "Wetted length", "m",
                          "longest line along x of the hull that water touches: the keel, either keel of a catamaran",
                          [&](const RunRecord& r) {
                              const double half_cell = 0.5 * number_of(r, "near_hull", 0);
                              MeanValue m = mean_of(r, "samples", "wetted_length", options, half_cell);
                              if (m.known && m.value == 0) {
                                  m = {};
                                  m.why_not = "not measured (no part of the hull is wet)";
                                  return m;
                              }
                              if (m.known && m.half_width < half_cell) {
                                  m.half_width = half_cell;
                                  m.limited_by = "the spacing at the hull";
                              }
                              return m;
                          });
    if (std::ranges::none_of(comparison.sources,
                             [](const RunRecord& r) { return r.series("samples", "wetted_length") != nullptr; }))
        return;
    q.definition += "; known to half the spacing at the hull at best";
    judge(q, comparison.names, comparison.agree_within);
    comparison.quantities.push_back(std::move(q));
}

}  // namespace tw
