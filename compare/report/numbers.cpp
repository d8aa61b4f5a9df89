#include "compare/report/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
    if (size != 0 && (size >= 1e7 || size < 1e-4)) return number_text(value);
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

std::string number_text(double value, int digits) {
    if (std::isnan(value)) return "–";
    const std::string text = plain_number(value, digits);
    return text.starts_with('-') ? "−" + text.substr(1) : text;
}

std::string label_text(const std::string& label) {
    const auto open = label.rfind('['), close = label.rfind(']');
    if (open == label.npos || close == label.npos || close < open) return label;
    return label.substr(0, open) + unit_text(label.substr(open, close - open)) + label.substr(close);
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
    return size > 0 && !is_mean(size, a, b) ? fmt::format(" of {} {}", plain_number(size, 2), unit_text(unit))
                                            : std::string();
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

}  // namespace tw
