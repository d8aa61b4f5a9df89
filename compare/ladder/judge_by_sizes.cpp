#include "compare/ladder/judge_by_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/read/record_numbers.h"
#include "compare/verdict/decide.h"

namespace tw {

namespace {

bool same_spacing(double a, double b) { return std::abs(a / b - 1) < 1e-6; }

/// The side of the ladder whose finest run of several the record is.
std::optional<std::size_t> side_of(const Ladder& ladder, const RunRecord& record) {
    for (std::size_t k = 0; k < ladder.sides.size(); ++k)
        if (ladder.sides[k].method == text_of(record, "method") && ladder.sides[k].runs.size() > 1 &&
            record.state == "finished" &&
            same_spacing(ladder.sides[k].runs.front().spacing, number_of(record, "near_hull", 0)))
            return k;
    return {};
}

/// Whether the quantity of this side has a mean at its finest size.
bool reaches_the_finest(const Ladder& ladder, const LadderQuantity& q, std::size_t side) {
    const LadderValue& v = q.values[side];
    return !v.levels.empty() && same_spacing(v.levels.front().h, ladder.sides[side].runs.front().spacing);
}

void fill(MeanValue& m, const LadderValue& v) {
    m.discretisation = v.estimate.uncertainty;
    m.choices = std::hypot(v.choices, v.box);
    m.uncertainty = v.uncertainty;
    if (!std::isfinite(v.uncertainty))
        m.no_uncertainty = v.estimate.why_not.empty() ? "not converged" : v.estimate.why_not;
}

std::string sizes_text(const Ladder& ladder) {
    std::string counts;
    for (const LadderSide& side : ladder.sides)
        if (const std::string n = fmt::format("{}", side.runs.size()); counts != n)
            counts += (counts.empty() ? "" : " and ") + n;
    return "runs of " + counts + " sizes";
}

}  // namespace

Statement statement_of(const Ladder& ladder, const LadderQuantity& q) {
    Statement s{.label = q.label, .unit = q.unit};
    s.size = q.size, s.target = ladder.agree_within;
    s.verdict = q.verdict, s.why = q.reason;
    s.seconds_to_target = q.seconds_to_target;
    if (std::ranges::any_of(q.values, [](const LadderValue& v) { return v.levels.empty(); })) {
        if (q.values.size() == 1 && !q.values[0].absent.empty()) s.why = "at " + q.values[0].absent.front();
        return s;
    }
    s.statistics = s.discretisation = s.choices = 0;
    for (std::size_t k = 0; k < q.values.size(); ++k) {
        const LadderValue& v = q.values[k];
        s.methods.push_back(ladder.sides[k].method);
        s.values.push_back(v.levels.front().value);
        s.statistics = std::hypot(s.statistics, v.statistical);
        s.discretisation = std::hypot(s.discretisation, v.estimate.uncertainty);
        s.choices = std::hypot(s.choices, v.choices);
    }
    s.interval = q.interval;
    if (q.values.size() == 1) {
        s.interval = q.values[0].uncertainty;
        s.choices = std::hypot(s.choices, q.values[0].box);
        s.why = q.values[0].estimate.why_not;
    }
    return s;
}

void judge_by_sizes(Comparison& c, const Ladder& ladder) {
    for (const std::string& line : ladder_banners(ladder)) c.banners.push_back(line);
    std::vector<std::optional<std::size_t>> sides;
    for (const RunRecord& record : c.sources) sides.push_back(side_of(ladder, record));
    for (Quantity& q : c.quantities) {
        const auto judged = std::ranges::find(ladder.quantities, q.name, &LadderQuantity::name);
        if (judged == ladder.quantities.end() || q.values.size() != sides.size()) continue;
        bool all = true;
        for (std::size_t s = 0; s < sides.size(); ++s) {
            const bool there = sides[s] && q.values[s].known && reaches_the_finest(ladder, *judged, *sides[s]);
            if (there) fill(q.values[s], judged->values[*sides[s]]), c.discretisation_from = sizes_text(ladder);
            all = all && there;
        }
        if (!all || sides.size() != ladder.sides.size()) continue;
        q.judged = true;
        q.sentence = ladder_sentence(ladder, *judged);
        if (sides.size() != 2) continue;
        q.verdict = judged->verdict, q.remark = judged->reason;
        q.difference = judged->difference, q.interval = judged->interval;
        q.size = judged->size, q.per_cent = judged->per_cent;
    }
}

RelativeErrors relative_errors(const Ladder& ladder, const std::string& scene) {
    RelativeErrors errors{scene};
    for (const LadderQuantity& q : ladder.quantities)
        for (std::size_t k = 0; k < q.values.size(); ++k) {
            const LadderValue& v = q.values[k];
            if (v.levels.empty() || !(q.size > 0)) continue;
            errors.of[{q.name, ladder.sides[k].method}] = {v.estimate.uncertainty / q.size, v.choices / q.size,
                                                           v.box / q.size, v.estimate.why_not};
        }
    return errors;
}

void judge_by_errors_of(Comparison& c, const RelativeErrors& errors) {
    if (c.sources.size() != 2 || errors.scene.empty()) return;
    c.discretisation_from = "the twins of " + errors.scene + ", relative to the values";
    for (Quantity& q : c.quantities) {
        if (q.verdict != Verdict::not_estimated || !(q.size > 0)) continue;
        Statement s{.label = q.label, .unit = q.unit};
        s.size = q.size, s.target = c.agree_within, s.borrowed = errors.scene;
        s.interval = s.statistics = s.discretisation = s.choices = 0;
        std::vector<MeanValue> values = q.values;
        for (std::size_t k = 0; k < 2; ++k) {
            const std::string method = text_of(c.sources[k], "method");
            const auto share = errors.of.find({q.name, method});
            if (share == errors.of.end()) break;
            MeanValue& m = values[k];
            const double choices = share->second.choices * q.size, box = share->second.box * q.size;
            m.discretisation = share->second.discretisation * q.size;
            m.choices = std::hypot(choices, box);
            m.uncertainty = std::hypot(std::hypot(m.half_width, m.discretisation), m.choices);
            if (!std::isfinite(m.uncertainty)) m.no_uncertainty = share->second.why_not;
            if (s.why.empty() && !std::isfinite(m.uncertainty)) s.why = method + ": " + share->second.why_not;
            s.methods.push_back(method);
            s.values.push_back(m.value);
            s.statistics = std::hypot(s.statistics, m.half_width);
            s.discretisation = std::hypot(s.discretisation, m.discretisation);
            s.choices = std::hypot(s.choices, choices);
        }
        if (s.values.size() < 2) continue;
        q.values = std::move(values);
        s.interval = q.interval = std::hypot(std::hypot(s.statistics, s.discretisation), s.choices);
        q.verdict = s.verdict = !std::isfinite(s.interval) ? Verdict::not_converged
                                                           : decide(q.difference, q.interval, c.agree_within, q.size);
        q.remark = "discretisation error taken from " + errors.scene + (s.why.empty() ? "" : "; " + s.why);
        q.sentence = sentence_of(s);
    }
}

}  // namespace tw
