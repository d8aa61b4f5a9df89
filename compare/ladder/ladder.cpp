#include "compare/ladder/ladder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.h"
#include "compare/gates.h"
#include "compare/report/numbers.h"
#include "compare/verdict/decide.h"

namespace tw {

namespace {

constexpr double scheme_order = 2;

const Quantity* find(const LadderRun& run, const std::string& name) {
    const auto q = std::ranges::find(run.quantities, name, &Quantity::name);
    return q == run.quantities.end() || q->values.empty() ? nullptr : &*q;
}

Sensitivity sensitivity_of(const LadderSide& side, const LadderVariation& v, const std::string& name) {
    const auto base = std::ranges::find_if(side.runs, [&](const LadderRun& r) { return same_rung(r, v.run); });
    const Quantity *a = find(*base, name), *b = find(v.run, name);
    Sensitivity s{v.name, v.run.spacing, std::nan(""), std::nan(""), std::nan("")};
    if (!a || !b || !a->values[0].known || !b->values[0].known) return s;
    s.value = a->values[0].value, s.varied = b->values[0].value;
    s.uncertainty = v.factor * std::abs(s.varied - s.value);
    return s;
}

LadderValue value_of(const LadderSide& side, const std::string& name) {
    LadderValue v;
    std::vector<const LadderRun*> known;
    for (const LadderRun& run : side.runs) {
        const Quantity* q = find(run, name);
        if (!q || !q->values[0].known) {
            v.absent.push_back(fmt::format("{:g} m: {}", run.spacing, q ? q->values[0].why_not : "not measured"));
            continue;
        }
        known.push_back(&run);
        v.levels.push_back({run.spacing, q->values[0].value, q->values[0].half_width});
        v.half_widths.push_back(q->values[0].half_width);
    }
    if (v.levels.empty()) return v;
    v.statistical = v.half_widths.front();
    v.estimate = estimate(v.levels, scheme_order);
    double squares = v.statistical * v.statistical + v.estimate.uncertainty * v.estimate.uncertainty;
    for (const LadderVariation& variation : side.variations) {
        v.sensitivities.push_back(sensitivity_of(side, variation, name));
        if (const double U = v.sensitivities.back().uncertainty; std::isfinite(U)) squares += U * U;
    }
    v.uncertainty = std::sqrt(squares);
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

/// One share of the joint interval, and what it is called.
struct Term {
    double U;
    std::string name;
    std::size_t side;
    enum { statistics, discretisation, choice } kind;
};

std::vector<Term> terms_of(const LadderQuantity& q, const std::vector<LadderSide>& sides) {
    std::vector<Term> terms;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const LadderValue& v = q.values[k];
        terms.push_back({v.statistical, sides[k].method + "'s mean", k, Term::statistics});
        terms.push_back({v.estimate.uncertainty, sides[k].method + "'s discretisation error", k, Term::discretisation});
        for (const Sensitivity& s : v.sensitivities)
            if (std::isfinite(s.uncertainty))
                terms.push_back({s.uncertainty, sides[k].method + "'s " + s.name, k, Term::choice});
    }
    return terms;
}

/// What would make the largest term small enough for the target, the others as they are.
std::string remedy(const Term& term, const LadderQuantity& q, const LadderSide& side, double target_U) {
    const double rest = q.interval * q.interval - term.U * term.U, room = target_U * target_U - rest;
    if (!(room > 0)) return "the other terms are already above the target";
    const double needed = std::sqrt(room);
    if (term.kind == Term::statistics) {
        const LadderRun& finest = side.runs.front();
        const double longer = std::pow(term.U / needed, 2);
        if (!(finest.duration > 0)) return {};
        const std::string wall = time_text(finest.seconds * longer);
        return fmt::format("a record of about {:.2g} s instead of {:.2g} s would suffice{}", finest.duration * longer,
                           finest.duration, finest.seconds > 0 ? ", about " + wall + " of wall time" : "");
    }
    if (term.kind == Term::choice)
        for (const LadderVariation& v : side.variations) {
            const auto base = std::ranges::find_if(side.runs, [&](const LadderRun& r) { return same_rung(r, v.run); });
            if (!term.name.ends_with(v.name) || !(base->seconds > 0)) continue;
            return fmt::format(
                "making that choice in every run costs {:.2g} times the time and leaves about {:.0f} % of the term",
                v.run.seconds / base->seconds, 100 * (1 - 1 / v.factor));
        }
    if (const Estimate& e = q.values[term.side].estimate;
        term.kind == Term::discretisation && e.convergence == Convergence::scattered)
        return fmt::format("the values scatter by {} {} from size to size: sizes between these narrow the interval",
                           value_text(e.trend_noise.sigma, 0), q.unit);
    const CostOfAccuracy& cost = q.values[term.side].cost;
    if (term.kind == Term::discretisation && cost.known() && std::isfinite(cost.seconds_for(needed)))
        return fmt::format("a finer run of about {} would suffice, by the slope of this ladder",
                           time_text(cost.seconds_for(needed)));
    return {};
}

void judge(LadderQuantity& q, const std::vector<LadderSide>& sides, double target, double scale) {
    for (const LadderValue& v : q.values)
        if (!v.levels.empty()) q.size = std::max(q.size, std::abs(v.levels.front().value));
    if (sides.size() < 2) {
        q.reason = "one method only";
        return;
    }
    const LadderValue &a = q.values[0], &b = q.values[1];
    for (std::size_t k = 0; k < 2; ++k)
        if (q.values[k].levels.empty()) {
            q.reason = sides[k].method + (q.values[k].absent.empty()
                                              ? ": no size has a mean"
                                              : ": no size has a mean; at " + q.values[k].absent.front());
            return;
        }
    const double S0 = a.levels.front().value, S1 = b.levels.front().value;
    const double S = q.size = std::max(std::abs(S0 + S1) / 2, scale);
    q.difference = S1 - S0;
    if (S > 0) q.per_cent = 100 * q.difference / S;
    for (std::size_t k = 0; k < 2; ++k)
        if (!std::isfinite(q.values[k].uncertainty)) {
            q.verdict = Verdict::not_converged;
            q.reason = fmt::format("{}: {}", sides[k].method, q.values[k].estimate.why_not);
            return;
        }
    for (std::size_t k = 0; k < 2; ++k)
        if (no_more_than_rounding(q.values[k].uncertainty, S) && !no_more_than_rounding(q.difference, S)) {
            q.verdict = Verdict::not_converged;
            q.reason = sides[k].method + ": the values do not change with the size, so no uncertainty can be estimated";
            return;
        }
    q.interval = std::hypot(a.uncertainty, b.uncertainty);
    q.verdict = decide(q.difference, q.interval, target, S);
    if (q.verdict == Verdict::differ && std::abs(q.difference) <= target * S)
        q.reason = fmt::format("beyond the joint interval, yet within the target of {:g} %", 100 * target);
    if (q.verdict != Verdict::undecided) return;
    const std::vector<Term> terms = terms_of(q, sides);
    const Term& largest = *std::ranges::max_element(terms, {}, &Term::U);
    const std::string cure = remedy(largest, q, sides[largest.side], target * S);
    q.reason =
        fmt::format("the interval is wider than the target of {:g} %; largest term: {} (± {} {}){}", 100 * target,
                    largest.name, value_text(largest.U, 0), q.unit, cure.empty() ? "" : "; " + cure);
}

/// The runs by method, SPH and FVM in this order and others behind them by name; finest first.
std::vector<LadderSide> sides_of(std::vector<LadderRun> runs) {
    const auto rank = [](const std::string& method) { return method == "sph" ? 0 : method == "fvm" ? 1 : 2; };
    std::ranges::sort(runs, [&](const LadderRun& a, const LadderRun& b) {
        return std::tuple(rank(a.method), a.method, a.spacing) < std::tuple(rank(b.method), b.method, b.spacing);
    });
    std::vector<LadderSide> sides;
    for (LadderRun& run : runs) {
        if (sides.empty() || sides.back().method != run.method) sides.push_back({run.method, {}, {}, true});
        LadderSide& side = sides.back();
        if (!side.runs.empty() && run.spacing <= side.runs.back().spacing * (1 + 1e-6))
            throw InputError(fmt::format("two {} runs with the spacing {:g} m; expected one run of every size",
                                         side.method, run.spacing));
        if (!side.runs.empty()) {
            const Family &first = side.runs.front().family, &here = run.family;
            const bool hashes = !first.hash.empty() && !here.hash.empty();
            if (hashes && first.hash != here.hash)
                throw InputError(fmt::format(
                    "{0} at {1:g} m and {0} at {2:g} m are not of one family: {3}; expected runs of one scene with one "
                    "set of numerics, which differ in their sizes alone",
                    side.method, side.runs.front().spacing, run.spacing, family_differences(first, here)));
            side.similar = side.similar && (hashes || first.likeness == here.likeness);
        }
        side.runs.push_back(std::move(run));
    }
    if (sides.size() > 2) throw InputError(fmt::format("{} methods in one ladder; expected one or two", sides.size()));
    return sides;
}

void add_variation(std::vector<LadderSide>& sides, LadderVariation v) {
    for (LadderSide& side : sides)
        if (std::ranges::any_of(side.runs, [&](const LadderRun& r) { return same_rung(r, v.run); })) {
            side.variations.push_back(std::move(v));
            return;
        }
    throw InputError(fmt::format("{} with {}: the ladder has no {} run of {:g} m that it varies", v.run.method, v.name,
                                 v.run.method, v.run.spacing));
}

Validation validate(const LadderValue& v, const MeanValue& measured, double target) {
    Validation out;
    if (v.levels.empty() || !measured.known) return out;
    out.E = v.levels.front().value - measured.value;
    if (measured.value != 0) out.per_cent = 100 * out.E / std::abs(measured.value);
    out.verdict = Verdict::not_converged;
    if (!std::isfinite(v.uncertainty)) return out;
    out.U_val = std::hypot(v.uncertainty, measured.half_width);
    out.verdict = decide(out.E, out.U_val, target, std::abs(measured.value));
    return out;
}

/// Throws InputError for a value in another unit.
void hold_against(Ladder& ladder, const std::string& source, const std::string& quantity, const std::string& unit,
                  const MeanValue& value) {
    const auto at = std::ranges::find(ladder.quantities, quantity, &LadderQuantity::name);
    if (at == ladder.quantities.end()) return;
    if (at->unit != unit)
        throw InputError(
            fmt::format("{}: {} is in {}, and in the ladder's runs in {}; expected one unit: convert it with "
                        "twinwake import",
                        source, at->label, unit, at->unit));
    Held held{source, value, {}};
    for (const LadderValue& v : at->values) held.validations.push_back(validate(v, value, ladder.agree_within));
    at->held.push_back(std::move(held));
}

/// The half width of a measured quantity's 95 % interval, as the mapping of its column says.
double measured_half_width(const RunRecord& record, const std::string& quantity) {
    static const std::map<std::string, std::string> columns{{"lift", "forces:fz"},
                                                            {"drag", "forces:fx"},
                                                            {"trim_moment", "forces:my"},
                                                            {"wetted_length", "samples:wetted_length"}};
    std::string column;
    if (const auto known = columns.find(quantity); known != columns.end()) column = known->second;
    if (quantity.find("_arrival:") != std::string::npos) return 0;  // a time, not what the column holds
    for (const char* table : {"pressure", "height"})                // "pressure:P1" and "pressure_mean:P1"
        if (const std::size_t colon = quantity.find(':'); colon != std::string::npos && quantity.starts_with(table))
            column = table + quantity.substr(colon);
    const auto at = record.numbers.find("uncertainty:" + column);
    return at == record.numbers.end() ? 0 : at->second;
}

std::vector<double> domain_of(const RunRecord& record) {
    std::vector<double> box;
    const auto number = [&](const std::string& name, double otherwise) {
        const auto n = record.numbers.find(name);
        return n == record.numbers.end() ? otherwise : n->second;
    };
    for (const char* axis : {"x", "y", "z"})
        if (axis[0] != 'y' || number("dimensions", 3) == 3)
            for (const char* end : {"min", "max"}) box.push_back(number(fmt::format("domain_{}_{}", axis, end), 0));
    return box;
}

/// The same tank, but for faces that a spacing has moved.
bool same_domain(const std::vector<double>& a, const std::vector<double>& b, double spacing) {
    return std::ranges::equal(a, b, [&](double x, double y) { return std::abs(x - y) <= spacing; });
}

/// What lies within the runs' time: a peak that only the longer measurement saw is none of theirs.
RunRecord within(RunRecord record, double duration) {
    if (!(duration > 0)) return record;
    for (auto& [name, table] : record.tables) {
        const auto inside = [&](double t) { return t >= 0 && t <= duration * (1 + 1e-6); };
        for (Column& c : table.columns) {
            std::vector<double> values;
            for (std::size_t i = 0; i < c.values.size(); ++i)
                if (inside(table.time[i])) values.push_back(c.values[i]);
            c.values = std::move(values);
        }
        std::erase_if(table.time, [&](double t) { return !inside(t); });
    }
    double& its = record.numbers["duration"];
    its = its > 0 ? std::min(its, duration) : duration;
    return record;
}

void add_measured(Ladder& ladder, const RunRecord& record) {
    const auto text = [&](const std::string& name) {
        const auto at = record.attributes.find(name);
        return at == record.attributes.end() ? std::string() : at->second;
    };
    const std::string source = text("method");
    const LadderRun& run = ladder.sides.front().runs.front();
    if (text("hull_hash") != run.hull_hash)
        throw InputError(
            source + ": measured on another hull than the ladder's; expected a mapping whose scene is the ladder's");
    if (run.hull_hash.empty() && !same_domain(domain_of(record), run.domain, run.spacing))
        throw InputError(
            fmt::format("{}: measured in another tank than the ladder's: it spans {:.4g} m, the ladder's "
                        "{:.4g} m; expected a mapping whose scene is the ladder's",
                        source, fmt::join(domain_of(record), " "), fmt::join(run.domain, " ")));
    double shortest = HUGE_VAL;
    for (const LadderSide& side : ladder.sides)
        for (const LadderRun& r : side.runs)
            if (r.duration > 0) shortest = std::min(shortest, r.duration);
    for (const Quantity& q : compare_records({within(record, std::isfinite(shortest) ? shortest : 0)}).quantities) {
        if (q.values.empty() || !q.values[0].known) continue;
        MeanValue value = q.values[0];
        value.half_width = std::hypot(value.half_width, measured_half_width(record, q.name));
        hold_against(ladder, source, q.name, q.unit, value);
    }
}

/// Of the finest run that has them: the same formula says the same of every size.
void add_references(Ladder& ladder) {
    for (const LadderSide& side : ladder.sides)
        for (const LadderRun& run : side.runs) {
            if (run.references.empty()) continue;
            for (const Reference& r : run.references) {
                MeanValue value;
                value.known = true, value.value = r.value, value.half_width = r.half_width;
                if (r.in_range)
                    hold_against(ladder, r.remark.empty() ? r.source : r.source + " (" + r.remark + ")", r.quantity,
                                 r.unit, value);
            }
            return;
        }
}

}  // namespace

bool same_rung(const LadderRun& a, const LadderRun& b) {
    return a.method == b.method && std::abs(a.spacing / b.spacing - 1) < 1e-6;
}

LadderRun ladder_run(RunRecord record, const CompareOptions& options) {
    const auto spacing = record.numbers.find("near_hull");
    if (spacing == record.numbers.end() || !(spacing->second > 0))
        throw InputError(fmt::format("the {} record has no spacing at the hull (number near_hull); a ladder needs one",
                                     record.attributes["method"]));
    LadderRun run;
    run.title = record.attributes["title"], run.method = record.attributes["method"];
    run.spacing = spacing->second, run.elements = record.elements, run.memory = record.peak_memory;
    run.predicted_seconds = record.numbers["predicted_seconds"], run.duration = record.numbers["duration"];
    for (const Phase& phase : record.phases) run.seconds += phase.wall, run.core_seconds += phase.cpu;
    run.hull_hash = record.attributes["hull_hash"];
    run.calibrated = record.attributes["calibrated"];
    run.family = family_of(record);
    run.domain = domain_of(record);
    std::vector<RunRecord> one;
    one.push_back(std::move(record));
    Comparison comparison = compare_records(std::move(one), options);
    run.quantities = std::move(comparison.quantities);
    run.references = std::move(comparison.references);
    run.failed_checks = failed_gates(std::move(comparison.gates));
    return run;
}

std::vector<LadderVariation> take_variations(std::vector<LadderRun>& runs) {
    std::vector<LadderVariation> variations;
    std::vector<LadderRun> kept;
    for (LadderRun& run : runs) {
        std::optional<Varied> choice;
        for (const LadderRun& base : runs)
            if (&base != &run && same_rung(base, run) && !run.family.hash.empty() &&
                base.family.hash != run.family.hash && !choice)
                choice = variation_between(base.family, run.family);
        if (choice)
            variations.push_back({choice->name, choice->factor, run});
        else
            kept.push_back(run);
    }
    runs = std::move(kept);
    return variations;
}

Ladder build_ladder(std::vector<LadderRun> runs, std::vector<LadderVariation> variations, double agree_within,
                    const std::vector<RunRecord>& measured) {
    if (runs.empty()) throw InputError("a ladder without a finished run; expected one or more");
    Ladder ladder;
    ladder.title = runs.front().title;
    ladder.agree_within = agree_within;
    ladder.sides = sides_of(std::move(runs));
    if (ladder.sides.size() > 1 && ladder.sides[0].runs.front().hull_hash != ladder.sides[1].runs.front().hull_hash)
        throw InputError(
            fmt::format("{} and {} were not run with the same hull: their difference would not be one of "
                        "method; expected records of one scene",
                        ladder.sides[0].method, ladder.sides[1].method));
    for (LadderVariation& v : variations) add_variation(ladder.sides, std::move(v));
    for (const LadderSide& side : ladder.sides)  // the union of what the runs measured, in their order
        for (const LadderRun& run : side.runs)
            for (const Quantity& from : run.quantities)
                if (from.judged || from.judged_in_ladder) {
                    const auto at = std::ranges::find(ladder.quantities, from.name, &LadderQuantity::name);
                    if (at != ladder.quantities.end() && at->unit != from.unit)
                        throw InputError(
                            fmt::format("{} at {:g} m: {} is in {}, elsewhere in {}; expected one unit in "
                                        "all records",
                                        side.method, run.spacing, from.label, from.unit, at->unit));
                    if (at != ladder.quantities.end()) continue;
                    LadderQuantity q;
                    q.name = from.name, q.label = from.label, q.unit = from.unit;
                    ladder.quantities.push_back(std::move(q));
                }
    for (LadderQuantity& q : ladder.quantities) {
        for (const LadderSide& side : ladder.sides) q.values.push_back(value_of(side, q.name));
        double scale = 0;
        for (const LadderSide& side : ladder.sides)
            for (const LadderRun& run : side.runs)
                if (const Quantity* of_run = find(run, q.name)) scale = std::max(scale, of_run->scale);
        judge(q, ladder.sides, ladder.agree_within, scale);
    }
    for (const LadderSide& side : ladder.sides)
        for (const LadderRun& run : side.runs)
            if (const std::string line = side.method + ": " + run.calibrated;
                !run.calibrated.empty() && std::ranges::find(ladder.calibrated, line) == ladder.calibrated.end())
                ladder.calibrated.push_back(line);
    add_references(ladder);
    for (const RunRecord& record : measured) add_measured(ladder, record);
    return ladder;
}

}  // namespace tw
