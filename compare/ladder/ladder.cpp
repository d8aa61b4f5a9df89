#include "compare/ladder/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.h"

namespace tw {

std::string to_string(LadderVerdict verdict) {
    switch (verdict) {
        case LadderVerdict::agree: return "agree";
        case LadderVerdict::differ: return "differ";
        case LadderVerdict::undecided: return "undecided";
        case LadderVerdict::not_converged: return "not_converged";
        case LadderVerdict::not_comparable: break;
    }
    return "not_comparable";
}

namespace {

constexpr double scheme_order = 2;

/// One run of the ladder and what it measured.
struct Rung {
    double spacing, seconds, elements;
    std::string likeness;  ///< equal in runs that differ in resolution only
    std::vector<Quantity> quantities;
};

Rung rung_of(RunRecord record, const CompareOptions& options) {
    const auto spacing = record.numbers.find("near_hull");
    if (spacing == record.numbers.end() || !(spacing->second > 0))
        throw InputError(fmt::format("the {} record has no spacing at the hull (number near_hull); a ladder needs one",
                                     record.attributes["method"]));
    Rung rung{spacing->second, 0, record.elements, {}, {}};
    for (const Phase& phase : record.phases) rung.seconds += phase.wall;
    rung.likeness = record.attributes["hull_hash"];
    for (const char* name : {"speed", "draft", "trim", "duration", "h_over_dp", "alpha"})
        if (const auto n = record.numbers.find(name); n != record.numbers.end())
            rung.likeness += fmt::format(" {}={:.9g}", name, n->second);
    std::vector<RunRecord> one;
    one.push_back(std::move(record));
    rung.quantities = compare_records(std::move(one), options).quantities;
    return rung;
}

LadderValue value_of(const std::vector<Rung>& rungs, const std::string& name) {
    LadderValue v;
    for (const Rung& rung : rungs) {
        const auto q = std::find_if(rung.quantities.begin(), rung.quantities.end(),
                                    [&](const Quantity& x) { return x.name == name; });
        if (q == rung.quantities.end() || q->values.empty() || !q->values[0].known) {
            const std::string why =
                q == rung.quantities.end() || q->values.empty() ? "not measured" : q->values[0].why_not;
            v.absent.push_back(fmt::format("{:g} m: {}", rung.spacing, why));
            continue;
        }
        if (v.levels.empty()) v.statistical = q->values[0].half_width;
        v.levels.push_back({rung.spacing, q->values[0].value});
    }
    if (v.levels.empty()) return v;
    v.estimate = estimate(v.levels, scheme_order);
    v.uncertainty = std::hypot(v.statistical, v.estimate.uncertainty);
    return v;
}

void judge(LadderQuantity& q, const std::vector<LadderSide>& sides, double target) {
    if (sides.size() < 2) {
        q.reason = "one method only";
        return;
    }
    const LadderValue &a = q.values[0], &b = q.values[1];
    for (std::size_t k = 0; k < 2; ++k)
        if (q.values[k].levels.empty()) {
            q.reason = sides[k].method + ": no level has a mean";
            return;
        }
    const double S0 = a.levels.front().value, S1 = b.levels.front().value, S = std::abs(S0 + S1) / 2;
    q.difference = S1 - S0;
    if (S > 0) q.per_cent = 100 * q.difference / S;
    for (std::size_t k = 0; k < 2; ++k)
        if (!std::isfinite(q.values[k].uncertainty)) {
            q.verdict = LadderVerdict::not_converged;
            q.reason = fmt::format("{}: {}", sides[k].method, q.values[k].estimate.why_not);
            return;
        }
    q.interval = std::hypot(a.uncertainty, b.uncertainty);
    if (std::abs(q.difference) > q.interval) {
        q.verdict = LadderVerdict::differ;
        if (std::abs(q.difference) <= target * S)
            q.reason = fmt::format("a real difference, yet within the target of {:g} %", 100 * target);
        return;
    }
    q.verdict = q.interval <= target * S ? LadderVerdict::agree : LadderVerdict::undecided;
    if (q.verdict == LadderVerdict::agree) return;
    const std::pair<double, std::string> terms[] = {{a.statistical, sides[0].method + "'s mean"},
                                                    {b.statistical, sides[1].method + "'s mean"},
                                                    {a.estimate.uncertainty, sides[0].method + "'s resolution"},
                                                    {b.estimate.uncertainty, sides[1].method + "'s resolution"}};
    const auto& largest = *std::max_element(std::begin(terms), std::end(terms));
    q.reason = fmt::format("the interval is wider than the target of {:g} %; largest term: {} (+- {:.3g} {})",
                           100 * target, largest.second, largest.first, q.unit);
}

}  // namespace

Ladder build_ladder(std::vector<RunRecord> records, const CompareOptions& options) {
    if (records.empty()) throw InputError("a ladder without a finished run; expected one or more");
    Ladder ladder;
    ladder.title = records.front().attributes["title"];
    ladder.agree_within = options.agree_within;
    std::map<std::string, std::vector<Rung>> by_method;
    for (RunRecord& record : records) {
        const std::string method = record.attributes["method"];
        by_method[method].push_back(rung_of(std::move(record), options));
    }
    if (by_method.size() > 2)
        throw InputError(fmt::format("{} methods in one ladder; expected one or two", by_method.size()));
    std::vector<std::vector<Rung>> rungs;
    for (const char* method : {"sph", "fvm"})  // in this order; others behind them by name
        if (auto node = by_method.extract(method)) {
            ladder.sides.push_back({method, {}, {}, {}});
            rungs.push_back(std::move(node.mapped()));
        }
    for (auto& [method, of_method] : by_method) {
        ladder.sides.push_back({method, {}, {}, {}});
        rungs.push_back(std::move(of_method));
    }
    std::vector<Quantity> known;  // the union of what the runs measured, in their order
    for (std::size_t k = 0; k < rungs.size(); ++k) {
        LadderSide& side = ladder.sides[k];
        std::sort(rungs[k].begin(), rungs[k].end(), [](const Rung& x, const Rung& y) { return x.spacing < y.spacing; });
        for (const Rung& rung : rungs[k]) {
            if (!side.spacing.empty() && rung.spacing <= side.spacing.back() * (1 + 1e-6))
                throw InputError(fmt::format("two {} runs with the spacing {:g} m; expected one run of every size",
                                             side.method, rung.spacing));
            side.spacing.push_back(rung.spacing);
            side.seconds.push_back(rung.seconds);
            side.elements.push_back(rung.elements);
            side.similar = side.similar && rung.likeness == rungs[k].front().likeness;
            for (const Quantity& q : rung.quantities)
                if (q.judged &&
                    std::none_of(known.begin(), known.end(), [&](const Quantity& x) { return x.name == q.name; }))
                    known.push_back(q);
        }
    }
    for (const Quantity& from : known) {
        LadderQuantity q;
        q.name = from.name, q.label = from.label, q.unit = from.unit;
        for (const std::vector<Rung>& of_side : rungs) q.values.push_back(value_of(of_side, q.name));
        judge(q, ladder.sides, ladder.agree_within);
        ladder.quantities.push_back(std::move(q));
    }
    return ladder;
}

}  // namespace tw
