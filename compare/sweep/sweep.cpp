#include "compare/sweep/sweep.h"

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "compare/statistics/student_t.h"

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

}  // namespace

Sweep build_sweep(std::string title, std::vector<SweepMember> members) {
    if (members.empty()) throw InputError("a sweep without a scene; expected one or more");
    Sweep sweep;
    sweep.title = std::move(title);
    sweep.members = std::move(members);
    for (SweepMember& m : sweep.members)
        if (m.why_not.empty() && m.methods.size() != 2) m.why_not = "one method only";
    for (std::size_t i = 0; i < sweep.members.size(); ++i) {
        const SweepMember& m = sweep.members[i];
        if (!m.why_not.empty()) continue;
        if (sweep.methods.empty()) sweep.methods = m.methods;
        for (const Quantity& q : m.quantities) {
            if (!q.judged || q.values.size() != 2) continue;
            auto s = std::ranges::find(sweep.summaries, q.name, &SweepSummary::name);
            if (s == sweep.summaries.end()) {
                sweep.summaries.emplace_back().name = q.name;
                sweep.summaries.back().label = q.label, sweep.summaries.back().unit = q.unit;
                s = std::prev(sweep.summaries.end());
            }
            const MeanValue &a = q.values[0], &b = q.values[1];
            if (a.known && b.known && a.value * b.value > 0)
                s->points.push_back({i, a.value, b.value, a.bar(), b.bar(), q.interval, q.verdict});
            else
                ++s->left_out;
        }
    }
    for (SweepSummary& s : sweep.summaries) summarise(s);
    return sweep;
}

}  // namespace tw
