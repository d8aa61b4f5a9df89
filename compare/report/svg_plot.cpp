#include "compare/report/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/page.h"

namespace tw {

namespace {

struct Range {
    double low = HUGE_VAL, high = -HUGE_VAL;
    void add(double v) {
        constexpr double largest = 1e300;  // differences of what is drawn are finite
        if (!std::isfinite(v)) return;
        low = std::min(low, std::clamp(v, -largest, largest));
        high = std::max(high, std::clamp(v, -largest, largest));
    }
    bool empty() const { return !(low <= high); }
    double size() const { return std::max(std::abs(low), std::abs(high)); }
    /// What differs by rounding only is drawn as a constant.
    bool flat() const { return !(high - low > 1e-12 * size()) || size() < smallest_range; }
    void widen(double share) {
        const double by = !flat() ? share * (high - low) : size() > smallest_range ? 0.05 * size() : 1;
        low -= by;
        high += by;
    }

    static constexpr double smallest_range = 1e-300;
};

Range x_range(const Plot& p) {
    Range r;
    for (const auto* lines : {&p.lines, &p.outlines})
        for (const PlotLine& l : *lines)
            for (const double v : l.x) r.add(v);
    for (const PlotImage& i : p.images) r.add(i.x_min), r.add(i.x_max);
    for (const PlotBox& b : p.boxes) r.add(b.x_min), r.add(b.x_max);
    return r;
}

Range y_range(const Plot& p) {
    std::vector<double> values;
    for (const PlotLine& l : p.lines)
        std::ranges::copy_if(l.y, std::back_inserter(values), [](double v) { return std::isfinite(v); });
    Range r;
    if (!values.empty()) {
        std::size_t skip = p.clip_spikes ? values.size() / 100 : 0;
        std::ranges::sort(values);
        r.add(values[skip]);
        r.add(values[values.size() - 1 - skip]);
    }
    for (const PlotBand& b : p.bands) r.add(b.value - b.half_width), r.add(b.value + b.half_width);
    for (const PlotLevel& l : p.levels) r.add(l.value);
    for (const PlotImage& i : p.images) r.add(i.y_min), r.add(i.y_max);
    for (const PlotBox& b : p.boxes) r.add(b.y_min), r.add(b.y_max);
    if (p.include_zero && !r.empty()) r.add(0);
    return r;
}

/// Where a plot's axes lie within its drawing, and the data on them.
struct Axes {
    Range xr, yr;                                     ///< what they cover, in data
    double left = 0, top = 0, width = 0, height = 0;  ///< [px]
    double x(double v) const { return at(left + width * (v - xr.low) / (xr.high - xr.low)); }
    double y(double v) const { return at(top + height * (yr.high - v) / (yr.high - yr.low)); }

private:
    /// Far outside, where nothing is seen, places stay numbers that can be written.
    static double at(double pixel) { return std::clamp(pixel, -1e6, 1e6); }
};

/// Path of a line, its points thinned to what a pixel column shows.
std::string path(const PlotLine& line, const Axes& axes) {
    std::string d;
    bool pen_down = false;
    for (const std::size_t i : thinned(line, [&](double x) { return std::floor(axes.x(x)); })) {
        const bool finite = std::isfinite(line.x[i]) && std::isfinite(line.y[i]);
        if (finite) d += fmt::format("{}{:.1f},{:.1f}", pen_down ? 'L' : 'M', axes.x(line.x[i]), axes.y(line.y[i]));
        pen_down = finite;
    }
    return d;
}

/// The plot with the logarithms of what goes on logarithmic axes; values without one become NaN and are left out.
Plot in_logarithms(const Plot& p) {
    Plot q = p;
    const auto logarithm = [](double v) { return v > 0 ? std::log10(v) : std::nan(""); };
    for (PlotLine& l : q.lines) {
        if (p.log_x) std::ranges::transform(l.x, l.x.begin(), logarithm);
        if (p.log_y) std::ranges::transform(l.y, l.y.begin(), logarithm);
    }
    for (PlotLevel& l : q.levels)
        if (p.log_y) l.value = logarithm(l.value);
    std::erase_if(q.levels, [](const PlotLevel& l) { return !std::isfinite(l.value); });
    return q;
}

/// `room`: for their numbers beside each other [px]; where it does not do, decades alone have one.
std::vector<double> tick_places(double low, double high, int about, bool logarithmic, double room) {
    if (!logarithmic) return ticks(low, high, about);
    std::vector<double> places = log_ticks(std::pow(10, low), std::pow(10, high));
    if (constexpr double widest = 42; widest * static_cast<double>(places.size()) > room)
        std::erase_if(places, [](double v) { return std::abs(std::log10(v) - std::round(std::log10(v))) > 1e-9; });
    std::ranges::transform(places, places.begin(), [](double v) { return std::log10(v); });
    return places;
}

std::string axis_text(double v, double step, bool logarithmic) {
    return logarithmic ? number_text(std::pow(10, v)) : tick_text(v, step);
}

std::vector<LabelBox> areas_of(const std::vector<PlotBox>& boxes, const Axes& axes) {
    std::vector<LabelBox> areas;
    for (const PlotBox& b : boxes)
        areas.push_back({axes.x(b.x_min), axes.y(b.y_max), axes.x(b.x_max), axes.y(b.y_min),
                         7.0 * static_cast<double>(b.label.size())});
    return areas;
}

/// Along the upper edges of the box's parts and back along their lower ones.
std::string outline(const PlotBox& box, const Axes& axes) {
    const std::vector<PlotBox> parts = box.parts.empty() ? std::vector{box} : box.parts;
    std::string there, back;
    for (const PlotBox& part : parts) {
        there += fmt::format("{}{:.1f},{:.1f}H{:.1f}", there.empty() ? 'M' : 'L', axes.x(part.x_min),
                             axes.y(part.y_max), axes.x(part.x_max));
        back = fmt::format("L{:.1f},{:.1f}H{:.1f}", axes.x(part.x_max), axes.y(part.y_min), axes.x(part.x_min)) + back;
    }
    return there + back + 'Z';
}

/// One upright stroke for each x, as wide as two steps so that no light falls between.
std::string shadow_path(const PlotShadow& shadow, const Axes& axes) {
    if (shadow.x.empty()) return {};
    std::string d;
    for (std::size_t i = 0; i < shadow.x.size(); ++i)
        d += fmt::format("M{:.1f},{:.1f}V{:.1f}", axes.x(shadow.x[i]), axes.y(shadow.low[i]), axes.y(shadow.high[i]));
    return fmt::format("<path class=\"shadow\" stroke-width=\"{:.2f}\" d=\"{}\"/>",
                       2 * (axes.x(shadow.step) - axes.x(0)), d);
}

/// Entries from left to right below the title, in as many rows as they need.
struct Legend {
    std::string content;
    int rows = 0;
};
Legend legend_of(const std::vector<PlotLine>& lines, int left, double room) {
    Legend legend;
    double x = 0;
    for (const PlotLine& l : lines) {
        if (l.name.empty()) continue;
        const double entry = 34 + 7.2 * static_cast<double>(l.name.size());
        if (legend.rows == 0 || x + entry > room) {
            ++legend.rows;
            x = 0;
        }
        const double y = 20 + 16.0 * legend.rows;
        legend.content += fmt::format(
            "<line class=\"line s{}{}\" x1=\"{:.0f}\" x2=\"{:.0f}\" y1=\"{:.0f}\" y2=\"{:.0f}\"/><text x=\"{:.0f}\" "
            "y=\"{:.0f}\">{}</text>",
            l.source, l.dashed ? " dashed" : "", left + x, left + x + 22, y - 4, y - 4, left + x + 27, y,
            escaped(l.name));
        x += entry;
    }
    return legend;
}

std::string images_drawn(const Plot& p, const Axes& axes) {
    std::string out;
    for (const PlotImage& i : p.images)
        out += fmt::format(
            "<image href=\"data:image/png;base64,{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
            "preserveAspectRatio=\"none\"/>",
            i.png_base64, axes.x(i.x_min), axes.y(i.y_max), axes.x(i.x_max) - axes.x(i.x_min),
            axes.y(i.y_min) - axes.y(i.y_max));
    return out;
}

std::string grid_drawn(const std::vector<double>& x_ticks, const std::vector<double>& y_ticks, const Axes& axes) {
    std::string out;
    for (const double v : x_ticks)
        out += fmt::format("<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2:.1f}\"/>", axes.x(v),
                           axes.top, axes.top + axes.height);
    for (const double v : y_ticks)
        out += fmt::format("<line class=\"grid\" y1=\"{0:.1f}\" y2=\"{0:.1f}\" x1=\"{1}\" x2=\"{2:.1f}\"/>", axes.y(v),
                           axes.left, axes.left + axes.width);
    return out;
}

std::string boxes_drawn(const Plot& p, const Axes& axes) {
    std::string out;
    for (const PlotBox& box : p.boxes)
        out += fmt::format("<path class=\"box s{0} f{0}{1}\" d=\"{2}\"/>", box.source, box.dashed ? " dashed" : "",
                           outline(box, axes));
    return out;
}

std::string labels_drawn(const Plot& p, const Axes& axes) {
    std::string out;
    const auto places = label_places(
        areas_of(p.boxes, axes), {axes.left + 2, axes.top + 2, axes.left + axes.width - 2, axes.top + axes.height - 2});
    for (std::size_t i = 0; i < p.boxes.size(); ++i)
        if (places[i])
            out += fmt::format("<text class=\"box-text f{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", p.boxes[i].source,
                               places[i]->left, places[i]->bottom - 3, escaped(p.boxes[i].label));
    return out;
}

std::string bands_drawn(const Plot& p, const Axes& axes) {
    std::string out;
    for (const PlotBand& b : p.bands) {
        const double h = std::max(1.0, axes.y(b.value - b.half_width) - axes.y(b.value + b.half_width));
        out += fmt::format("<rect class=\"band f{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                           b.source, axes.x(b.from), axes.y(b.value) - 0.5 * h,
                           std::max(1.0, axes.x(b.to) - axes.x(b.from)), h);
        out += fmt::format("<line class=\"mean s{0}\" x1=\"{1:.1f}\" x2=\"{2:.1f}\" y1=\"{3:.1f}\" y2=\"{3:.1f}\"/>",
                           b.source, axes.x(b.from), axes.x(b.to), axes.y(b.value));
    }
    return out;
}

std::string lines_drawn(const Plot& p, const Axes& axes) {
    std::string out;
    for (const PlotLine& l : p.lines)
        out += fmt::format("<path class=\"line s{}{}{}\" d=\"{}\"/>", l.source, l.faint ? " faint" : "",
                           l.dashed ? " dashed" : "", path(l, axes));
    for (const PlotLine& l : p.lines)
        for (std::size_t i = 0; l.points && i < std::min(l.x.size(), l.y.size()); ++i)
            if (std::isfinite(l.x[i]) && std::isfinite(l.y[i]))
                out += fmt::format("<circle class=\"f{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"/>", l.source,
                                   axes.x(l.x[i]), axes.y(l.y[i]));
    for (const PlotLine& l : p.outlines) out += fmt::format("<path class=\"outline\" d=\"{}\"/>", path(l, axes));
    return out;
}

std::string levels_drawn(const Plot& p, const Axes& axes) {
    std::string out;
    const double right = axes.left + axes.width;
    for (const PlotLevel& l : p.levels)
        out += fmt::format(
            "<line class=\"level\" x1=\"{}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/><text class=\"level-text end\" "
            "x=\"{:.1f}\" y=\"{:.1f}\">{}</text>",
            axes.left, right, axes.y(l.value), axes.y(l.value), right - 6, axes.y(l.value) - 4, escaped(l.name));
    return out;
}

/// Where plots.js puts its axes.
std::string frame_drawn(const Plot& p, const Axes& axes) {
    return fmt::format(
        "<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{:.0f}\" height=\"{:.0f}\" data-axes=\"{:.9g} {:.9g} {:.9g} "
        "{:.9g}\" data-log=\"{}{}\" data-x=\"{}\" data-y=\"{}\"/>",
        axes.left, axes.top, axes.width, axes.height, axes.xr.low, axes.xr.high, axes.yr.low, axes.yr.high,
        p.log_x ? "x" : "", p.log_y ? "y" : "", escaped(label_text(p.x_label)), escaped(label_text(p.y_label)));
}

std::string tick_numbers(const Plot& p, const std::vector<double>& x_ticks, const std::vector<double>& y_ticks,
                         const Axes& axes) {
    std::string out;
    const auto step = [](const std::vector<double>& t) { return t.size() > 1 ? t[1] - t[0] : 1.0; };
    for (const double v : x_ticks)
        out += fmt::format("<text class=\"tick mid\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", axes.x(v),
                           axes.top + axes.height + 15, axis_text(v, step(x_ticks), p.log_x));
    for (const double v : y_ticks)
        out += fmt::format("<text class=\"tick end\" x=\"{}\" y=\"{:.1f}\">{}</text>", axes.left - 6, axes.y(v) + 4,
                           axis_text(v, step(y_ticks), p.log_y));
    return out;
}

std::string axis_labels(const Plot& p, const Axes& axes) {
    std::string out;
    if (!p.x_label.empty())
        out += fmt::format("<text class=\"mid\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", axes.left + 0.5 * axes.width,
                           axes.top + axes.height + 34, escaped(label_text(p.x_label)));
    if (!p.y_label.empty())
        out += fmt::format("<text class=\"mid\" transform=\"translate(14 {:.1f}) rotate(-90)\">{}</text>",
                           axes.top + 0.5 * axes.height, escaped(label_text(p.y_label)));
    return out;
}

/// A plot between its <svg> and </svg>; without an area where it has no data.
struct Drawing {
    std::string content;
    int width = 0, height = 0;
};

Drawing draw(const Plot& plot) {
    const Plot p = in_logarithms(plot);
    Range xr = x_range(p), yr = y_range(p);
    if (xr.empty() || yr.empty()) return {};
    if (p.images.empty()) yr.widen(p.boxes.empty() ? 0.06 : 0.02);
    if (!p.boxes.empty()) xr.widen(0.02);
    if (xr.flat()) xr.widen(0.05);
    if (std::ranges::any_of(p.lines, &PlotLine::points)) xr.widen(0.04);

    const int left = p.y_label.empty() ? 46 : 66, right = 14, bottom = p.x_label.empty() ? 22 : 44;
    const double width = p.width - left - right;
    const Legend legend = legend_of(p.lines, left, width);
    const int top = 26 + 16 * legend.rows;
    const int height =
        p.equal_scales
            ? top + bottom + static_cast<int>(width * std::min((yr.high - yr.low) / (xr.high - xr.low), 10.0))
            : p.height;
    const Axes axes{
        xr, yr, static_cast<double>(left), static_cast<double>(top), width, static_cast<double>(height - top - bottom)};
    const std::vector<double> x_ticks = tick_places(xr.low, xr.high, std::max(2, static_cast<int>(axes.width / 65)),
                                                    p.log_x, axes.width),
                              y_ticks = tick_places(yr.low, yr.high, std::max(2, static_cast<int>(axes.height / 45)),
                                                    p.log_y, HUGE_VAL);

    std::string out =
        fmt::format("<text class=\"plot-title\" x=\"{}\" y=\"16\">{}</text>{}", left, escaped(p.title), legend.content);
    // A nested <svg> clips what reaches beyond the axes and needs no id, which would have to be unique in the page.
    out += fmt::format(
        "<svg x=\"{0}\" y=\"{1}\" width=\"{2:.0f}\" height=\"{3:.0f}\" viewBox=\"{0} {1} {2:.0f} {3:.0f}\">", left, top,
        axes.width, axes.height);
    out += images_drawn(p, axes);
    if (p.images.empty()) out += grid_drawn(x_ticks, y_ticks, axes);
    out += shadow_path(p.shadow, axes) + boxes_drawn(p, axes) + bands_drawn(p, axes) + lines_drawn(p, axes);
    out += levels_drawn(p, axes) + labels_drawn(p, axes) + "</svg>";
    out += frame_drawn(p, axes) + tick_numbers(p, x_ticks, y_ticks, axes) + axis_labels(p, axes);
    return {out, p.width, height};
}

std::string framed(const std::string& content, int width, int height, const std::string& title) {
    return fmt::format(
        "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\" "
        "xmlns=\"http://www.w3.org/2000/svg\">{}</svg>",
        width, height, escaped(title), content);
}

}  // namespace

std::vector<std::size_t> thinned(const PlotLine& line, const std::function<double(double)>& column_of) {
    std::vector<std::size_t> kept;
    const std::size_t n = std::min(line.x.size(), line.y.size());
    const auto finite = [&](std::size_t i) { return std::isfinite(line.x[i]) && std::isfinite(line.y[i]); };
    for (std::size_t i = 0; i < n;) {
        std::size_t last = i, low = i, high = i;
        if (finite(i)) {
            const double column = column_of(line.x[i]);
            while (last + 1 < n && finite(last + 1) && column_of(line.x[last + 1]) == column) {
                ++last;
                if (line.y[last] < line.y[low]) low = last;
                if (line.y[last] > line.y[high]) high = last;
            }
        } else {
            while (last + 1 < n && !finite(last + 1)) ++last;
        }
        std::vector<std::size_t> keep{i, low, high, last};
        std::ranges::sort(keep);
        keep.erase(std::unique(keep.begin(), keep.end()), keep.end());
        std::ranges::copy(keep, std::back_inserter(kept));
        i = last + 1;
    }
    return kept;
}

std::string svg(const Plot& plot) {
    const Drawing d = draw(plot);
    if (d.content.empty()) return fmt::format("<p class=\"note\">{}: no data.</p>", escaped(plot.title));
    return framed(d.content, d.width, d.height, plot.title);
}

std::string svg_column(const std::vector<Plot>& plots) {
    std::string content, title;
    int width = 0, height = 0;
    for (const Plot& plot : plots) {
        const Drawing d = draw(plot);
        content += fmt::format("<g transform=\"translate(0 {})\">{}</g>", height, d.content);
        title += (title.empty() ? "" : "; ") + plot.title;
        width = std::max(width, d.width);
        height += d.height;
    }
    return framed(content, width, height, title);
}

std::string svg_file(const std::string& plot) {
    const auto end = plot.find('>');
    if (!plot.starts_with("<svg") || end == std::string::npos) return {};
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + plot.substr(0, end + 1) + "<style>" + report_style +
           "</style>" + plot.substr(end + 1) + "\n";
}

}  // namespace tw
