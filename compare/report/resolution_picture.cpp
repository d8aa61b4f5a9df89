#include "compare/report/resolution_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "compare/report/svg_plot.h"
#include "methods/methods.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

using Interval = std::pair<double, double>;

/// Of a triangle on the upright line at x; its corners reach from one side of that line to the other.
Interval covered(const std::array<Vec3, 3>& corners, int up, double x) {
    Interval c{HUGE_VAL, -HUGE_VAL};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &a = corners[k], &b = corners[(k + 1) % 3];
        if ((a.x() - x) * (b.x() - x) > 0) continue;
        const double along = a.x() == b.x() ? 0 : (x - a.x()) / (b.x() - a.x());
        const double v = a[up] + along * (b[up] - a[up]);
        c = {std::min(c.first, v), std::max(c.second, v)};
    }
    return c;
}

constexpr int page_width = 900;  ///< [px]

/// The same box of the same run twice on the picture, as boxes above each other are in a plan view, is one.
bool is_drawn(const std::vector<PlotBox>& boxes, const PlotBox& box) {
    return std::ranges::any_of(boxes, [&](const PlotBox& b) {
        return b.source == box.source && b.label == box.label && b.x_min == box.x_min && b.x_max == box.x_max &&
               b.y_min == box.y_min && b.y_max == box.y_max;
    });
}

/// Cuts boxes that overlap along x into parts side by side: over each stretch from the lowest to the highest of them.
std::vector<PlotBox> side_by_side(const std::vector<PlotBox>& boxes) {
    std::set<double> edges;
    for (const PlotBox& b : boxes) edges.insert({b.x_min, b.x_max});
    std::vector<PlotBox> parts;
    for (auto low = edges.begin(); std::next(low) != edges.end(); ++low) {
        PlotBox part = boxes.front();
        part.parts.clear();
        part.x_min = *low, part.x_max = *std::next(low);
        part.y_min = HUGE_VAL, part.y_max = -HUGE_VAL;
        for (const PlotBox& b : boxes)
            if (b.x_min < part.x_max && b.x_max > part.x_min)
                part.y_min = std::min(part.y_min, b.y_min), part.y_max = std::max(part.y_max, b.y_max);
        if (part.y_min < part.y_max) parts.push_back(part);
    }
    return parts;
}

/// Adds a box, to the last one where it goes on from that one, as the parts of a zone do that follows a hull and the
/// chain of boxes along a spray root.
void add_box(std::vector<PlotBox>& boxes, const PlotBox& box) {
    PlotBox* last = boxes.empty() ? nullptr : &boxes.back();
    const bool goes_on = last && last->source == box.source && last->label == box.label && last->x_min < box.x_min &&
                         box.x_min <= last->x_max && last->x_max <= box.x_max;
    if (!goes_on) {
        if (!is_drawn(boxes, box)) boxes.push_back(box);
        return;
    }
    std::vector<PlotBox> all = last->parts.empty() ? std::vector{*last} : last->parts;
    all.push_back(box);
    last->parts = side_by_side(all);
    last->x_max = box.x_max;
    last->y_min = std::min(last->y_min, box.y_min);
    last->y_max = std::max(last->y_max, box.y_max);
}

bool has_zones(const RunRecord& run) { return !std::isnan(number_of(run, "undamped_x_min", std::nan(""))); }

/// What lies between the forcing zones of a stream, as the outline of a rectangle; `low` and `high` bound it upwards.
PlotLine between_zones(const RunRecord& run, int up, double low, double high) {
    const auto face = [&](const char* name) { return number_of(run, std::string("undamped_") + name, std::nan("")); };
    if (up == 1) low = face("y_min"), high = face("y_max");
    const double from = face("x_min"), to = face("x_max");
    return {.name = {}, .source = 0, .x = {from, to, to, from, from}, .y = {low, low, high, high, low}};
}

/// A box of water: its outline and lines across, as drawings show water.
PlotLine hatched(const Box& water, int up) {
    constexpr int lines = 6;
    const double left = water.min.x(), right = water.max.x(), low = water.min[up], high = water.max[up];
    PlotLine line{.name = {}, .source = 0, .x = {left, right, right, left, left}, .y = {low, low, high, high, low}};
    for (int k = 1; k < lines; ++k) {
        const double y = low + (high - low) * k / lines;
        line.x.insert(line.x.end(), {std::nan(""), left, right});
        line.y.insert(line.y.end(), {std::nan(""), y, y});
    }
    return line;
}

