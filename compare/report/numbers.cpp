#include "compare/report/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
    if (size != 0 && (size >= 1e7 || size < 1e-4)) return fmt::format("{}{:.3g}", sign, std::abs(value));
    if (std::abs(value) < 0.5 * std::pow(10.0, -places)) return fmt::format("{:.{}f}", 0.0, places);  // no "-0.00"
    return fmt::format("{}{:.{}f}", sign, std::abs(value), places);
}
}  // namespace

std::string value_text(double value, double half_width) {
    if (!std::isfinite(value)) return "–";
    if (half_width < 1e-6 * std::abs(value)) half_width = 0;
    const int places = decimals(value, half_width);
    if (!(half_width > 0) || !std::isfinite(half_width)) return digits(value, places, std::abs(value));
    const double size = std::max(std::abs(value), half_width);
    return fmt::format("{} ± {}", digits(value, places, size), digits(half_width, places, size));
}

std::string mean_text(const MeanValue& mean) { return mean.known ? value_text(mean.value, mean.half_width) : "–"; }

std::string signed_text(double value, double half_width) {
    if (!std::isfinite(value)) return "–";
    return fmt::format("{}{}", value > 0 ? "+" : "", value_text(value, half_width));
}

std::string per_cent_text(double per_cent) {
    if (!std::isfinite(per_cent)) return "–";
    const char* sign = std::abs(per_cent) < 0.05 ? "" : per_cent < 0 ? "−" : "+";
    return fmt::format("{}{:.{}f} %", sign, std::abs(per_cent), std::abs(per_cent) < 10 ? 1 : 0);
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
}  // namespace

std::string verdict_sentence(const Comparison& comparison) {
    if (comparison.sources.size() < 2) return "One run only: there is nothing to compare it with.";
    const bool pair = comparison.sources.size() == 2;
    std::string text;
    for (const char* name : {"lift", "drag", "splash_sheet_height"}) {
        const Quantity* q = comparison.find(name);
        if (!q) continue;
        const std::string label = std::string_view(name) == "splash_sheet_height" ? "Splash height" : q->label;
        if (!text.empty()) text += " ";
        if (q->verdict == Verdict::not_estimated && std::isfinite(q->per_cent)) {
            text += fmt::format("{}: apart by {:.1f} % at this size", label, std::abs(q->per_cent));
            if (pair && q->difference != 0)
                text += fmt::format(" ({} {})", comparison.names[1], q->difference < 0 ? "lower" : "higher");
            if (q->difference != 0 && q->interval > 0)
                text +=
                    fmt::format(", ± {:.1f} % {}", std::abs(q->per_cent * q->interval / q->difference), limit_of(*q));
            text += "; discretisation error not estimated.";
        } else {
            text += label + ": " + verdict_label(q->verdict) + (q->remark.empty() ? "" : " (" + q->remark + ")") + ".";
        }
    }
    if (text.empty()) text = "No force and no splash to compare; see the tables.";
    return text;
}

}  // namespace tw
