#include "compare/report/label_places.h"

#include <algorithm>
#include <array>
#include <numeric>

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

}  // namespace tw
