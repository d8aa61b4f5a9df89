#include "compare/report/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/verdict/sentence.h"
#include "methods/methods.h"
#include "text/plain_number.h"

namespace tw {

namespace {
/// Decimals so that the half width shows two significant digits, at most six.
int decimals(double value, double half_width) {
    const double scale = half_width > 0 && std::isfinite(half_width) ? half_width / 10 : std::abs(value) / 1000;
    if (!(scale > 0)) return 0;
    return std::clamp(static_cast<int>(-std::floor(std::log10(scale))), 0, 6);
}

/// Plain digits where they are readable, powers of ten elsewhere; `size` decides for a value and its interval alike.
std::string digits(double value, int places, double size) {
    const std::string sign = value < 0 ? "−" : "";
    if (size != 0 && (size >= 1e7 || size < 1e-4)) return sign + plain_number(std::abs(value));
    if (std::abs(value) < 0.5 * std::pow(10.0, -places)) return "0";  // and no "-0.00"
    return fmt::format("{}{:.{}f}", sign, std::abs(value), places);
}
}  // namespace

std::string value_text(double value, double half_width) {
    if (!std::isfinite(value)) return "–";
    if (half_width < 5e-5 * std::abs(value)) half_width = 0;  // below the digits that are shown
    const int places = decimals(value, half_width);
    if (!(half_width > 0) || !std::isfinite(half_width)) return digits(value, places, std::abs(value));
    const double size = std::max(std::abs(value), half_width);
    return fmt::format("{} ± {}", digits(value, places, size), digits(half_width, places, size));
}

std::string mean_text(const MeanValue& mean) {
    if (!mean.known) return "–";
    return value_text(mean.value, mean.bar()) + (std::isfinite(mean.bar()) ? "" : ", no interval");
}

std::string signed_text(double value, double half_width) {
    if (!std::isfinite(value)) return "–";
    const std::string text = value_text(value, half_width);
    return (value > 0 && text != "0" && !text.starts_with("0 ") ? "+" : "") + text;
}

std::string per_cent_text(double per_cent) {
    if (!std::isfinite(per_cent)) return "–";
    const char* sign = std::abs(per_cent) < 0.05 ? "" : per_cent < 0 ? "−" : "+";
    return fmt::format("{}{:.{}f} %", sign, std::abs(per_cent), std::abs(per_cent) < 10 ? 1 : 0);
}

std::string per_cent_text(double per_cent, double interval) {
    if (!std::isfinite(per_cent)) return "–";
    if (!std::isfinite(interval) || interval == 0) return per_cent_text(per_cent) + ", no interval";
    const int places = std::max(std::abs(per_cent), interval) < 10 ? 1 : 0;
    const double least = 0.5 * std::pow(10.0, -places);
    const char* sign = std::abs(per_cent) < least ? "" : per_cent < 0 ? "−" : "+";
    return fmt::format("{}{:.{}f} ± {} %", sign, std::abs(per_cent), places,
                       interval < least ? plain_number(std::max(interval, least_per_cent), 1)
                                        : fmt::format("{:.{}f}", interval, places));
}

namespace {
bool is_mean(double size, double a, double b) { return size <= 0.5 * std::abs(a + b) * (1 + 1e-9); }
}  // namespace

bool told_in_per_cent(double a, double b, double size) {
    return size > 0 && std::abs(b - a) <= size && is_mean(size, a, b);
}

std::string difference_text(double per_cent, double interval, const std::string& of) {
    if (std::abs(per_cent) > 100) return "too far apart for per cent";
    return per_cent_text(per_cent, interval) + (std::isfinite(per_cent) ? of : "");
}

std::string of_scale(double size, double a, double b, const std::string& unit) {
    return size > 0 && !is_mean(size, a, b) ? fmt::format(" of {} {}", plain_number(size, 2), unit) : std::string();
}

std::string share_text(double per_cent) {
    const double size = std::abs(per_cent);
    if (size >= 9.95) return fmt::format("{:.0f} %", size);
    if (size >= 0.0995 || size == 0) return fmt::format("{:.1f} %", size);
    return fmt::format("{:.2f} %", std::max(size, least_per_cent));
}

std::string factor_text(double factor) {
    if (!std::isfinite(factor)) return std::isnan(factor) ? "–" : "more than × 1000";
    if (factor > 1000) return "more than × 1000";
    return factor < 1e-3 ? "less than × 0.001" : "× " + plain_number(factor, 3);
}

std::string time_text(double seconds) {
    if (!std::isfinite(seconds)) return "–";
    if (seconds < least_time) return "under 0.01 s";
    if (seconds < 99.5) return plain_number(seconds, 2) + " s";
    if (seconds < 120) return fmt::format("{:.0f} s", seconds);
    if (seconds < 7200) return plain_number(seconds / 60, 2) + " min";
    if (seconds < 172800) return plain_number(seconds / 3600, 2) + " h";
    if (seconds < most_time) return plain_number(seconds / 86400, 2) + " days";
    return "more than a year";
}

std::string about_text(double seconds) {
    const bool bound = !std::isfinite(seconds) || seconds < least_time || seconds >= most_time;
    return (bound ? "" : "about ") + time_text(seconds);
}

std::string verdict_label(Verdict verdict) {
    std::string label = to_string(verdict);
    std::ranges::replace(label, '_', ' ');
    return label;
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
    const bool without_verdict = q.verdict == Verdict::not_estimated || q.judged_in_ladder;
    if (!without_verdict || !std::isfinite(q.per_cent))
        return q.label + ": " + verdict_label(q.verdict) + (q.remark.empty() ? "" : " (" + q.remark + ")") + ".";
    const std::string a = method_label(comparison.names[q.a]), b = method_label(comparison.names[q.b]);
    const double value_a = q.values[q.a].value, value_b = q.values[q.b].value;
    const bool in_per_cent = told_in_per_cent(value_a, value_b, q.size);
    const auto size_text = [&](double size) {
        return in_per_cent ? fmt::format("{:.1f} %", 100 * std::abs(size) / q.size)
                           : fmt::format("{} {}", plain_number(std::abs(size), 2), q.unit);
    };
    std::string text = fmt::format("{}: apart by {} at this size", q.label, size_text(q.difference));
    if (comparison.sources.size() > 2)
        text =
            fmt::format("{}: {} and {} are farthest apart, by {} at this size", q.label, a, b, size_text(q.difference));
    if (!in_per_cent)
        text += fmt::format(" ({} {}, {} {} {})", a, value_text(value_a, 0), b, value_text(value_b, 0), q.unit);
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
