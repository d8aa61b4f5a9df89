#include "compare/grid_study/judge_by_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/grid_study/box_influence.h"
#include "compare/grid_study/grid_study_report.h"
#include "compare/report/escape.h"
#include "compare/report/sentences.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

bool same_spacing(double a, double b) { return std::abs(a / b - 1) < 1e-6; }

/// The side of the grid study whose finest run of several the record is.
std::optional<std::size_t> side_of(const GridStudy& grid_study, const RunRecord& record) {
    for (std::size_t k = 0; k < grid_study.sides.size(); ++k)
        if (grid_study.sides[k].method == text_of(record, "method") && grid_study.sides[k].runs.size() > 1 &&
            record.state == "finished" &&
            same_spacing(grid_study.sides[k].runs.front().spacing, number_of(record, "near_hull", 0)))
            return k;
    return {};
}

/// Whether the quantity of this side has a mean at its finest size.
bool reaches_the_finest(const GridStudy& grid_study, const GridStudyQuantity& q, std::size_t side) {
    const GridStudyValue& v = q.values[side];
    return !v.levels.empty() && same_spacing(v.levels.front().h, grid_study.sides[side].runs.front().spacing);
}

void fill(MeanValue& m, const GridStudyValue& v) {
    m.discretisation = v.estimate.uncertainty;
    m.choices = std::hypot(v.choices, v.box, v.input);
    m.uncertainty = v.uncertainty;
    if (!std::isfinite(v.uncertainty))
        m.no_uncertainty = v.estimate.why_not.empty() ? "not converged" : v.estimate.why_not;
}

std::string sizes_text(const GridStudy& grid_study) {
    std::string counts;
    for (const GridStudySide& side : grid_study.sides)
        if (const std::string n = fmt::format("{}", side.runs.size()); counts != n)
            counts += (counts.empty() ? "" : " and ") + n;
    return "runs of " + counts + " sizes";
}

/// Wall time of all runs [s].
double seconds_of(const GridStudy& grid_study) {
    double sum = 0;
    for (const GridStudySide& side : grid_study.sides) {
        for (const GridStudyRun& run : side.runs) sum += run.seconds;
        for (const GridStudyVariation& v : side.variations) sum += v.run.seconds;
    }
    return sum;
}

}  // namespace

Statement statement_of(const GridStudy& grid_study, const GridStudyQuantity& q, const GridStudyDifference& d) {
    Statement s{.label = q.label, .unit = q.unit};
    s.size = d.size, s.target = grid_study.agree_within;
    s.verdict = d.verdict, s.why = d.reason;
    s.seconds_to_target = d.seconds_to_target;
    s.longest = longest_offer(seconds_of(grid_study));
    const bool alone = q.values.size() == 1;
    const std::vector<std::size_t> sides = alone ? std::vector<std::size_t>{0} : std::vector{d.a, d.b};
    if (std::ranges::any_of(sides, [&](std::size_t k) { return q.values[k].levels.empty(); })) {
        if (alone && !q.values[0].absent.empty()) s.why = "at " + q.values[0].absent.front();
        return s;
    }
    s.statistics = s.discretisation = s.choices = 0;
    for (const std::size_t k : sides) {
        const GridStudyValue& v = q.values[k];
        s.methods.push_back(grid_study.sides[k].method);
        s.values.push_back(v.levels.front().value);
        s.statistics = std::hypot(s.statistics, v.statistical);
        s.discretisation = std::hypot(s.discretisation, v.estimate.uncertainty);
        s.choices = std::hypot(s.choices, v.choices);
    }
    s.interval = d.interval;
    if (alone) {
        s.interval = q.values[0].uncertainty;
        s.choices = std::hypot(s.choices, q.values[0].box, q.values[0].input);
        s.why = q.values[0].estimate.why_not;
    }
    return s;
}

namespace {

/// What the grid study says of two of its sides, from side `a` to side `b`.
GridStudyDifference between(const GridStudyQuantity& q, std::size_t a, std::size_t b) {
    const auto all = q.differences();
    GridStudyDifference d = *std::ranges::find_if(
        all, [&](const GridStudyDifference& x) { return x.a == std::min(a, b) && x.b == std::max(a, b); });
    if (a > b) d.difference = -d.difference, d.per_cent = -d.per_cent;
    return d;
}

void take(Difference& d, const GridStudyDifference& judged, const GridStudy& grid_study, const GridStudyQuantity& q) {
    d.verdict = judged.verdict, d.remark = judged.reason;
    d.difference = judged.difference, d.interval = judged.interval;
    d.size = judged.size, d.per_cent = judged.per_cent;
    d.seconds_to_target = judged.seconds_to_target;
    d.sentence = grid_study_sentence(grid_study, q, judged);
    d.finding = for_terminal(finding_of(statement_of(grid_study, q, judged)));
}

}  // namespace

