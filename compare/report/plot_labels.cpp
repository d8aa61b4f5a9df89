#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "compare/report/numbers.h"
#include "compare/report/svg_plot.h"

namespace tw {

namespace {

constexpr double line_height = 15, gap = 4;

/// Corners inside the box, then above and below it, then beside it.
std::array<DrawnBox, 10> candidates(const LabelBox& b) {
    const double w = b.label_width, h = line_height;
    const auto at = [&](double left, double top) { return DrawnBox{left, top, left + w, top + h}; };
    const double near = b.left + gap, far = b.right - gap - w, high = b.top + gap / 2, low = b.bottom - gap / 2 - h;
    return {at(near, high),
            at(far, high),
            at(far, low),
            at(near, low),
            at(b.left, b.top - h),
            at(b.right - w, b.top - h),
            at(b.left, b.bottom),
            at(b.right - w, b.bottom),
            at(b.left - gap - w, high),
            at(b.right + gap, high)};
}

bool crosses_edges(const DrawnBox& label, const DrawnBox& box) { return label.overlaps(box) && !box.holds(label); }

double area(const DrawnBox& b) { return (b.right - b.left) * (b.bottom - b.top); }

}  // namespace

std::vector<std::optional<DrawnBox>> label_places(const std::vector<LabelBox>& boxes, const DrawnBox& frame) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return area(boxes[i]); });
    std::vector<std::optional<DrawnBox>> places(boxes.size());
    for (const std::size_t i : order) {
        std::ptrdiff_t fewest = std::ptrdiff_t(boxes.size()) + 1;
        for (const DrawnBox& c : candidates(boxes[i])) {
            const bool taken = std::ranges::any_of(places, [&](const auto& p) { return p && p->overlaps(c); });
            if (taken || !frame.holds(c)) continue;
            const auto crossed = std::ranges::count_if(boxes, [&](const LabelBox& b) { return crosses_edges(c, b); });
            if (crossed < fewest) fewest = crossed, places[i] = c;
        }
    }
    return places;
}

std::vector<double> ticks(double low, double high, int about) {
    std::vector<double> list;
    const double size = std::max(std::abs(low), std::abs(high));
    // Between numbers that differ by rounding only there are no round ones.
    if (about < 1 || !(high - low > 1e-12 * size) || !std::isfinite(high - low) || size < 1e-300) return list;
    const double raw = (high - low) / about, power = std::pow(10, std::floor(std::log10(raw)));
    const double step = power * (raw / power < 1.5 ? 1 : raw / power < 3.5 ? 2 : raw / power < 7.5 ? 5 : 10);
    for (double k = std::ceil(low / step - 1e-9); k <= high / step + 1e-9; ++k) list.push_back(k * step);
    return list;
}

std::string tick_text(double v, double step) {
    if (std::abs(v) < 1e-9 * step) v = 0;
    const int places = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 6);
    if (std::abs(v) >= 1e6) return number_text(v, 4);
    return (v < 0 ? "−" : "") + fmt::format("{:.{}f}", std::abs(v), places);
}

std::vector<double> log_ticks(double low, double high) {
    if (!(low > 0) || !std::isfinite(high)) return {};
    const double decades = std::log10(high) - std::log10(low), step = std::max(1.0, std::ceil(decades / 20));
    const std::vector<double> within = decades < 4 ? std::vector<double>{1, 2, 5} : std::vector<double>{1};
    std::vector<double> list;
    for (double power = std::floor(std::log10(low)); power <= std::log10(high); power += step)
        for (const double digit : within)
            if (const double v = digit * std::pow(10, power); v >= low * (1 - 1e-9) && v <= high * (1 + 1e-9))
                list.push_back(v);
    return list;
}

}  // namespace tw
