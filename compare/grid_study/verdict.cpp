#include "compare/grid_study/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/report/numbers.h"
#include "compare/report/sentences.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"

namespace tw {

namespace {

/// One share of the joint interval, and what it is called.
struct Term {
    double U;
    std::string name;
    std::size_t side;
    enum { statistics, discretisation, choice } kind;
};

std::vector<Term> terms_of(const GridStudyDifference& d, const GridStudyQuantity& q,
                           const std::vector<GridStudySide>& sides) {
    std::vector<Term> terms;
    for (const std::size_t k : {d.a, d.b}) {
        const GridStudyValue& v = q.values[k];
        terms.push_back({v.statistical, method_label(sides[k].method) + "'s mean", k, Term::statistics});
        terms.push_back({v.estimate.uncertainty, method_label(sides[k].method) + "'s discretisation error", k,
                         Term::discretisation});
        for (const Sensitivity& s : v.sensitivities)
            if (std::isfinite(s.uncertainty) && !s.box && s.input.empty())
                terms.push_back({s.uncertainty, method_label(sides[k].method) + "'s " + s.name, k, Term::choice});
    }
    return terms;
}

/// Of both methods.
double discretisation_of(const GridStudyDifference& d, const GridStudyQuantity& q) {
    return std::hypot(q.values[d.a].estimate.uncertainty, q.values[d.b].estimate.uncertainty);
}

/// Wall time of the runs that would bring the joint interval to the target: where the discretisation error is the
/// largest term finer runs that make its terms smaller by one factor, by the slopes of the grid study; where a mean is,
/// a longer record of that method. nan: not known, or the other terms are above the target.
double seconds_to_target(const GridStudyDifference& d, const GridStudyQuantity& q,
                         const std::vector<GridStudySide>& sides, const Term& largest, double target_U) {
    const double D = discretisation_of(d, q);
    const double U = largest.kind == Term::discretisation ? D : largest.U;
    const double room = target_U * target_U - (d.interval * d.interval - U * U);
    if (!(room > 0) || largest.kind == Term::choice) return std::nan("");
    const GridStudyRun& longer = sides[largest.side].runs.front();
    if (largest.kind == Term::statistics) return longer.seconds > 0 ? longer.seconds * U * U / room : std::nan("");
    double seconds = 0;
    for (const std::size_t k : {d.a, d.b}) {
        const GridStudyValue& v = q.values[k];
        const double needed = v.estimate.uncertainty * std::sqrt(room) / D;
        if (v.estimate.uncertainty * v.estimate.uncertainty > 0.1 * room) seconds += v.cost.seconds_for(needed);
    }
    return seconds;
}

/// What would make the largest term small enough for the target, the others as they are. Finer runs make the
/// discretisation error of both methods smaller.
std::string remedy(const Term& term, const GridStudyDifference& d, const GridStudyQuantity& q,
                   const GridStudySide& side, double target_U) {
    const double together = term.kind == Term::discretisation ? discretisation_of(d, q) : term.U;
    const double rest = d.interval * d.interval - together * together, room = target_U * target_U - rest;
    if (!(room > 0)) return "the other terms are already above the target";
    const double needed = std::sqrt(room);
    if (term.kind == Term::statistics) {
        const GridStudyRun& finest = side.runs.front();
        const double longer = std::pow(term.U / needed, 2);
        if (!(finest.duration > 0)) return {};
        const std::string wall = time_text(finest.seconds * longer);
        return fmt::format("a record of about {:.2g} s instead of {:.2g} s would suffice{}", finest.duration * longer,
                           finest.duration, finest.seconds > 0 ? ", about " + wall + " of wall time" : "");
    }
    if (term.kind == Term::choice)
        for (const GridStudyVariation& v : side.variations) {
            const auto base =
                std::ranges::find_if(side.runs, [&](const GridStudyRun& r) { return same_rung(r, v.run); });
            if (!term.name.ends_with(v.name) || !(base->seconds > 0)) continue;
            return fmt::format(
                "making that choice in every run costs {:.2g} times the time and leaves about {:.0f} % of the term",
                v.run.seconds / base->seconds, 100 * (1 - 1 / v.factor));
        }
    if (const Estimate& e = q.values[term.side].estimate;
        term.kind == Term::discretisation && e.convergence == Convergence::scattered)
        return fmt::format("the values scatter by {} {} from size to size: {}", number_text(e.trend_noise.sigma, 2),
                           unit_text(q.unit),
                           e.levels.size() > 3 ? "sizes between these narrow the interval"
                                               : "three cannot distinguish it from a trend; twinwake ladder runs more");
    if (term.kind == Term::discretisation && d.seconds_to_target <= longest_runs)
        return fmt::format("finer runs of {} would suffice, by the slopes of this study",
                           about_text(d.seconds_to_target));
    return {};
}

/// Whether the sizes say nothing of a value's error: what they change is its rounding, that of single precision at most.
bool unseen(const GridStudyValue& v, double size) {
    return no_more_than_rounding(v.own, size) ||
           (v.estimate.convergence == Convergence::unchanged && v.own <= 2e-6 * size);
}

void judge_pair(GridStudyDifference& d, const GridStudyQuantity& q, const std::vector<GridStudySide>& sides,
                double target, double scale) {
    const GridStudyValue &a = q.values[d.a], &b = q.values[d.b];
    for (const std::size_t k : {d.a, d.b})
        if (q.values[k].levels.empty()) {
            d.reason = method_label(sides[k].method) + (q.values[k].absent.empty()
                                                            ? ": no size has a mean"
                                                            : ": no size has a mean; at " + q.values[k].absent.front());
            return;
        }
    const double Sa = a.levels.front().value, Sb = b.levels.front().value;
    const double S = d.size = std::max(std::abs(Sa + Sb) / 2, scale);
    d.difference = no_more_than_rounding(Sb - Sa, S) ? 0 : Sb - Sa;
    if (S > 0) d.per_cent = 100 * d.difference / S;
    for (const std::size_t k : {d.a, d.b})
        if (!std::isfinite(q.values[k].uncertainty)) {
            d.verdict = Verdict::not_converged;
            d.reason = fmt::format("{}: {}", method_label(sides[k].method), q.values[k].estimate.why_not);
            return;
        }
    for (const std::size_t k : {d.a, d.b})
        if (unseen(q.values[k], S) && !no_more_than_rounding(d.difference, S)) {
            d.verdict = Verdict::not_converged;
            d.reason = method_label(sides[k].method) +
                       ": the values do not change with the size, so no uncertainty can be estimated";
            return;
        }
    d.interval = std::hypot(a.own, b.own);
    d.verdict = decide(d.difference, d.interval, target, S);
    if (d.verdict == Verdict::differ && std::abs(d.difference) <= target * S)
        d.reason = fmt::format("beyond the joint interval, yet within the target of {:g} %", 100 * target);
    if (d.verdict != Verdict::undecided && d.verdict != Verdict::no_answer) return;
    const std::vector<Term> terms = terms_of(d, q, sides);
    const Term& largest = *std::ranges::max_element(terms, {}, &Term::U);
    d.seconds_to_target = seconds_to_target(d, q, sides, largest, target * S);
    const std::string cure = remedy(largest, d, q, sides[largest.side], target * S);
    const bool answered = d.verdict == Verdict::undecided;
    d.reason = fmt::format("the interval is wider than {}; largest term: {} (± {} {}){}",
                           answered ? fmt::format("the target of {:g} %", 100 * target)
                                    : fmt::format("{:g} % of the value, too wide to judge by", 100 * widest_answer),
                           largest.name, number_text(largest.U, 2), unit_text(q.unit), cure.empty() ? "" : "; " + cure);
}

}  // namespace

void judge(GridStudyQuantity& q, const std::vector<GridStudySide>& sides, double target, double scale) {
    for (const GridStudyValue& v : q.values)
        if (!v.levels.empty()) q.size = std::max(q.size, std::abs(v.levels.front().value));
    if (sides.size() < 2) {
        q.reason = "one method only";
        return;
    }
    if (sides.size() == 2) return judge_pair(q, q, sides, target, scale);
    for (std::size_t a = 0; a < sides.size(); ++a)
        for (std::size_t b = a + 1; b < sides.size(); ++b) {
            q.pairs.push_back({.a = a, .b = b, .size = q.size});
            judge_pair(q.pairs.back(), q, sides, target, scale);
        }
    static_cast<GridStudyDifference&>(q) = q.pairs[farthest_apart(q.pairs)];
}

}  // namespace tw
