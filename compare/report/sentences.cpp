#include "compare/report/sentences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "compare/report/numbers.h"
#include "compare/verdict/judge.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "text/plain_number.h"

namespace tw {

namespace {

bool in_per_cent(const Statement& s) {
    if (s.values.size() != 2) return s.size > 0 && s.values.size() == 1 && s.values[0] != 0;
    return told_in_per_cent(s.values[0], s.values[1], s.size);
}

/// "−9.94 N m": to the digits of the interval, where these leave any.
std::string single_text(double value, const Statement& s) {
    if (value == 0) return "0";
    const std::string with = value_text(value, s.interval), digits = with.substr(0, with.find(" ±"));
    return (digits == "0" ? number_text(value, 2) : digits) + " " + unit_text(s.unit);
}

/// "SPH 3.1 % above interFoam", in magnitude where both are negative.
std::string apart_text(const Statement& s) {
    const std::string a = method_label(s.methods[0]), b = method_label(s.methods[1]);
    if (!(s.size > 0) || (s.values[0] == 0 && s.values[1] == 0)) return fmt::format("{} and {} are both 0", a, b);
    if (!in_per_cent(s)) {
        const int larger = std::abs(s.values[0]) > std::abs(s.values[1]) ? 0 : 1, smaller = 1 - larger;
        return fmt::format("{} {}, {} {}", larger == 0 ? a : b, single_text(s.values[larger], s), smaller == 0 ? a : b,
                           single_text(s.values[smaller], s));
    }
    const double per_cent = 100 * std::abs(s.values[1] - s.values[0]) / s.size;
    if (per_cent < least_per_cent) return fmt::format("{} and {} are the same to {}", a, b, share_text(least_per_cent));
    const bool negative = s.values[0] < 0 || s.values[1] < 0;
    const char* where = std::abs(s.values[0]) > std::abs(s.values[1]) ? "above" : "below";
    return fmt::format("{} {} {} {}{}", a, share_text(per_cent), where, b, negative ? " in magnitude" : "");
}

/// In per cent of the values, or in their unit where per cent say nothing.
std::string size_text(double size, const Statement& s) {
    return in_per_cent(s) ? share_text(100 * size / s.size)
                          : fmt::format("{} {}", plain_number(size, 2), unit_text(s.unit));
}
std::string plus_minus(double U, const Statement& s) { return "±" + size_text(U, s); }
std::string target_text(const Statement& s) { return size_text(s.target * s.size, s); }

/// Significant, yet it may be of no matter.
std::string within_target(const Statement& s) {
    const bool within = std::abs(s.values[1] - s.values[0]) <= s.target * s.size;
    return within ? ", perhaps by less than " + target_text(s) : "";
}

/// "discretisation error ±9 %" where one part is all that matters, else "uncertainty ±9 % (discretisation error ±7 %, ...)".
std::string interval_text(const Statement& s) {
    const std::string whose = s.borrowed.empty() ? "" : fmt::format(" as in {}", s.borrowed);
    std::string parts;
    for (const auto& [name, U] : {std::pair{"discretisation error" + whose, s.discretisation},
                                  std::pair{std::string("scatter of the mean"), s.statistics},
                                  std::pair{std::string("other choices"), s.choices}}) {
        if (U >= 0.9 * s.interval) return fmt::format("{} {}", name, plus_minus(s.interval, s));
        if (U > 0.3 * s.interval) parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", name, plus_minus(U, s));
    }
    return fmt::format("uncertainty {}{}", plus_minus(s.interval, s), parts.empty() ? "" : " (" + parts + ")");
}

std::string one_method(const Statement& s) {
    if (!std::isfinite(s.interval))
        return fmt::format("{} {} by {}, without an interval: {}", value_text(s.values[0], 0), unit_text(s.unit),
                           method_label(s.methods[0]), s.why);
    if (s.size > 0 && s.interval > widest_answer * s.size)
        return fmt::format("no answer yet: {} {} by {}, {}", value_text(s.values[0], s.interval), unit_text(s.unit),
                           method_label(s.methods[0]), interval_text(s));
    return fmt::format("{} {} by {}, {}", value_text(s.values[0], s.interval), unit_text(s.unit),
                       method_label(s.methods[0]), interval_text(s));
}

/// Nobody is told of runs that nobody waits for.
std::string remedy(const Statement& s) {
    if (!(s.seconds_to_target <= s.longest)) return {};
    return fmt::format("; {} of further runs would bring it to ±{}", time_text(s.seconds_to_target), target_text(s));
}

/// How far two values are apart, and how well that is known; `verdict`: with it, in words.
std::string two_methods(const Statement& s, bool verdict) {
    const auto said = [&](const std::string& words) { return verdict ? ": " + words : std::string(); };
    switch (s.verdict) {
        case Verdict::agree:
            return fmt::format("{}, {}{}", apart_text(s), interval_text(s),
                               said("they agree within " + target_text(s)));
        case Verdict::differ:
            return fmt::format("{}, {}{}{}", apart_text(s), interval_text(s), said("they differ"), within_target(s));
        case Verdict::undecided:
            return fmt::format("{}, {}{}{}", apart_text(s), interval_text(s), said("no difference shown"), remedy(s));
        case Verdict::no_answer:
            return fmt::format("{}, {}{}{}", apart_text(s), interval_text(s), said("no answer yet"), remedy(s));
        case Verdict::not_converged:
            return std::isfinite(s.interval) ? fmt::format("{}, {} as a bound{}{}", apart_text(s), interval_text(s),
                                                           said("not converged, "), verdict ? s.why : "; " + s.why)
                                             : fmt::format("{}, without an interval{}{}", apart_text(s),
                                                           said("not converged, "), verdict ? s.why : "; " + s.why);
        case Verdict::not_comparable:
        case Verdict::not_estimated: break;
    }
    if (!verdict) return s.why;
    return verdict_label(s.verdict) + (s.why.empty() ? "" : ": " + s.why);
}

}  // namespace

std::string sentence_of(const Statement& s) {
    if (s.values.size() == 2 && s.methods.size() == 2) return s.label + ": " + two_methods(s, true) + ".";
    if (s.values.size() == 1 && s.methods.size() == 1) return s.label + ": " + one_method(s) + ".";
    return s.label + ": " + verdict_label(s.verdict) + (s.why.empty() ? "" : ": " + s.why) + ".";
}

std::string finding_of(const Statement& s) {
    if (s.values.size() != 2 || s.methods.size() != 2) return {};
    const std::string text = two_methods(s, false);
    return text.empty() ? text : text + ".";
}

namespace {
/// What the interval of a difference is made of: the scatter, or what is wider, such as the raster.
std::string limit_of(const Quantity& q) {
    const MeanValue* widest = nullptr;
    for (const MeanValue& m : q.values)
        if (m.known && (!widest || m.half_width > widest->half_width)) widest = &m;
    return widest && !widest->limited_by.empty() ? "from " + widest->limited_by : "statistical scatter of the means";
}

/// "Lift: apart by 2.8 % at this size (interFoam lower), ± 0.2 % ...; discretisation error not estimated."
std::string apart_sentence(const Comparison& comparison, const Quantity& q) {
    if (!q.not_resolved.empty()) return q.label + ": " + q.not_resolved + ".";
    const bool without_verdict = q.verdict == Verdict::not_estimated || q.judged_in_grid_study;
    if (!without_verdict || !std::isfinite(q.per_cent))
        return q.label + ": " + verdict_label(q.verdict) + (q.remark.empty() ? "" : " (" + q.remark + ")") + ".";
    const std::string a = method_label(comparison.names[q.a]), b = method_label(comparison.names[q.b]);
    const double value_a = q.values[q.a].value, value_b = q.values[q.b].value;
    const bool in_per_cent = told_in_per_cent(value_a, value_b, q.size);
    const auto size_text = [&](double size) {
        return in_per_cent ? fmt::format("{:.1f} %", 100 * std::abs(size) / q.size)
                           : fmt::format("{} {}", plain_number(std::abs(size), 2), unit_text(q.unit));
    };
    std::string text = fmt::format("{}: apart by {} at this size", q.label, size_text(q.difference));
    if (comparison.sources.size() > 2)
        text =
            fmt::format("{}: {} and {} are farthest apart, by {} at this size", q.label, a, b, size_text(q.difference));
    if (!in_per_cent)
        text +=
            fmt::format(" ({} {}, {} {} {})", a, value_text(value_a, 0), b, value_text(value_b, 0), unit_text(q.unit));
    else if (q.difference != 0)
        text += fmt::format(" ({} {})", b, q.difference < 0 ? "lower" : "higher");
    if (q.interval > 0 && q.size > 0) text += fmt::format(", ± {} {}", size_text(q.interval), limit_of(q));
    return text + "; discretisation error not estimated.";
}
}  // namespace

std::vector<std::string> failures_of(const Comparison& comparison) {
    std::vector<std::string> sentences;
    for (std::size_t s = 0; s < comparison.sources.size(); ++s) {
        if (!comparison.failed(s)) continue;
        const std::string& reason = comparison.sources[s].reason;
        sentences.push_back(fmt::format("{} failed{}{}. What it recorded until then {}.",
                                        method_label(comparison.names[s]), reason.empty() ? "" : ": ", reason,
                                        comparison.sources.size() > 1 ? "is compared with nothing" : "is shown below"));
    }
    return sentences;
}

std::vector<std::string> sentences_on(const Comparison& comparison, const Quantity& q) {
    std::vector<std::string> sentences;
    std::size_t left = 0;
    for (std::size_t s = 0; s < comparison.sources.size(); ++s) left += comparison.failed(s) ? 0 : 1;
    if (left < 2 && left < comparison.sources.size()) return sentences;
    for (const Difference& d : q.differences())
        if (!d.sentence.empty()) sentences.push_back(d.sentence);
    if (sentences.empty() && (comparison.sources.size() > 1 || !q.not_resolved.empty()))
        sentences.push_back(apart_sentence(comparison, q));
    if (!q.caveat.empty())
        for (std::string& sentence : sentences) sentence += " (" + q.caveat + ")";
    return sentences;
}

std::vector<std::string> verdict_sentences(const Comparison& comparison) {
    std::vector<std::string> sentences = failures_of(comparison);
    for (const Quantity* q : main_quantities(comparison.quantities))
        std::ranges::move(sentences_on(comparison, *q), std::back_inserter(sentences));
    if (sentences.empty())
        sentences.push_back(comparison.sources.size() < 2 ? "One run only: there is nothing to compare it with."
                                                          : "No force and no splash to compare; see the tables.");
    return sentences;
}

}  // namespace tw
