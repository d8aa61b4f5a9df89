#include "compare/verdict/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "methods/methods.h"

namespace tw {

std::string to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::agree: return "agree";
        case Verdict::differ: return "differ";
        case Verdict::undecided: return "undecided";
        case Verdict::no_answer: return "no_answer_yet";
        case Verdict::not_converged: return "not_converged";
        case Verdict::not_estimated: return "discretisation error not estimated";
        case Verdict::not_comparable: break;
    }
    return "not_comparable";
}

namespace {

void add_remark(Difference& d, const std::string& text) {
    if (text.empty()) return;
    if (!d.remark.empty()) d.remark += "; ";
    d.remark += text;
}

/// What is missing of these sources.
void judge_incomplete(Difference& d, const Quantity& q, const std::vector<std::size_t>& sources,
                      const std::vector<std::string>& names) {
    bool all_too_short = true;
    std::vector<std::pair<std::string, std::string>> why;  // and who lacks a value for it
    for (const std::size_t i : sources) {
        const MeanValue& value = q.values[i];
        if (value.known) continue;
        if (!(value.seconds_needed > 0)) all_too_short = false;
        const std::string reason = value.why_not.empty() ? "not known" : value.why_not;
        const auto same = std::ranges::find(why, reason, &std::pair<std::string, std::string>::first);
        if (same == why.end())
            why.emplace_back(reason, method_label(names[i]));
        else
            same->second += " and " + method_label(names[i]);
    }
    for (const auto& [reason, who] : why) add_remark(d, who + ": " + reason);
    d.verdict = all_too_short ? Verdict::undecided : Verdict::not_comparable;
}

/// Numbers of two known values.
void subtract(Difference& d, const Quantity& q, double shared) {
    const MeanValue &A = q.values[d.a], &B = q.values[d.b];
    d.difference = B.value - A.value;
    d.interval = std::sqrt(A.half_width * A.half_width + B.half_width * B.half_width + shared * shared);
    d.size = std::max(0.5 * std::abs(A.value + B.value), q.scale);
    if (d.size > 0) d.per_cent = 100 * d.difference / d.size;
}

/// What makes the interval wider than the target, and how much more record would help.
std::string width_remark(const Difference& d, const Quantity& q, const std::vector<std::string>& names, double target,
                         double shared, const std::string& shared_name) {
    if (!(d.interval > target * d.size)) return {};
    const bool first = q.values[d.a].half_width >= q.values[d.b].half_width;
    const MeanValue& wider = q.values[first ? d.a : d.b];
    const std::string who = shared > wider.half_width   ? shared_name
                            : !wider.limited_by.empty() ? wider.limited_by
                                                        : "the mean of " + method_label(names[first ? d.a : d.b]);
    // what would make the widest mean's interval small enough, the others as they are
    const double rest2 = d.interval * d.interval - wider.half_width * wider.half_width,
                 room = target * target * d.size * d.size - rest2, window = wider.to - wider.from;
    const bool longer = shared <= wider.half_width && wider.limited_by.empty() && room > 0 && window > 0;
    return fmt::format("this interval alone is wider than {:g} %; widest: {}{}", 100 * target, who,
                       longer ? fmt::format("; {:.2g} s of settled record instead of {:.2g} s would suffice",
                                            window * wider.half_width * wider.half_width / room, window)
                              : "");
}

void judge_pair(Difference& d, const Quantity& q, const std::vector<std::string>& names, double target, double shared,
                const std::string& shared_name) {
    if (!q.values[d.a].known || !q.values[d.b].known) return judge_incomplete(d, q, {d.a, d.b}, names);
    subtract(d, q, shared);
    d.verdict = Verdict::not_estimated;
    add_remark(d, width_remark(d, q, names, target, shared, shared_name));
    for (const std::size_t i : {d.a, d.b})
        if (q.values[i].unreliable && q.values[i].limited_by.empty())
            add_remark(d, method_label(names[i]) +
                              ": two estimates of its interval differ by more than a factor of 1.5; the wider is used");
}

}  // namespace

std::vector<Difference> pairs_of(std::size_t sources) {
    std::vector<Difference> pairs;
    for (std::size_t a = 0; sources > 2 && a < sources; ++a)
        for (std::size_t b = a + 1; b < sources; ++b) pairs.push_back({.a = a, .b = b});
    return pairs;
}

void judge(Quantity& q, const std::vector<std::string>& names, double target, double shared,
           const std::string& shared_name) {
    q.verdict = Verdict::not_comparable;
    if (q.values.size() < 2) {
        if (q.values.size() == 1 && !q.values[0].known) add_remark(q, q.values[0].why_not);
        return;
    }
    if (q.values.size() == 2) return judge_pair(q, q, names, target, shared, shared_name);
    q.pairs = pairs_of(q.values.size());
    for (Difference& d : q.pairs) judge_pair(d, q, names, target, shared, shared_name);
    take_farthest(q);
    if (std::isfinite(q.difference)) return;
    std::vector<std::size_t> all(q.values.size());
    std::iota(all.begin(), all.end(), 0);
    judge_incomplete(q, q, all, names);
}

void take_farthest(Quantity& q) {
    Difference farthest = q.pairs[farthest_apart(q.pairs)];
    farthest.remark = q.remark;  // its own stands with the pair
    static_cast<Difference&>(q) = std::move(farthest);
}

void beside(Quantity& q) {
    q.judged = false;
    q.verdict = Verdict::not_comparable;
    q.pairs = pairs_of(q.values.size());
    if (q.values.size() < 2) return;
    for (Difference& d : q.differences())
        if (q.values[d.a].known && q.values[d.b].known) subtract(d, q, 0);
}

}  // namespace tw
