#include "compare/ablate/ablation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "record/record_numbers.h"
#include "compare/verdict/left_out.h"
#include "methods/methods.h"

namespace tw {

namespace {

using Seen = AblationChange::Seen;

bool is_probe(const Quantity& q) { return q.name.starts_with("pressure:") || q.name.starts_with("height:"); }

const AblationSide* side_of(const AblationRun& run, const std::string& method) {
    const auto found = std::ranges::find(run.sides, method, &AblationSide::method);
    return found == run.sides.end() ? nullptr : &*found;
}

double per_cent_change(double before, double after) {
    return before > 0 && std::isfinite(after) ? 100 * (after / before - 1) : nan;
}

AblationChange change_of(const Quantity& before, const Quantity& after) {
    AblationChange c;
    c.name = before.name, c.label = before.label, c.unit = before.unit;
    c.before = before.values.front(), c.after = after.values.front();
    if (!c.before.known || !c.after.known) {
        const bool first = !c.before.known;
        const MeanValue& unknown = first ? c.before : c.after;
        c.remark =
            fmt::format("{}: {}", first ? "before" : "after", unknown.why_not.empty() ? "not known" : unknown.why_not);
        return c;
    }
    c.difference = c.after.value - c.before.value;
    const double size = std::max(std::abs(c.before.value), before.scale);
    const double sign = c.before.value < 0 && size == -c.before.value ? -1 : 1;
    if (size > 0) c.per_cent = 100 * c.difference / (sign * size);
    const bool intervals = c.before.half_width > 0 && c.after.half_width > 0;
    if (intervals) {
        c.interval = std::hypot(c.before.half_width, c.after.half_width);
        if (size > 0) c.per_cent_interval = 100 * c.interval / size;
    }
    if (c.difference == 0)
        c.seen = Seen::unchanged;
    else if (!intervals)
        c.seen = Seen::no_interval;
    else
        c.seen = std::abs(c.difference) > c.interval ? Seen::seen : Seen::nothing;
    return c;
}

AblationRow row_of(const AblationRun& run, std::size_t index, const AblationSide& before, const AblationSide& after) {
    AblationRow row;
    row.run = index;
    // What the plan had said before the effect was switched.
    const auto planned = std::ranges::find(before.effects, run.effect, &EffectChoice::name);
    if (planned != before.effects.end()) row.influence = planned->influence;
    for (const Quantity& b : before.quantities) {
        if (b.values.empty() || !(b.judged || is_probe(b))) continue;
        const auto a = std::ranges::find(after.quantities, b.name, &Quantity::name);
        if (a == after.quantities.end() || a->values.empty()) continue;
        if (!b.values.front().known && !a->values.front().known) continue;  // neither run can tell
        row.changes.push_back(change_of(b, *a));
        row.changes.back().predicted = influence_on(b.name, row.influence);
    }
    row.processor_before = before.processor, row.processor_after = after.processor;
    row.cost = per_cent_change(before.processor, after.processor);
    row.steps = per_cent_change(before.steps, after.steps);
    if (elements_of(before.method) == "particles")
        row.predicted_cost = predicted_cost_change(before.effects, after.effects);
    return row;
}

}  // namespace

AblationSide ablation_side(RunRecord record) {
    AblationSide side;
    side.method = text_of(record, "method", "unnamed");
    side.effects = record.effects;
    const double duration = number_of(record, "duration", 0);
    if (duration > 0) {
        double processor = 0;
        for (const Phase& p : record.phases)
            if (p.name == "solving") processor += p.cpu;
        if (processor > 0) side.processor = processor / duration;
        if (record.steps > 0) side.steps = record.steps / duration;
    }
    std::vector<RunRecord> alone;
    alone.push_back(std::move(record));
    side.quantities = compare_records(std::move(alone)).quantities;
    return side;
}

std::string to_string(Seen seen) {
    switch (seen) {
        case Seen::unchanged: return "unchanged";
        case Seen::nothing: return "nothing seen";
        case Seen::seen: return "seen";
        case Seen::no_interval: return "no interval";
        case Seen::not_known: break;
    }
    return "not known";
}

double predicted_cost_change(const std::vector<EffectChoice>& before, const std::vector<EffectChoice>& after) {
    const auto factor = [](const std::vector<EffectChoice>& plan) {
        double product = 1;
        for (const EffectChoice& e : plan)
            if (e.on) product *= 1 + e.cost;
        return product;
    };
    return 100 * (factor(after) / factor(before) - 1);
}

Ablation build_ablation(std::string title, std::vector<AblationRun> runs) {
    if (runs.empty() || runs.front().sides.empty())
        throw InputError("an ablation without a base run; expected the scene as it is first");
    Ablation ablation;
    ablation.title = std::move(title);
    ablation.runs = std::move(runs);
    for (std::size_t i = 1; i < ablation.runs.size(); ++i) {
        if (ablation.runs[i].against >= i)
            throw InputError(ablation.runs[i].name + ": compared with a run that does not come before it");
        const AblationRun& reference = ablation.runs[ablation.runs[i].against];
        if (ablation.runs[i].why_not.empty() && reference.sides.empty())
            ablation.runs[i].why_not = fmt::format("there is no run \"{}\" to compare it with", reference.name);
    }
    for (const AblationSide& base : ablation.runs.front().sides) {
        AblationMethod method{base.method, {}};
        for (std::size_t i = 1; i < ablation.runs.size(); ++i) {
            const AblationRun& run = ablation.runs[i];
            const AblationSide* after = side_of(run, base.method);
            const AblationSide* before = side_of(ablation.runs[run.against], base.method);
            if (before && after) method.rows.push_back(row_of(run, i, *before, *after));
        }
        ablation.methods.push_back(std::move(method));
    }
    return ablation;
}

std::vector<std::string> headline_of(const AblationMethod& method) {
    constexpr std::size_t most = 6;
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        const bool known = std::ranges::any_of(method.rows, [&](const AblationRow& row) {
            const auto c = std::ranges::find(row.changes, name, &AblationChange::name);
            return c != row.changes.end() && c->seen != Seen::not_known;
        });
        if (known && names.size() < most && std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    for (const char* name : {"drag", "lift", "trim_moment", "wetted_length", "splash_sheet_height", "splash_p99"})
        add(name);
    if (!names.empty() && names.front() == "drag") return names;
    for (const AblationRow& row : method.rows)  // a tank: its probes
        for (const AblationChange& c : row.changes)
            if (c.name.find(':') != c.name.npos) add(c.name);
    return names;
}

}  // namespace tw
