#include "compare/report/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "compare/report/drawn_solids.h"
#include "compare/report/escape.h"
#include "compare/report/resolution_picture.h"
#include "methods/methods.h"
#include "record/force_names.h"
#include "record/hull_motion.h"
#include "record/record_numbers.h"
#include "record/water_in_box.h"
#include "statistics/time_bins.h"

namespace tw {

namespace {

/// Width of the moving mean of displayed traces [s]: measured to take out particle noise and to leave the flow, 0.16
/// beam / speed.
double display_filter(const RunRecord& record) {
    const double speed = number_of(record, "speed", 0), beam = number_of(record, "beam", 0);
    return speed > 0 && beam > 0 ? 0.16 * beam / speed : 0;
}

/// " [N/m]": the unit that the records have a column in.
std::string unit_of(const Comparison& c, const std::string& table, const std::string& column) {
    for (const RunRecord& r : c.sources)
        if (const Column* found = r.series(table, column)) return " [" + found->unit + "]";
    return {};
}

struct Trace {
    const char* quantity;
    std::string title;
    const char* column;
    std::string y_label;
};

Figure force_figure(const Comparison& c, const Trace& t) {
    Plot plot;
    plot.title = t.title;
    plot.x_label = "time [s]";
    plot.y_label = t.y_label;
    plot.clip_spikes = true;
    double filter = 0;
    std::vector<PlotLine> smooth;
    for (std::size_t s = 0; s < c.sources.size(); ++s) {
        const Column* column = c.sources[s].series("forces", t.column);
        if (!column) continue;
        const auto& time = c.sources[s].tables.at("forces").time;
        const double width = display_filter(c.sources[s]);
        filter = std::max(filter, width);
        if (width > 0) plot.lines.push_back({"", s, time, column->values, true, false});
        smooth.push_back({method_label(c.names[s]), s, time,
                          width > 0 ? moving_mean(time, column->values, width) : column->values, false, false});
    }
    for (PlotLine& l : smooth) plot.lines.push_back(std::move(l));
    if (const Quantity* q = c.find(t.quantity))
        for (std::size_t s = 0; s < q->values.size(); ++s)
            if (q->values[s].known)
                plot.bands.push_back(
                    {s, q->values[s].from, q->values[s].to, q->values[s].value, q->values[s].half_width});
    for (const Reference& r : c.references)
        if (r.quantity == t.quantity)
            plot.levels.push_back(
                {r.source + (std::string(t.quantity) == "drag" && r.remark.find("pressure") != std::string::npos
                                 ? ", pressure part"
                                 : ""),
                 r.value});
    if (filter > 0) plot.title += fmt::format(" (bold: moving mean of {:.2g} ms)", 1e3 * filter);
    return {std::string("force_") + t.quantity, live_plot(plot)};
}

Figure splash_figure(const Comparison& c, const std::string& file, const std::string& title, const std::string& unit,
                     const std::string& column, const std::string& quantity) {
    Plot plot;
    plot.title = title;
    plot.x_label = "time [s]";
    plot.y_label = unit;
    plot.include_zero = true;
    for (std::size_t s = 0; s < c.sources.size(); ++s)
        if (const Column* v = c.analyses[s].splash.find(column))
            plot.lines.push_back({method_label(c.names[s]), s, c.analyses[s].splash.time, v->values, false, false});
    if (const Quantity* q = c.find(quantity))
        for (std::size_t s = 0; s < q->values.size(); ++s)
            if (q->values[s].known)
                plot.bands.push_back(
                    {s, q->values[s].from, q->values[s].to, q->values[s].value, q->values[s].half_width});
    return {file, live_plot(plot)};
}

/// The open cavity or the crown of a body, of all sources over the frames; nothing where the body left none.
std::vector<Figure> entry_figures(const Comparison& c, const std::string& name, int number) {
    std::vector<Figure> figures;
    if (!c.find("crown_height:" + name)) return figures;
    for (const auto& [column, title] : {std::pair{"open_depth", "Deepest open cavity at"},
                                        {"crown_height", "Height of the crown of"},
                                        {"crown_volume", "Water above still water,"}}) {
        Plot plot;
        plot.title = fmt::format("{} {}", title, name);
        plot.x_label = "time [s]";
        plot.include_zero = true;
        for (std::size_t s = 0; s < c.sources.size(); ++s)
            for (const Table& entry : c.analyses[s].entries)
                if (const Column* v = entry.name == "entry_" + name ? entry.find(column) : nullptr) {
                    plot.y_label = fmt::format("[{}]", v->unit);
                    plot.lines.push_back({method_label(c.names[s]), s, entry.time, v->values, false, false});
                }
        figures.push_back({fmt::format("entry_{}_{}", number, column), live_plot(plot)});
    }
    return figures;
}

/// A column of any table of all sources over time.
Figure series_figure(const Comparison& c, const std::string& table, const std::string& column, const std::string& title,
                     const std::string& y_label, const std::string& quantity, const std::string& file) {
    Plot plot;
    plot.title = title;
    plot.x_label = "time [s]";
    plot.y_label = y_label;
    plot.clip_spikes = true;
    for (std::size_t s = 0; s < c.sources.size(); ++s)
        if (const Column* v = c.sources[s].series(table, column))
            plot.lines.push_back(
                {method_label(c.names[s]), s, c.sources[s].tables.at(table).time, v->values, false, false});
    if (const Quantity* q = c.find(quantity))
        for (std::size_t s = 0; s < q->values.size(); ++s)
            if (q->values[s].known)
                plot.bands.push_back(
                    {s, q->values[s].from, q->values[s].to, q->values[s].value, q->values[s].half_width});
    return {file, live_plot(plot)};
}

Figure cut_figure(const Comparison& c, const Analysis& like, std::size_t k) {
    const Cut& first = like.cuts[k];
    Plot plot;
    const bool mean = is_stream(c.sources.front());
    plot.title = fmt::format(
        "{} along {} = {:.4g} m",
        mean ? std::string("Mean free surface") : fmt::format("Free surface at {:.3g} s", like.surface_from),
        first.along_x ? "y" : "x", first.place);
    plot.x_label = first.along_x ? "x, to the stern [m]" : "y [m]";
    plot.y_label = "elevation [m]";
    plot.include_zero = true;
    for (std::size_t s = 0; s < c.analyses.size(); ++s) {
        if (k >= c.analyses[s].cuts.size()) continue;
        const Cut& cut = c.analyses[s].cuts[k];
        plot.lines.push_back({method_label(c.names[s]), s, cut.position, cut.elevation, false, false});
    }
    return {fmt::format("cut_{}_{}", first.along_x ? "y" : "x", k), live_plot(plot)};
}

/// Plan view of the hull as the outline of its columns would be too coarse: the convex hull of its points (monotone
/// chain).
PlotLine plan_outline(const Surface& hull) {
    std::vector<std::pair<double, double>> points;
    for (const Vec3& p : hull.points) points.emplace_back(p.x(), p.y());
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<std::pair<double, double>> chain;
    const auto turn = [](auto a, auto b, auto p) {
        return (b.first - a.first) * (p.second - a.second) - (b.second - a.second) * (p.first - a.first);
    };
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = chain.size();
        for (const auto& p : points) {
            while (chain.size() >= start + 2 && turn(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
            chain.push_back(p);
        }
        if (!chain.empty()) chain.pop_back();
        std::ranges::reverse(points);
    }
    if (!chain.empty()) chain.push_back(chain.front());
    PlotLine line;
    for (const auto& [x, y] : chain) line.x.push_back(x), line.y.push_back(y);
    return line;
}

Figure map_figure(const Comparison& c, std::size_t s, const ColourScale& scale) {
    const ElevationPicture picture = elevation_picture(c.sources[s], c.analyses[s], scale);
    Plot plot;
    plot.title = method_label(c.names[s]);
    plot.x_label = "x, to the stern [m]";
    plot.y_label = "y [m]";
    plot.equal_scales = true;
    plot.width = 560;
    plot.images.push_back({base64(picture.png), picture.x_min, picture.x_max, picture.y_min, picture.y_max});
    if (!c.sources[s].hull.points.empty()) plot.outlines.push_back(plan_outline(c.sources[s].hull));
    for (const Surface& body : bodies_at(c.sources[s], c.sources[s].frames.back().time))
        plot.outlines.push_back(plan_outline(body));
    return {fmt::format("elevation_map_{}", s), live_plot(plot)};
}

bool any_has(const Comparison& c, const char* table, const char* column) {
    return std::ranges::any_of(c.sources, [&](const RunRecord& r) { return r.series(table, column) != nullptr; });
}

/// Loads over time, and how a free hull moves.
std::vector<Figure> force_figures(const Comparison& c) {
    std::vector<Figure> figures;
    const bool stream = std::ranges::any_of(c.sources, is_stream);
    const ForceNames called = force_names(stream);
    for (const Trace& t :
         {Trace{"lift", called.up, "fz", lower_case_first(called.up) + unit_of(c, "forces", "fz")},
          Trace{"drag", called.along, "fx", lower_case_first(called.along) + unit_of(c, "forces", "fx")},
          Trace{"trim_moment", called.moment + (stream ? ", bow up" : ""), "my",
                "moment" + unit_of(c, "forces", "my")}})
        if (any_has(c, "forces", t.column)) figures.push_back(force_figure(c, t));
    for (const auto& [column, title, unit, quantity] :
         {std::tuple{"trim", "Running trim", "trim, bow up [deg]", "running_trim"},
          std::tuple{"z", "Height of the centre of gravity", "above still water [m]", ""},
          std::tuple{"transom_draft", "Draft of the transom's keel", "below still water [m]", ""}})
        if (any_has(c, hull_motion_table, column))
            figures.push_back(
                series_figure(c, hull_motion_table, column, title, unit, quantity, fmt::format("hull_{}", column)));
    return figures;
}

/// Raised water, and of the spray what is resolved; what is not, and why, goes into `splash_not_drawn`.
void add_splash_figures(Figures& f, const Comparison& c) {
    if (const Quantity* raised = c.find("splash_raised");
        raised && std::ranges::any_of(raised->values, &MeanValue::known))
        f.splash.push_back(splash_figure(c, "splash_raised", "Water raised behind the hull, per metre of way",
                                         "area [m2]", "raised_area", "splash_raised"));
    const auto resolved = [&](const char* quantity) {
        const Quantity* q = c.find(quantity);
        if (q && !q->not_resolved.empty() && f.splash_not_drawn.empty()) f.splash_not_drawn = q->not_resolved;
        return !q || q->not_resolved.empty();
    };
    if (resolved("splash_sheet_height"))
        f.splash.push_back(splash_figure(c, "splash_sheet", "Highest connected water", "height [m]", "sheet_height",
                                         "splash_sheet_height"));
    if (resolved("splash_p99"))
        f.splash.push_back(
            splash_figure(c, "splash_p99", "99 % of the airborne water lies below", "height [m]", "p99", "splash_p99"));
    if (resolved("airborne_volume"))
        f.splash.push_back(
            splash_figure(c, "airborne_volume", "Airborne water", "volume [m3]", "airborne_volume", "airborne_volume"));
    if (f.splash_not_drawn.empty())
        f.splash.push_back(
            splash_figure(c, "splash_raw", "Highest water of any kind (not judged)", "height [m]", "raw_height", ""));
}

std::vector<Figure> cut_figures(const Comparison& c) {
    std::vector<Figure> figures;
    const auto with_cuts = std::ranges::find_if(c.analyses, [](const Analysis& a) { return !a.cuts.empty(); });
    for (std::size_t k = 0; with_cuts != c.analyses.end() && k < with_cuts->cuts.size(); ++k)
        figures.push_back(cut_figure(c, *with_cuts, k));
    return figures;
}

std::vector<Figure> probe_figures(const Comparison& c) {
    std::vector<Figure> figures;
    const std::pair<std::string, const char*> tables[] = {
        {"height", "Water height at"}, {volume_table, "Water in"}, {"pressure", "Pressure at"}};
    for (const auto& [table, title] : tables) {
        std::set<std::pair<std::string, std::string>> names;
        for (const RunRecord& r : c.sources)
            if (const auto found = r.tables.find(table); found != r.tables.end())
                for (const Column& column : found->second.columns) names.emplace(column.name, column.unit);
        for (const auto& [name, unit] : names)
            figures.push_back(series_figure(c, table, name, fmt::format("{} {}", title, name),
                                            fmt::format("{} [{}]", table, unit), "",
                                            fmt::format("probe_{}", figures.size())));
    }
    return figures;
}

/// How bodies move and are loaded, what their entry leaves in the water, and the strains of elastic ones.
std::vector<Figure> body_figures(const Comparison& c) {
    std::vector<Figure> figures;
    std::set<std::string> bodies;
    for (const RunRecord& r : c.sources)
        for (const auto& [table, content] : r.tables)
            if (table.starts_with("body_") && content.find("q0")) bodies.insert(table);
    int body = 0;
    for (const std::string& table : bodies) {
        const std::string name = table.substr(5);
        for (const auto& [column, title, label] :
             {std::tuple{"z", "Height of the centre of mass", "z"}, std::tuple{"vz", "Vertical velocity", "velocity"},
              std::tuple{"fz", "Vertical force of the water", "force"}})
            figures.push_back(series_figure(c, table, column, fmt::format("{} of {}", title, name),
                                            label + unit_of(c, table, column), "",
                                            fmt::format("body_{}_{}", body, column)));
        std::ranges::move(entry_figures(c, name, body), std::back_inserter(figures));
        ++body;
    }
    int gauge = 0;
    for (const Quantity& q : c.quantities) {
        if (!q.name.starts_with("strain_peak:")) continue;
        const auto colon = q.name.find(':', 12);
        const std::string name = q.name.substr(12, colon - 12), column = q.name.substr(colon + 1);
        figures.push_back(series_figure(c, body_table(name), column, fmt::format("Strain {} of {}", column, name),
                                        "strain [-]", "", fmt::format("gauge_{}", gauge++)));
    }
    return figures;
}

/// The surface from above and the rendered pictures, with their legends.
void add_pictures(Figures& f, const Comparison& c) {
    const ColourScale scale = elevation_scale(elevation_half_range(c), c.analyses.front().still_level);
    f.elevation_legend = scale.legend(is_stream(c.sources.front()) ? "height above still water [m]" : "height z [m]");
    for (std::size_t s = 0; s < c.sources.size(); ++s)
        if (!c.analyses[s].mean_elevation.empty() && c.sources[s].raster.count[1] > 1)
            f.maps.push_back(map_figure(c, s, scale));
    f.pictures = render_pictures(c, scale);
    if (f.pictures.pressure_high > f.pictures.pressure_low)
        f.pressure_legend =
            pressure_scale(f.pictures.pressure_low / 1e3, f.pictures.pressure_high / 1e3).legend("pressure [kPa]");
}

}  // namespace

Figures draw_figures(const Comparison& c) {
    Figures f;
    f.forces = force_figures(c);
    if (const std::string picture = resolution_picture(c.sources, c.names); !picture.empty())
        f.resolution.push_back({"resolution", {picture, {}}});
    const bool frames = std::ranges::any_of(c.sources, [](const RunRecord& r) { return !r.frames.empty(); });
    if (frames) add_splash_figures(f, c);
    if (any_has(c, "samples", "wetted_length"))
        f.wetting.push_back(series_figure(c, "samples", "wetted_length", "Wetted length", "length [m]", "wetted_length",
                                          "wetted_length"));
    f.cuts = cut_figures(c);
    f.probes = probe_figures(c);
    f.bodies = body_figures(c);
    if (frames) add_pictures(f, c);
    return f;
}

}  // namespace tw
