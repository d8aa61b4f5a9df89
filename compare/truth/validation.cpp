#include "compare/truth/validation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "compare/report/numbers.h"
#include "methods/methods.h"

namespace tw {
namespace {

struct OutcomeName {
    Outcome outcome;
    const char *name, *label;
};
constexpr std::array outcome_names{OutcomeName{Outcome::met, "met", "met"},
                                   OutcomeName{Outcome::near, "near", "within the goal, outside its interval"},
                                   OutcomeName{Outcome::undecided, "undecided", "undecided"},
                                   OutcomeName{Outcome::not_converged, "not_converged", "not converged"},
                                   OutcomeName{Outcome::missed, "missed", "missed"},
                                   OutcomeName{Outcome::failed, "failed", "no value"},
                                   OutcomeName{Outcome::not_run, "not_run", "not run"}};

const OutcomeName& row_of(Outcome outcome) { return *std::ranges::find(outcome_names, outcome, &OutcomeName::outcome); }

double median(std::vector<double> all) {
    if (all.empty()) return nan;
    std::ranges::sort(all);
    return (all[(all.size() - 1) / 2] + all[all.size() / 2]) / 2;
}

/// Whether the outer interval holds the truth; the inner one counts where nothing left out has a bound.
bool outer_holds(const ValidatedValue& v, const Truth& truth) {
    const double side = v.E > 0 ? v.outer_below : v.outer_above;  // E > 0: the truth lies below the value
    if (!std::isfinite(side)) return v.holds();
    return std::abs(v.E) <= std::hypot(side, v.input, truth.half_width);
}

void count(FamilySummary& sum, std::vector<double>& errors, const ValidatedQuantity& q, const ValidatedValue& v) {
    if (!std::isfinite(v.value)) return;
    if (q.scale > 0) errors.push_back(100 * std::abs(v.E) / q.scale);
    sum.met += v.outcome == Outcome::met;
    sum.fall_short += falls_short(v, q);
    if (!std::isfinite(v.U_val)) {
        ++sum.without_interval;
        return;
    }
    ++sum.values;
    sum.inner += v.holds();
    sum.outer += outer_holds(v, q.truth);
    const bool narrow = v.U_num < narrow_share * std::abs(v.value);
    sum.narrow += narrow;
    sum.narrow_inner += narrow && v.holds();
}

FamilySummary summary_of(const ValidationReport& report, const std::string& family, const std::string& method) {
    FamilySummary sum{.family = family, .method = method};
    std::vector<double> errors;
    for (const ValidatedCase& c : report.cases) {
        if (!family.empty() && c.family != family) continue;
        for (const CaseCost& cost : c.costs)
            if (cost.method == method) sum.core_seconds += cost.core_seconds;
        for (const ValidatedQuantity& q : c.quantities)
            for (const ValidatedValue& v : q.values)
                if (v.method == method) count(sum, errors, q, v);
    }
    sum.median_error = median(std::move(errors));
    return sum;
}

/// Every value of a report by its name.
struct Named {
    const ValidatedQuantity* quantity = nullptr;
    const ValidatedValue* value = nullptr;
};
using NameOfValue = std::array<std::string, 3>;
std::map<NameOfValue, Named> values_of(const ValidationReport& report) {
    std::map<NameOfValue, Named> all;
    for (const ValidatedCase& c : report.cases)
        for (const ValidatedQuantity& q : c.quantities)
            for (const ValidatedValue& v : q.values)
                if (std::isfinite(v.value)) all[{c.name, q.name, v.method}] = {&q, &v};
    return all;
}

bool was_run(const ValidatedValue& v) { return v.outcome != Outcome::not_run; }

/// "its scene has changed since 0.1.0 (4bc74fc4), 2026-11-29"; empty: nothing has, or it is not known.
std::string changed_since(const ValidatedValue& was, const ValueBasis& is) {
    if (!was.made_for.known() || !is.known()) return "";
    std::vector<const char*> parts;
    if (was.made_for.scene != is.scene) parts.push_back("scene");
    if (was.made_for.definition != is.definition) parts.push_back("definition");
    if (was.made_for.truth != is.truth) parts.push_back("measured truth");
    if (parts.empty()) return "";
    return fmt::format("its {} {} changed since {}, {}", fmt::join(parts, " and "), parts.size() > 1 ? "have" : "has",
                       was.version, was.date);
}

ValidatedValue& value_by(ValidatedQuantity& q, const std::string& method) {
    const auto found = std::ranges::find(q.values, method, &ValidatedValue::method);
    if (found != q.values.end()) return *found;
    q.values.emplace_back().method = method;
    return q.values.back();
}

struct Keeping {
    bool any_kept = false;
    std::vector<std::string> refused = {};  ///< "SPH: not run with this version: ..."
};
Keeping keep_values(ValidatedQuantity& q, const ValidatedQuantity& old) {
    Keeping keeping;
    std::vector<ValidatedValue> kept;
    for (ValidatedValue v : old.values) {
        const auto now = std::ranges::find(q.values, v.method, &ValidatedValue::method);
        if (!was_run(v) || (now != q.values.end() && was_run(*now))) continue;
        const ValueBasis& basis = q.basis[v.method];
        if (const std::string changed = changed_since(v, basis); !changed.empty()) {
            ValidatedValue& refused = value_by(q, v.method);
            refused.why_not = refused.kept_note = "not run with this version: " + changed;
            keeping.refused.push_back(method_label(v.method) + ": " + refused.why_not);
            continue;
        }
        v.kept = true;
        v.kept_note =
            v.made_for.known() && basis.known()
                ? ""
                : "kept; whether its scene has changed since cannot be known, as the report does not say what "
                  "it was made for";
        kept.push_back(std::move(v));
    }
    if (kept.empty()) return keeping;
    keeping.any_kept = true;
    if (!std::isfinite(q.truth.value)) q.truth = old.truth, q.scale = old.scale, q.goal = old.goal;  // from its runs
    if (q.label.empty() || q.label == q.name) q.label = old.label;
    // Where a case was run, a method that has no value and was not refused is not one of its scene's.
    std::erase_if(q.values, [](const ValidatedValue& v) { return !was_run(v) && v.kept_note.empty(); });
    for (ValidatedValue& v : kept) {
        v.discretisation = v.own_discretisation;
        bound_by_spread(v, q);
        judge_against(v, q);
        q.values.push_back(std::move(v));
    }
    std::ranges::sort(q.values, {}, [](const ValidatedValue& v) { return method_rank(v.method); });
    return keeping;
}

std::string in_short(const Named& n) {
    const ValidatedValue& v = *n.value;
    return fmt::format(
        "{} {} ({}; {})", value_text(v.value, v.U_num), n.quantity->unit,
        n.quantity->scale > 0 ? per_cent_text(100 * v.E / n.quantity->scale) : "E = " + value_text(v.E, v.U_val),
        outcome_label(v.outcome));
}

}  // namespace

std::string to_string(Outcome outcome) { return row_of(outcome).name; }
std::string outcome_label(Outcome outcome) { return row_of(outcome).label; }
Outcome outcome_of(const std::string& name) {
    for (const OutcomeName& row : outcome_names)
        if (row.name == name) return row.outcome;
    throw std::out_of_range("no outcome is called " + name);
}

std::vector<std::string> methods_of(const ValidationReport& report) {
    std::vector<std::string> methods;
    for (const ValidatedCase& c : report.cases)
        for (const ValidatedQuantity& q : c.quantities)
            for (const ValidatedValue& v : q.values)
                if (std::ranges::find(methods, v.method) == methods.end()) methods.push_back(v.method);
    std::ranges::sort(methods, {}, [](const std::string& m) { return std::pair(method_rank(m), m); });
    return methods;
}

void judge_against(ValidatedValue& v, const ValidatedQuantity& q) {
    if (!std::isfinite(v.value)) {
        if (v.outcome != Outcome::not_run) v.outcome = Outcome::failed;
        return;
    }
    v.E = v.value - q.truth.value;
    v.U_num = std::hypot(v.statistical, v.discretisation, v.choices);
    v.U_val = std::hypot(v.U_num, v.input, q.truth.half_width);
    if (!std::isfinite(v.statistical) || !std::isfinite(v.discretisation) || !std::isfinite(v.choices))
        v.U_num = v.U_val = nan;  // hypot of an infinite and an unknown one is infinite
    const double off = std::abs(v.E);
    if (!std::isfinite(v.U_val))
        v.outcome = Outcome::not_converged;
    else if (off <= v.U_val)
        v.outcome = v.U_val <= q.goal ? Outcome::met : Outcome::undecided;
    else
        v.outcome = off <= q.goal ? Outcome::near : Outcome::missed;
}

void bound_by_spread(ValidatedValue& v, const ValidatedQuantity& q) {
    const std::string divergent = to_string(Convergence::divergent);
    if ((v.convergence != divergent && v.convergence != small_changes) || std::isfinite(v.own_discretisation)) return;
    const auto [low, high] = std::ranges::minmax(v.sizes, {}, &std::pair<double, double>::second);
    const double U = factor_of_spread * (high.second - low.second);
    v.discretisation = U <= q.goal ? U : nan;
    v.convergence = U <= q.goal ? small_changes : divergent;
}

void judge_by(ValidationReport& report, const std::string& method) {
    const bool own = method == uncertainty_methods().front();
    report.estimator = own ? "" : method;
    for (ValidatedCase& c : report.cases)
        for (ValidatedQuantity& q : c.quantities)
            for (ValidatedValue& v : q.values) {
                if (!std::isfinite(v.value)) continue;
                const auto by = std::ranges::find(v.by_method, method, &MethodEstimate::method);
                v.discretisation = own ? v.own_discretisation : by != v.by_method.end() ? by->uncertainty : nan;
                if (own)
                    bound_by_spread(v, q);
                else {
                    v.order = by != v.by_method.end() ? by->order : nan;
                    v.why_not = by != v.by_method.end() ? by->why_not : "the report does not have this method";
                    v.outer_below = v.outer_above = nan;
                    if (v.convergence == small_changes) v.convergence = to_string(Convergence::divergent);
                }
                judge_against(v, q);
            }
}

std::vector<std::string> keep_values(ValidationReport& report, const ValidationReport& earlier) {
    std::vector<std::string> refused;
    for (ValidatedCase& c : report.cases) {
        const auto before = std::ranges::find(earlier.cases, c.name, &ValidatedCase::name);
        if (before == earlier.cases.end()) continue;
        bool any = false;
        std::string why_refused;
        for (ValidatedQuantity& q : c.quantities) {
            const auto old = std::ranges::find(before->quantities, q.name, &ValidatedQuantity::name);
            if (old == before->quantities.end()) continue;
            const Keeping keeping = keep_values(q, *old);
            any |= keeping.any_kept;
            for (const std::string& what : keeping.refused) {
                refused.push_back(c.name + ", " + q.label + ", " + what);
                if (why_refused.empty()) why_refused = what;
            }
        }
        if (any)
            c.why_not.clear();
        else if (!c.why_not.empty() && !why_refused.empty())
            c.why_not += "; " + why_refused;
        for (const CaseCost& cost : before->costs)
            if (any && std::ranges::find(c.costs, cost.method, &CaseCost::method) == c.costs.end())
                c.costs.push_back(cost);
    }
    return refused;
}

std::vector<EstimatorSummary> estimators_of(const ValidationReport& report) {
    std::vector<EstimatorSummary> all;
    for (const std::string& estimator : uncertainty_methods())
        for (const std::string& method : methods_of(report)) {
            EstimatorSummary sum{.estimator = estimator, .method = method};
            std::vector<double> shares;
            for (const ValidatedCase& c : report.cases)
                for (const ValidatedQuantity& q : c.quantities)
                    for (ValidatedValue v : q.values) {
                        const auto by = std::ranges::find(v.by_method, estimator, &MethodEstimate::method);
                        if (v.method != method || !std::isfinite(v.value) || by == v.by_method.end()) continue;
                        ++sum.values;
                        v.discretisation = by->uncertainty;
                        judge_against(v, q);
                        if (!std::isfinite(v.U_val)) continue;
                        const bool narrow = v.U_num < narrow_share * std::abs(v.value);
                        ++sum.given;
                        sum.holds += v.holds();
                        sum.narrow += narrow;
                        sum.narrow_holds += narrow && v.holds();
                        if (q.scale > 0) shares.push_back(100 * by->uncertainty / q.scale);
                    }
            sum.median_U = median(std::move(shares));
            if (sum.values > 0) all.push_back(std::move(sum));
        }
    return all;
}

bool falls_short(const ValidatedValue& v, const ValidatedQuantity& q) {
    return v.outcome == Outcome::missed || (v.outcome == Outcome::not_converged && !(std::abs(v.E) <= q.goal));
}

std::vector<FamilySummary> summaries_of(const ValidationReport& report) {
    std::vector<std::string> families{""};
    for (const ValidatedCase& c : report.cases)
        if (std::ranges::find(families, c.family) == families.end()) families.push_back(c.family);
    const std::vector<std::string> methods = methods_of(report);
    std::vector<FamilySummary> all;
    for (const std::string& family : families)
        for (const std::string& method : methods)
            if (FamilySummary s = summary_of(report, family, method);
                s.values + s.without_interval > 0 || s.core_seconds > 0)
                all.push_back(std::move(s));
    return all;
}

std::vector<ValidationChange> changes_between(const ValidationReport& earlier, const ValidationReport& now) {
    using Kind = ValidationChange::Kind;
    const std::map<NameOfValue, Named> before = values_of(earlier), after = values_of(now);
    std::vector<ValidationChange> changes;
    const auto add = [&](Kind kind, const NameOfValue& name, const Named& of, std::string was, std::string is) {
        changes.push_back(
            {kind, name[0] + ", " + of.quantity->label + ", " + method_label(name[2]), std::move(was), std::move(is)});
    };
    for (const auto& [name, old] : before) {
        const auto found = after.find(name);
        if (found == after.end()) {
            add(Kind::gone, name, old, in_short(old), "–");
            continue;
        }
        const Named& is = found->second;
        const double grown = std::abs(is.value->E) - std::abs(old.value->E), much = is.quantity->goal / 4;
        if (is.value->outcome > old.value->outcome || grown > much)
            add(Kind::worse, name, is, in_short(old), in_short(is));
        else if (is.value->outcome < old.value->outcome || grown < -much)
            add(Kind::better, name, is, in_short(old), in_short(is));
    }
    for (const auto& [name, is] : after)
        if (!before.contains(name)) add(Kind::new_value, name, is, "–", in_short(is));
    std::ranges::stable_sort(changes, {}, &ValidationChange::kind);
    return changes;
}

}  // namespace tw
