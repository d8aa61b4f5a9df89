#include "compare/metrics/forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/numbers.h"
#include "compare/metrics/quantity.h"
#include "compare/metrics/regular_wave.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"
#include "record/force_names.h"
#include "record/record_numbers.h"
#include "statistics/flow_through.h"
#include "statistics/settled_loads.h"
#include "statistics/settled_mean.h"

namespace tw {

SettledRules settled_rules(const RunRecord& record, const CompareOptions& options, double allowed_error) {
    return {.from = number_of(record, "mean_from", 0),
            .flow_through = flow_through_time(record),
            .fewest_flow_throughs = options.fewest_flow_throughs,
            .fewest_independent = options.fewest_independent,
            .largest_error = options.largest_error,
            .allowed_error = allowed_error};
}

MeanValue mean_of(const RunRecord& record, const std::string& table, const std::string& column,
                  const CompareOptions& options, double allowed_error) {
    const Column* c = record.series(table, column);
    if (!c) {
        MeanValue none;
        none.why_not = not_given;
        return none;
    }
    const std::vector<double>& time = record.tables.at(table).time;
    // what a wave drives does not settle
    if (const double period = number_of(record, "wave_period", 0); is_stream(record) && period > 0)
        return mean_in_periods(record, table, column, periods_of(time, number_of(record, "mean_from", 0), period));
    return settled_mean(time, c->values, settled_rules(record, options, allowed_error));
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

/// What the drags of the sources contain, and how they can be compared all the same.
struct FrictionInDrags {
    bool left_out = false;        ///< only some have friction: pressure parts are compared
    bool pressure_alone = false;  ///< there is none in any drag that is compared; a source without parts may contain it
};

/// Says in a banner what is left out, or cannot be.
FrictionInDrags friction_in_drags(const std::vector<RunRecord>& sources, std::vector<std::string>& banners) {
    FrictionInDrags found;
    const auto has_drag = [](const RunRecord& r) { return r.series("forces", "fx") != nullptr; };
    const auto with_drag = std::ranges::count_if(sources, has_drag);
    const auto with_friction =
        std::ranges::count_if(sources, [&](const RunRecord& r) { return has_drag(r) && has_friction(r); });
    const bool some_with_friction = with_friction > 0 && with_friction < with_drag;
    found.left_out = some_with_friction && std::ranges::all_of(sources, [](const RunRecord& r) {
                         return !has_friction(r) || r.series("forces", "fx_pressure");
                     });
    if (found.left_out)
        banners.push_back(
            "Only one method solves friction: drag and lift are compared without it (pressure parts); friction is "
            "listed below.");
    else if (some_with_friction)
        banners.push_back(
            "Only some sources include friction in their drag, and not all of them list its part: the drags compared "
            "here differ by it.");
    found.pressure_alone =
        with_drag > 0 && std::ranges::all_of(sources, [&](const RunRecord& r) {
            return !has_drag(r) || (r.series("forces", "fx_pressure") && text_of(r, "friction") != "included" &&
                                    (found.left_out || !has_friction(r)));
        });
    return found;
}

struct MeanForce {
    const char* name;
    std::string label, unit;
    const char *column, *pressure;  ///< of the table `forces`; pressure: null, the moment has no such part
    std::string definition;
};

/// `arm`: lift times length [N m], the scale of a moment, whose mean is often near zero; 0 for forces.
Quantity force_quantity(const Comparison& comparison, const MeanForce& f, bool leave_friction_out, double arm,
                        const CompareOptions& options) {
    const bool moment = !f.pressure;
    Quantity q = quantity(comparison, f.name, f.label, f.unit, f.definition, [&](const RunRecord& r) {
        const bool pressure_only = leave_friction_out && !moment && has_friction(r) && r.series("forces", f.pressure);
        MeanValue m = mean_of(r, "forces", pressure_only ? f.pressure : f.column, options, 1e-3 * arm);
        widen_where_ended(r, m, 0.1 * arm);
        return m;
    });
    if (leave_friction_out) q.remark = moment ? "friction included where solved" : "friction left out on both sides";
    if (moment) q.scale = 0.1 * arm;
    return q;
}

/// Forces in a stream are judged, with what is not known of the draft; what a tank's event leaves of a mean as well.
void add_force(Comparison& comparison, Quantity q, bool stream) {
    std::string shared_name;
    const double shared = draft_term(comparison, q.name, shared_name);
    if (stream || any_known(q))
        judge(q, comparison.names, comparison.agree_within, shared, shared_name);
    else
        beside(q);  // an event: metrics/tank_loads.h
    if (shared > 0) q.remark += (q.remark.empty() ? "" : "; ") + ("interval includes " + shared_name);
    comparison.quantities.push_back(std::move(q));
}

/// Parts of the forces, those of the air, and what is wetted: not judged.
void add_parts(Comparison& comparison, const CompareOptions& options, const ForceNames& called, bool drag_is_pressure,
               const std::string& per_span) {
    struct Part {
        const char* name;
        std::string label, unit;
        const char *table, *column;
        std::string definition;
    };
    const std::string &up = called.up, &along = called.along, &friction = called.friction;
    const std::string drag = lower_case_first(along), newton = "N" + per_span;
    for (const Part& b :
         {Part{"drag_pressure", drag_is_pressure ? along + " by pressure" : "Pressure drag", newton, "forces",
               "fx_pressure", "pressure part of the " + drag},
          Part{"drag_friction", friction, newton, "forces", "fx_viscous",
               "viscous part of the " + drag +
                   ", as if the wet faces touched water alone; zero where no physical viscosity is solved"},
          Part{"drag_friction_uncorrected", friction + ", not corrected for air", newton, "forces",
               "fx_viscous_uncorrected", "friction of the mixture of water and air at the wet faces"},
          Part{"drag_air", along + " by air", newton, "forces", "fx_air",
               "force of the air, of a method that solves it (a mesh: on the dry faces); not compared"},
          Part{"lift_air", up + " by air", newton, "forces", "fz_air",
               "force of the air, of a method that solves it (a mesh: on the dry faces); not compared"},
          Part{"drag_total", along + ", air included", newton, "forces", "fx_total", "all faces; not compared"},
          Part{"lift_total", up + ", air included", newton, "forces", "fz_total", "all faces; not compared"},
          Part{"ventilation", "Share of air in the water at the hull", "-", "samples", "ventilation",
               "share of air in the fluid at the wet part of the hull; the friction is too low by this share"},
          Part{"wetted_area", "Wetted area", "m2" + per_span, "samples", "wetted_area",
               "area of the hull that water touches"}})
        add_beside(comparison, quantity(comparison, b.name, b.label, b.unit, b.definition, [&](const RunRecord& r) {
                       return mean_of(r, b.table, b.column, options, HUGE_VAL);
                   }));
}

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

void add_forces(Comparison& comparison, const CompareOptions& options) {
    const auto& sources = comparison.sources;
    if (std::ranges::none_of(sources, [](const RunRecord& r) { return r.tables.contains("forces"); })) return;
    // The load on a body that moves does not settle; metrics/bodies.h has its measures.
    if (std::ranges::any_of(sources, has_moving_bodies)) return;
    const FrictionInDrags friction = friction_in_drags(sources, comparison.banners);
    // In two dimensions forces are per metre of span.
    const bool flat =
        std::ranges::any_of(sources, [](const RunRecord& r) { return number_of(r, "dimensions", 3) == 2; });
    const std::string per_span = flat ? "/m" : "";
    const bool stream = std::ranges::any_of(sources, is_stream);
    const ForceNames called = force_names(stream);
    const std::string on = stream ? "on the whole hull" : "on the solids";
    const MeanForce lift{"lift", called.up,     "N" + per_span,
                         "fz",   "fz_pressure", "mean vertical force of the water " + on};
    const MeanForce drag{"drag",         stream && friction.pressure_alone ? "Pressure drag" : called.along,
                         "N" + per_span, "fx",
                         "fx_pressure",  "mean force of the water " + on + (stream ? " along the stream" : " along x")};
    const MeanForce moment{
        "trim_moment",
        called.moment,
        "N m" + per_span,
        "my",
        nullptr,
        "mean moment of the water about one point for all sources (moment_reference), bow up positive; "
        "its target is taken of at least a tenth of lift times length"};

    const auto add = [&](const MeanForce& f, double arm) {
        Quantity q = force_quantity(comparison, f, friction.left_out, arm, options);
        double largest = 0;
        for (const MeanValue& m : q.values)
            if (m.known) largest = std::max(largest, std::abs(m.value));
        if (std::ranges::any_of(sources, [&](const RunRecord& r) { return r.series("forces", f.column) != nullptr; }))
            add_force(comparison, std::move(q), stream);
        return largest;
    };
    double length = 0;
    for (const RunRecord& r : sources) length = std::max(length, number_of(r, "length", 0));
    const double largest_lift = add(lift, 0);
    add(drag, 0);
    add(moment, largest_lift * length);
    add_parts(comparison, options, called, !stream || friction.pressure_alone, per_span);
    add_sph_measures(comparison, options, called, "N" + per_span);
}

void add_total_drag(Comparison& comparison, const CompareOptions& options) {
    const Quantity* drag = comparison.find("drag");
    if (!drag) return;
    const std::string unit = drag->unit;
    const Quantity line = quantity(comparison, "friction_line", "Friction by a line", unit,
                                   "friction of a flat plate (ITTC 1957) on the wetted area that the method finds",
                                   [&](const RunRecord& r) { return friction_by_line(r, options); });
    if (!any_known(line)) return;
    Quantity q = new_quantity("total_drag", "Total drag", unit,
                              "drag by pressure and friction; the friction is solved, or that of a flat plate (ITTC "
                              "1957) on the wetted area that the method finds");
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
                                        "C_T = R_T / (1/2 rho S U^2), S: the wetted area that the method finds");
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
