#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/report/escape.h"
#include "compare/report/first_screen.h"
#include "compare/report/svg_plot.h"

namespace tw {

namespace {

constexpr double row_height = 19;

/// Where names end, the axis runs and values begin [px of the drawing]; references are named where there is room.
struct Layout {
    const char* css;
    double width, axis_left, axis_right;
    bool names;
};
constexpr Layout wide{"strip", 630, 82, 450, true}, narrow{"strip narrow", 376, 70, 240, false};

/// What the axis shows: values and references with their intervals.
struct StripAxis {
    double low = HUGE_VAL, high = -HUGE_VAL;
    Layout layout;

    StripAxis(const Strip& strip, const Layout& l) : layout(l) {
        for (const auto& v : strip.values)
            add(v.value, std::isfinite(v.outer) ? std::max(v.outer, v.below()) : v.half_width);
        for (const auto& r : strip.references) add(r.value, r.half_width);
        const double room = high > low ? 0.06 * (high - low) : std::max(0.1 * std::abs(low), 1e-3);
        low -= room;
        high += room;
    }
    void add(double value, double half_width) {
        if (!std::isfinite(value)) return;
        if (!std::isfinite(half_width)) half_width = 0;
        low = std::min(low, value - half_width);
        high = std::max(high, value + half_width);
    }
    bool empty() const { return !(low <= high); }
    double operator()(double value) const {
        const double place = layout.axis_left + (layout.axis_right - layout.axis_left) * (value - low) / (high - low);
        return std::clamp(place, layout.axis_left, layout.axis_right);
    }
};

std::string drawn(const Strip::Value& v, const StripAxis& X, double y) {
    const auto [axis_left, axis_right] = std::pair(X.layout.axis_left, X.layout.axis_right);
    std::string out =
        fmt::format("<text class=\"end\" x=\"{:.0f}\" y=\"{:.1f}\">{}</text>", axis_left - 8, y + 4, escaped(v.name));
    if (!std::isfinite(v.value))
        return out + fmt::format("<text class=\"tick\" x=\"{:.0f}\" y=\"{:.1f}\">{}</text>", axis_right + 10, y + 4,
                                 escaped(v.text));
    if (std::isfinite(v.outer))
        out += fmt::format("<line class=\"outer s{}\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>",
                           v.source, X(v.value - v.below()), X(v.value + v.outer), y, y);
    const bool interval = std::isfinite(v.half_width) && v.half_width > 0;
    if (interval) {
        const double from = X(v.value - v.half_width), to = X(v.value + v.half_width);
        out += fmt::format("<line class=\"bar s{}\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>",
                           v.source, from, to, y, y);
        for (const double end : {from, to})
            if (end > axis_left && end < axis_right)
                out += fmt::format(
                    "<line class=\"mean s{0}\" x1=\"{1:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{3:.1f}\"/>", v.source,
                    end, y - 4, y + 4);
    }
    out += fmt::format("<circle class=\"s{0} {1}\" stroke-width=\"2\" cx=\"{2:.1f}\" cy=\"{3:.1f}\" r=\"4.5\"/>",
                       v.source, std::isfinite(v.half_width) ? fmt::format("f{}", v.source) : "hollow", X(v.value), y);
    return out + fmt::format("<text class=\"value\" x=\"{:.0f}\" y=\"{:.1f}\">{}</text>", axis_right + 10, y + 4,
                             escaped(v.text));
}

/// A tick over all rows with its interval as a band; its name above, moved to the right of the one before.
std::string drawn(const Strip::Reference& r, const StripAxis& X, double top, double bottom, double& name_from) {
    const double from = X(r.value - r.half_width), to = X(r.value + r.half_width), x = X(r.value);
    const double width = 6.2 * static_cast<double>(r.name.size()), first = X.layout.axis_left,
                 last = std::max(first, X.layout.axis_right - width);
    const double left = std::max(name_from, std::clamp(x - width / 2, first, last));
    name_from = left + width + 10;
    return fmt::format("<rect class=\"reference-band\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                       from, top, to - from, bottom - top) +
           fmt::format("<line class=\"reference\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>", x,
                       top - 2, bottom) +
           (X.layout.names ? fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", left, top - 5,
                                         escaped(r.name))
                           : std::string());
}

/// The difference on an axis of its own, about zero, with what counts as agreement as a band.
std::string drawn(const Strip::Difference& d, const Layout& layout, double y) {
    const auto [axis_left, axis_right] = std::pair(layout.axis_left, layout.axis_right);
    const double reach = 1.08 * std::max(std::abs(d.value) + d.half_width, 1.2 * d.target);
    const auto X = [&](double v) { return axis_left + (axis_right - axis_left) * (0.5 + 0.5 * v / reach); };
    const double from = X(d.value - d.half_width), to = X(d.value + d.half_width);
    std::string out =
        fmt::format("<text class=\"end\" x=\"{:.0f}\" y=\"{:.1f}\">difference</text>", axis_left - 8, y + 4);
    out += fmt::format("<rect class=\"reference-band\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"14\"/>",
                       X(-d.target), y - 7, X(d.target) - X(-d.target));
    out += fmt::format("<line class=\"level\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>", X(0),
                       y - 9, y + 9);
    out += fmt::format("<line class=\"bar apart\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>", from, to,
                       y, y);
    for (const double end : {from, to})
        out += fmt::format("<line class=\"mean apart\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>",
                           end, y - 4, y + 4);
    out += fmt::format("<circle class=\"apart dot\" stroke-width=\"2\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"/>",
                       X(d.value), y);
    return out + fmt::format("<text class=\"value\" x=\"{:.0f}\" y=\"{:.1f}\">{}</text>", axis_right + 10, y + 4,
                             escaped(d.text));
}

std::string drawn(const Strip& strip, const Layout& layout) {
    const StripAxis X(strip, layout);
    const double top = strip.references.empty() || !layout.names ? 4 : 16;
    const double bottom = top + row_height * static_cast<double>(strip.values.size());
    std::string label = strip.title, content;
    const std::vector<double> places = ticks(X.low, X.high, layout.names ? 4 : 3);
    const double step = places.size() > 1 ? places[1] - places[0] : 1;
    for (const double v : places) {
        content += fmt::format("<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>",
                               X(v), top, bottom);
        content += fmt::format("<text class=\"tick mid\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", X(v), bottom + 13,
                               tick_text(v, step));
    }
    content += fmt::format("<line class=\"frame\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>", layout.axis_left,
                           layout.axis_right, bottom, bottom);
    double name_from = layout.axis_left, y = top + row_height / 2;
    for (const auto& r : strip.references) {
        content += drawn(r, X, top, bottom, name_from);
        label += fmt::format("; {} {}", r.name, tick_text(r.value, step / 10));
    }
    for (const auto& v : strip.values) {
        content += drawn(v, X, y);
        label += fmt::format("; {} {}", v.name, v.text);
        y += row_height;
    }
    double height = bottom + 17;
    if (strip.difference) {
        content += drawn(*strip.difference, layout, height + 9);
        label += "; difference " + strip.difference->text;
        height += 20;
    }
    return fmt::format(
        "<svg class=\"{}\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\" "
        "xmlns=\"http://www.w3.org/2000/svg\">{}</svg>",
        layout.css, layout.width, height, escaped(label), content);
}

}  // namespace

std::string svg(const Strip& strip) {
    if (std::ranges::none_of(strip.values, [](const auto& v) { return std::isfinite(v.value); })) return {};
    return drawn(strip, wide) + drawn(strip, narrow);
}

}  // namespace tw