/// `up`: 2 from the side, 1 from above.
Plot view(std::span<const RunRecord> runs, const std::vector<std::string>& names, std::span<const Box> water, int up) {
    Plot plot;
    plot.equal_scales = true;
    plot.width = page_width;
    plot.x_label = "x, to the stern [m]";
    plot.y_label = up == 2 ? "z [m]" : "y [m]";
    const bool stream = text_of(runs.front(), "motion", "") == "stream";
    plot.title = up == 1 ? "Plan view" : stream ? "Side view, stream from the left; dotted: still water" : "Side view";
    if (!runs.front().hull.triangles.empty())
        plot.title += text_of(runs.front(), "hull_source", "").empty() ? "; grey: solids" : "; grey: hull";
    if (!water.empty()) plot.title += "; hatched: water at the start";
    if (has_zones(runs.front())) plot.title += "; outside the rectangle: forcing zones";
    if (up == 1 && number_of_text(runs.front(), "symmetry_factor", 1) > 1)
        plot.title += "; y = 0 is a plane of symmetry";
    if (up == 2 && stream) plot.levels.push_back({"", 0});
    for (std::size_t s = 0; s < runs.size(); ++s) {
        if (runs[s].resolution.empty()) continue;
        plot.lines.push_back({.name = method_label(names[s]), .source = s, .x = {}, .y = {}, .dashed = s % 2 == 1});
        for (const ResolvedBox& r : runs[s].resolution) {
            const PlotBox box{fmt::format("{:.3g} m", r.size),
                              s,
                              s % 2 == 1,
                              r.box.min.x(),
                              r.box.max.x(),
                              r.box.min[up],
                              r.box.max[up]};
            add_box(plot.boxes, box);
        }
    }
    const PlotBox& whole = plot.boxes.front();
    for (const Box& w : water) plot.outlines.push_back(hatched(w, up));
    if (has_zones(runs.front())) plot.outlines.push_back(between_zones(runs.front(), up, whole.y_min, whole.y_max));
    plot.shadow =
        silhouette(runs.front().hull, up, (whole.x_max - whole.x_min) / (2 * page_width), {whole.x_min, whole.x_max});
    return plot;
}

}  // namespace

PlotShadow silhouette(const Surface& surface, int up, double step, const std::array<double, 2>& shown) {
    std::map<long, std::vector<Interval>> lines;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const std::array<Vec3, 3> corners{surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)};
        auto [low, high] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
        low = std::max(low, shown[0]), high = std::min(high, shown[1]);
        if (!(low <= high)) continue;
        for (long k = std::lround(std::ceil(low / step)); double(k) * step <= high; ++k)
            lines[k].push_back(covered(corners, up, double(k) * step));
    }
    PlotShadow shadow;
    shadow.step = step;
    for (auto& [k, intervals] : lines) {
        std::ranges::sort(intervals);
        const std::size_t first = shadow.x.size();
        for (const auto& [low, high] : intervals) {
            if (shadow.x.size() > first && low <= shadow.high.back()) {
                shadow.high.back() = std::max(shadow.high.back(), high);
                continue;
            }
            shadow.x.push_back(double(k) * step);
            shadow.low.push_back(low);
            shadow.high.push_back(high);
        }
    }
    return shadow;
}

std::string resolution_picture(std::span<const RunRecord> runs, const std::vector<std::string>& names) {
    if (std::ranges::none_of(runs, [](const RunRecord& r) { return r.resolution.size() > 1 || has_zones(r); }))
        return {};
    return domain_picture(runs, names, {});
}

std::string domain_picture(std::span<const RunRecord> runs, const std::vector<std::string>& names,
                           std::span<const Box> water) {
    std::vector<Plot> plots{view(runs, names, water, 2)};
    if (number_of(runs.front(), "dimensions", 3) > 2) plots.push_back(view(runs, names, water, 1));
    return svg_column(plots);
}

}  // namespace tw
