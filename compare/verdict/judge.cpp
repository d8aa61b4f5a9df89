#include "compare/verdict/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
namespace tw {

std::string to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::agree: return "agree";
        case Verdict::differ: return "differ";
        case Verdict::undecided: return "undecided";
        case Verdict::not_converged: return "not_converged";
        case Verdict::not_estimated: return "discretisation error not estimated";
        case Verdict::not_comparable: break;
    }
    return "not_comparable";
}

namespace {

void add_remark(Quantity& q, const std::string& text) {
    if (!q.remark.empty()) q.remark += "; ";
    q.remark += text;
}

void judge_incomplete(Quantity& q, const std::vector<std::string>& names) {
    bool all_too_short = true;
    for (std::size_t i = 0; i < q.values.size(); ++i) {
        if (q.values[i].known) continue;
        if (!(q.values[i].seconds_needed > 0)) all_too_short = false;
        add_remark(q, names[i] + ": " + (q.values[i].why_not.empty() ? "not known" : q.values[i].why_not));
    }
    q.verdict = all_too_short ? Verdict::undecided : Verdict::not_comparable;
}

}  // namespace

void judge(Quantity& q, const std::vector<std::string>& names, double target, double shared,
           const std::string& shared_name) {
    q.verdict = Verdict::not_comparable;
    if (q.values.size() < 2) {
        if (q.values.size() == 1 && !q.values[0].known) add_remark(q, q.values[0].why_not);
        return;
    }
    std::size_t a = q.values.size(), b = a;
    double largest = -1;
    for (std::size_t i = 0; i < q.values.size(); ++i)
        for (std::size_t j = i + 1; j < q.values.size(); ++j) {
            const MeanValue &x = q.values[i], &y = q.values[j];
            if (!x.known || !y.known) continue;
            const double u = std::sqrt(x.half_width * x.half_width + y.half_width * y.half_width + shared * shared);
            const double e = std::abs(y.value - x.value);
            const double ratio = e == 0 ? 0 : u > 0 ? e / u : HUGE_VAL;
            if (ratio > largest) {
                largest = ratio;
                a = i;
                b = j;
            }
        }
    if (a == q.values.size() || (q.values.size() == 2 && !(q.values[0].known && q.values[1].known))) {
        judge_incomplete(q, names);
        return;
    }
    const MeanValue &A = q.values[a], &B = q.values[b];
    q.difference = B.value - A.value;
    q.interval = std::sqrt(A.half_width * A.half_width + B.half_width * B.half_width + shared * shared);
    const double mean = 0.5 * std::abs(A.value + B.value), scale = std::max(mean, q.scale);
    q.size = scale;
    if (scale > 0) q.per_cent = 100 * q.difference / scale;
    if (q.values.size() > 2) add_remark(q, "farthest apart: " + names[a] + " and " + names[b]);
    q.verdict = Verdict::not_estimated;
    if (q.interval > target * scale) {
        const MeanValue& wider = A.half_width >= B.half_width ? A : B;
        const std::string who = shared > wider.half_width   ? shared_name
                                : !wider.limited_by.empty() ? wider.limited_by
                                                            : "the mean of " + names[&wider == &A ? a : b];
        // what would make the widest mean's interval small enough, the others as they are
        const double rest2 = q.interval * q.interval - wider.half_width * wider.half_width,
                     room = target * target * scale * scale - rest2, window = wider.to - wider.from;
        const bool longer = shared <= wider.half_width && wider.limited_by.empty() && room > 0 && window > 0;
        add_remark(q, fmt::format("this interval alone is wider than {:g} %; widest: {}{}", 100 * target, who,
                                  longer ? fmt::format("; {:.2g} s of settled record instead of {:.2g} s would suffice",
                                                       window * wider.half_width * wider.half_width / room, window)
                                         : ""));
    }
    for (const std::size_t i : {a, b})
        if (q.values[i].unreliable && q.values[i].limited_by.empty())
            add_remark(q, names[i] + ": two estimates of its interval differ by more than 1.5; the wider is used");
}

void beside(Quantity& q) {
    q.judged = false;
    q.verdict = Verdict::not_comparable;
    if (q.values.size() != 2 || !q.values[0].known || !q.values[1].known) return;
    q.difference = q.values[1].value - q.values[0].value;
    q.interval = std::hypot(q.values[0].half_width, q.values[1].half_width);
    q.size = 0.5 * std::abs(q.values[0].value + q.values[1].value);
    if (q.size > 0) q.per_cent = 100 * q.difference / q.size;
}

}  // namespace tw
