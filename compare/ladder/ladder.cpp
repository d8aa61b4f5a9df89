#include "compare/ladder/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "compare/gates.h"
#include "compare/ladder/held.h"
#include "compare/ladder/variation.h"
#include "compare/report/numbers.h"
#include "compare/verdict/decide.h"

namespace tw {

namespace {

constexpr double scheme_order = 2;

LadderValue value_of(const std::vector<LadderSide>& sides, std::size_t k, const std::string& name, double scale) {
    const LadderSide& side = sides[k];
    LadderValue v;
    std::vector<const LadderRun*> known;
    for (const LadderRun& run : side.runs) {
        const Quantity* q = find_quantity(run, name);
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
    v.sensitivities = sensitivities_of(sides, k, name, v.levels.front().value, scale);
    for (const Sensitivity& s : v.sensitivities)
        if (double& sum = s.box ? v.box : v.choices; std::isfinite(s.uncertainty)) sum = std::hypot(sum, s.uncertainty);
    v.own = std::hypot(std::hypot(v.statistical, v.estimate.uncertainty), v.choices);  // of three, NaN may get lost
    v.uncertainty = std::hypot(v.own, v.box);
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
            if (std::isfinite(s.uncertainty) && !s.box)
                terms.push_back({s.uncertainty, sides[k].method + "'s " + s.name, k, Term::choice});
    }
    return terms;
}

/// Wall time of the runs that would bring the joint interval to the target: where the discretisation error is the
/// largest term finer runs that make its terms smaller by one factor, by the slopes of the ladder; where a mean is, a
/// longer record of that method. nan: not known, or the other terms are above the target.
double seconds_to_target(const LadderQuantity& q, const std::vector<LadderSide>& sides, const Term& largest,
                         double target_U) {
    double D = 0;
    for (const LadderValue& v : q.values) D = std::hypot(D, v.estimate.uncertainty);
    const double U = largest.kind == Term::discretisation ? D : largest.U;
    const double room = target_U * target_U - (q.interval * q.interval - U * U);
    if (!(room > 0) || largest.kind == Term::choice) return std::nan("");
    const LadderRun& longer = sides[largest.side].runs.front();
    if (largest.kind == Term::statistics) return longer.seconds > 0 ? longer.seconds * U * U / room : std::nan("");
    double seconds = 0;
    for (const LadderValue& v : q.values) {
        const double needed = v.estimate.uncertainty * std::sqrt(room) / D;
        if (v.estimate.uncertainty * v.estimate.uncertainty > 0.1 * room) seconds += v.cost.seconds_for(needed);
    }
    return seconds;
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
    if (term.kind == Term::discretisation && std::isfinite(q.seconds_to_target))
        return fmt::format("finer runs of about {} would suffice, by the slopes of this ladder",
                           time_text(q.seconds_to_target));
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
    q.difference = no_more_than_rounding(S1 - S0, S) ? 0 : S1 - S0;
    if (S > 0) q.per_cent = 100 * q.difference / S;
    for (std::size_t k = 0; k < 2; ++k)
        if (!std::isfinite(q.values[k].uncertainty)) {
            q.verdict = Verdict::not_converged;
            q.reason = fmt::format("{}: {}", sides[k].method, q.values[k].estimate.why_not);
            return;
        }
    for (std::size_t k = 0; k < 2; ++k)
        if (no_more_than_rounding(q.values[k].own, S) && !no_more_than_rounding(q.difference, S)) {
            q.verdict = Verdict::not_converged;
            q.reason = sides[k].method + ": the values do not change with the size, so no uncertainty can be estimated";
            return;
        }
    q.interval = std::hypot(a.own, b.own);
    q.verdict = decide(q.difference, q.interval, target, S);
    if (q.verdict == Verdict::differ && std::abs(q.difference) <= target * S)
        q.reason = fmt::format("beyond the joint interval, yet within the target of {:g} %", 100 * target);
    if (q.verdict != Verdict::undecided) return;
    const std::vector<Term> terms = terms_of(q, sides);
    const Term& largest = *std::ranges::max_element(terms, {}, &Term::U);
    q.seconds_to_target = seconds_to_target(q, sides, largest, target * S);
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
        if (const auto base = std::ranges::find_if(side.runs, [&](const LadderRun& r) { return same_rung(r, v.run); });
            base != side.runs.end()) {
            weigh(v, *base);
            side.variations.push_back(std::move(v));
            return;
        }
    throw InputError(fmt::format("{} with {}: the ladder has no {} run of {:g} m that it varies", v.run.method, v.name,
                                 v.run.method, v.run.spacing));
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
    run.steps = record.steps;
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
        std::optional<LadderVariation> choice;
        for (const LadderRun& base : runs)
            if (&base != &run && same_rung(base, run) && !run.family.hash.empty() &&
                base.family.hash != run.family.hash && !choice)
                choice = variation_between(base, run);
        if (choice)
            variations.push_back(std::move(*choice));
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
    for (const LadderSide& side : ladder.sides) {
        if (const std::string note = steps_note(side); !note.empty()) ladder.notes.push_back(note);
        for (const LadderVariation& v : side.variations)
            if (!v.refused.empty())
                ladder.notes.push_back(fmt::format("{} with {}: no evidence, and no share of the intervals: {}",
                                                   side.method, v.name, v.refused));
    }
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
        double scale = 0;
        for (const LadderSide& side : ladder.sides)
            for (const LadderRun& run : side.runs)
                if (const Quantity* of_run = find_quantity(run, q.name)) scale = std::max(scale, of_run->scale);
        for (std::size_t k = 0; k < ladder.sides.size(); ++k)
            q.values.push_back(value_of(ladder.sides, k, q.name, scale));
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