void judge_by_sizes(Comparison& c, const GridStudy& grid_study) {
    for (const std::string& line : grid_study_banners(grid_study)) c.banners.push_back(line);
    c.study_seconds = seconds_of(grid_study);
    add_measured_box(c, grid_study);
    std::vector<std::optional<std::size_t>> sides;
    for (const RunRecord& record : c.sources) sides.push_back(side_of(grid_study, record));
    for (Quantity& q : c.quantities) {
        const auto judged = std::ranges::find(grid_study.quantities, q.name, &GridStudyQuantity::name);
        if (judged == grid_study.quantities.end() || q.values.size() != sides.size()) continue;
        std::vector<bool> there;
        for (std::size_t s = 0; s < sides.size(); ++s) {
            there.push_back(sides[s] && q.values[s].known && reaches_the_finest(grid_study, *judged, *sides[s]));
            if (there[s]) fill(q.values[s], judged->values[*sides[s]]), c.discretisation_from = sizes_text(grid_study);
        }
        if (sides.size() == 1 && grid_study.sides.size() == 1 && there[0]) {
            q.judged = true;
            q.sentence = grid_study_sentence(grid_study, *judged);
        }
        if (sides.size() < 2) continue;
        bool any = false;
        for (Difference& d : q.differences()) {
            if (!there[d.a] || !there[d.b] || *sides[d.a] == *sides[d.b]) continue;
            const GridStudyDifference pair = between(*judged, *sides[d.a], *sides[d.b]);
            take(d, pair, grid_study, *judged);
            any = q.judged = true;
        }
        if (any && !q.pairs.empty()) take_farthest(q);
    }
}

RelativeErrors relative_errors(const GridStudy& grid_study, const std::string& scene) {
    RelativeErrors errors{scene};
    for (const GridStudyQuantity& q : grid_study.quantities)
        for (std::size_t k = 0; k < q.values.size(); ++k) {
            const GridStudyValue& v = q.values[k];
            if (v.levels.empty() || !(q.size > 0)) continue;
            errors.of[{q.name, grid_study.sides[k].method}] = {v.estimate.uncertainty / q.size, v.choices / q.size,
                                                               std::hypot(v.box, v.input) / q.size, v.estimate.why_not};
        }
    return errors;
}

namespace {

void judge_by_errors_of(Difference& d, Quantity& q, const Comparison& c, const RelativeErrors& errors) {
    if (d.verdict != Verdict::not_estimated || !(d.size > 0)) return;
    Statement s{.label = q.label, .unit = q.unit};
    s.size = d.size, s.target = c.agree_within, s.borrowed = errors.scene;
    s.interval = s.statistics = s.discretisation = s.choices = 0;
    std::vector<MeanValue> values = q.values;
    for (const std::size_t k : {d.a, d.b}) {
        const std::string method = text_of(c.sources[k], "method");
        const auto share = errors.of.find({q.name, method});
        if (share == errors.of.end()) return;
        MeanValue& m = values[k];
        const double choices = share->second.choices * d.size, box = share->second.box * d.size;
        m.discretisation = share->second.discretisation * d.size;
        m.choices = std::hypot(choices, box);
        m.uncertainty = std::hypot(std::hypot(m.half_width, m.discretisation), m.choices);
        if (!std::isfinite(m.uncertainty)) m.no_uncertainty = share->second.why_not;
        if (s.why.empty() && !std::isfinite(m.uncertainty)) s.why = method_label(method) + ": " + share->second.why_not;
        s.methods.push_back(method);
        s.values.push_back(m.value);
        s.statistics = std::hypot(s.statistics, m.half_width);
        s.discretisation = std::hypot(s.discretisation, m.discretisation);
        s.choices = std::hypot(s.choices, choices);
    }
    q.values = std::move(values);
    s.interval = d.interval = std::hypot(std::hypot(s.statistics, s.discretisation), s.choices);
    d.verdict = s.verdict =
        !std::isfinite(s.interval) ? Verdict::not_converged : decide(d.difference, d.interval, c.agree_within, d.size);
    d.remark = "discretisation error taken from " + errors.scene + (s.why.empty() ? "" : "; " + s.why);
    d.sentence = sentence_of(s);
    d.finding = finding_of(s);
}

}  // namespace

void judge_by_errors_of(Comparison& c, const RelativeErrors& errors) {
    if (c.sources.size() < 2 || errors.scene.empty()) return;
    c.discretisation_from = "the coarser runs of " + errors.scene + ", relative to the values";
    for (Quantity& q : c.quantities) {
        for (Difference& d : q.differences()) judge_by_errors_of(d, q, c, errors);
        if (!q.pairs.empty() && q.verdict == Verdict::not_estimated) take_farthest(q);
    }
}

}  // namespace tw
