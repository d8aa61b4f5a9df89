#include "compare/sweep/sweep.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "statistics/student_t.h"

namespace tw {

namespace {

void summarise(SweepSummary& s) {
    if (s.points.empty()) return;
    const double n = static_cast<double>(s.points.size());
    const auto ratio = [](const SweepSummary::Point& p) { return std::log(p.b / p.a); };
    s.bias = 0;
    for (const auto& p : s.points) s.bias += ratio(p) / n;
    if (s.points.size() < 2) return;
    double squares = 0;
    for (const auto& p : s.points) squares += std::pow(ratio(p) - s.bias, 2);
    s.scatter = std::sqrt(squares / (n - 1));
    s.interval = student_t_95(n - 1) * s.scatter / std::sqrt(n);
}

/// What one scene says of one quantity and two methods.
void add_point(Sweep& sweep, std::size_t member, const Quantity& q, const Difference& d) {
    auto s = std::ranges::find_if(sweep.summaries, [&](const SweepSummary& other) {
        return other.name == q.name && other.a == d.a && other.b == d.b;
    });
    if (s == sweep.summaries.end()) {
        SweepSummary& fresh = sweep.summaries.emplace_back();
        fresh.name = q.name, fresh.label = q.label, fresh.unit = q.unit;
        fresh.a = d.a, fresh.b = d.b;
        s = std::prev(sweep.summaries.end());
    }
    const MeanValue &a = q.values[d.a], &b = q.values[d.b];
    if (a.known && b.known && a.value * b.value > 0)
        s->points.push_back({member, a.value, b.value, a.bar(), b.bar(), d.interval, d.verdict});
    else
        ++s->left_out;
}

}  // namespace

Sweep build_sweep(std::string title, std::vector<SweepMember> members) {
    if (members.empty()) throw InputError("a sweep without a scene; expected one or more");
    Sweep sweep;
    sweep.title = std::move(title);
    sweep.members = std::move(members);
    for (SweepMember& m : sweep.members) {
        if (m.why_not.empty() && m.methods.size() < 2) m.why_not = "one method only";
        if (m.why_not.empty() && sweep.methods.empty()) sweep.methods = m.methods;
        if (m.why_not.empty() && m.methods != sweep.methods) m.why_not = "other methods than the first scene's";
    }
    for (std::size_t i = 0; i < sweep.members.size(); ++i)
        if (sweep.members[i].why_not.empty())
            for (const Quantity& q : sweep.members[i].quantities)
                if (q.judged && q.values.size() == sweep.methods.size())
                    for (const Difference& d : q.differences()) add_point(sweep, i, q, d);
    for (SweepSummary& s : sweep.summaries) summarise(s);
    return sweep;
}

}  // namespace tw
