#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "compare/report/page.h"
#include "compare/report/svg_plot.h"
#include "record/code_version.h"
#include "spray/report/write_spray.h"

namespace tw::spray {
namespace {

/// A curve without values yet.
PlotLine curve(std::string name, std::size_t source) {
    PlotLine line;
    line.name = std::move(name), line.source = source;
    return line;
}
PlotLine dashed(std::string name, std::size_t source) {
    PlotLine line = curve(std::move(name), source);
    line.dashed = true;
    return line;
}
PlotLine faint(std::string name, std::size_t source) {
    PlotLine line = curve(std::move(name), source);
    line.faint = true;
    return line;
}
PlotLine dots(std::string name, std::size_t source) {
    PlotLine line = curve(std::move(name), source);
    line.points = true;
    return line;
}

std::string figure(const Plot& plot, const std::string& caption) {
    return "<figure>" + svg(plot) + "<figcaption>" + escaped(caption) + "</figcaption></figure>";
}

std::string envelope(const std::string& title, const std::string& label, const std::vector<EnvelopeSlice>& slices) {
    Plot p;
    p.title = title, p.x_label = label, p.y_label = "z [m]";
    PlotLine highest = curve("highest droplet", 0), mean = dashed("mean by volume", 1);
    for (const EnvelopeSlice& s : slices) {
        highest.x.push_back(s.at), highest.y.push_back(s.highest);
        mean.x.push_back(s.at), mean.y.push_back(s.mean);
    }
    p.lines = {highest, mean};
    return figure(p, "Over the whole flight, in 60 slices; at most 20000 droplets are drawn from.");
}

/// Shares of number and volume in 30 equal classes.
std::string distribution(const std::string& title, const std::string& label, const SprayResult& r,
                         const std::function<double(const Droplet&)>& value) {
    double low = 1e300, high = 0, volumes = 0;
    for (const Droplet& d : r.droplets) {
        low = std::min(low, value(d)), high = std::max(high, value(d));
        volumes += sphere_volume(d.diameter);
    }
    constexpr int classes = 30;
    if (!(high > low * (1 + 1e-9)))
        return "<p>" + escaped(fmt::format("{}: all droplets have the same, {} = {:.4g}.", title, label, low)) + "</p>";
    std::vector<double> number(classes), volume(classes);
    for (const Droplet& d : r.droplets) {
        const auto k =
            static_cast<std::size_t>(std::clamp(classes * (value(d) - low) / (high - low), 0.0, classes - 1.0));
        number[k] += 100.0 / static_cast<double>(r.droplets.size());
        volume[k] += 100 * sphere_volume(d.diameter) / volumes;
    }
    Plot p;
    p.title = title, p.x_label = label, p.y_label = "share of a class [%]", p.include_zero = true;
    PlotLine by_number = curve("of the number", 0), by_volume = curve("of the volume", 1);
    for (int k = 0; k < classes; ++k) {
        const double at = low + (k + 0.5) * (high - low) / classes;
        by_number.x.push_back(at), by_number.y.push_back(number[static_cast<std::size_t>(k)]);
        by_volume.x.push_back(at), by_volume.y.push_back(volume[static_cast<std::size_t>(k)]);
    }
    p.lines = {by_number, by_volume};
    return figure(p, "In 30 classes of equal width.");
}

std::string drawn(std::size_t stride, std::size_t all) {
    return stride == 1 ? fmt::format("All {} droplets", all) : fmt::format("One in {} of {} droplets", stride, all);
}

/// Where droplets met a surface, seen along its mean normal, through the middle of its box.
std::string target_map(const SprayResult& r, const TargetSurface& target, int number) {
    Vec3 normal = Vec3::Zero();
    Box box{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
    for (const auto& t : target.surface.triangles) {
        const auto point = [&](std::size_t k) { return target.surface.points[static_cast<std::size_t>(t[k])]; };
        normal += (point(1) - point(0)).cross(point(2) - point(0));
        for (std::size_t k = 0; k < 3; ++k) box.min = box.min.cwiseMin(point(k)), box.max = box.max.cwiseMax(point(k));
    }
    // the areas of a closed surface cancel: it is seen from the side
    const bool closed = !(normal.norm() > 1e-6 * box.size().squaredNorm());
    const Sensor plane{0.5 * (box.min + box.max), closed ? Vec3(Vec3::UnitY()) : normal, 1};
    Plot p;
    p.title = "Arrivals on " + target.name, p.x_label = "across [m]", p.y_label = "along [m]", p.equal_scales = true;
    PlotLine places = dots("", 0);
    std::size_t hits = 0;
    for (const Landing& l : r.landings) hits += l.fate == Fate::hit && l.target == number;
    const std::size_t stride = 1 + hits / 3000;
    std::size_t seen = 0;
    for (const Landing& l : r.landings) {
        if (l.fate != Fate::hit || l.target != number || seen++ % stride != 0) continue;
        const Vec3 from = l.place - plane.centre;
        places.x.insert(places.x.end(), {from.dot(plane.across()), std::nan("")});
        places.y.insert(places.y.end(), {from.dot(plane.along()), std::nan("")});
    }
    if (hits == 0) return {};
    p.lines = {places};
    return figure(p, fmt::format("{}, seen {}; from the middle of the surface's box.", drawn(stride, hits),
                                 closed ? "along y" : "along the surface's mean normal"));
}

/// The study's Figure 13: the force of one droplet in time, here of the sensor's mean droplet.
std::string pulse_figure(const SprayStudy& study, const SprayResult& r) {
    double volume = 0, speed = 0;
    for (const Arrival& a : r.arrivals)
        volume += sphere_volume(a.diameter), speed += sphere_volume(a.diameter) * a.normal_speed;
    const double V = speed / volume, d = sphere_diameter(volume / static_cast<double>(r.arrivals.size()));
    const Liquid& liquid = study.extraction.liquid;
    const double F = peak_force(V, d, liquid), I = impulse(V, d, liquid);
    Plot p;
    p.title = "Force of one droplet", p.x_label = "t [ms]", p.y_label = "F [N]", p.include_zero = true;
    PlotLine root = curve("root of time", 0), printed = dashed("the study's polynomial", 1);
    const Pulse a(PulseShape::root, F, I), b(PulseShape::study, F, I);
    const double end = std::max(a.duration(), b.duration());
    for (int k = 0; k <= 300; ++k) {
        const double t = end * k / 300;
        root.x.push_back(1e3 * t), root.y.push_back(a.force(t));
        if (t < b.duration()) printed.x.push_back(1e3 * t), printed.y.push_back(b.force(t));
    }
    p.lines = {root, printed};
    return figure(p, fmt::format("A droplet of {:.3g} mm at {:.3g} m/s, the means of the arrivals: peak {:.3g} N, "
                                 "impulse {:.3g} N s. The polynomial is drawn as far as its printed digits carry.",
                                 1e3 * d, V, F, I));
}

std::string arrival_map(const SprayStudy& study, const SprayResult& r) {
    Plot p;
    p.title = "Arrivals on the sensor", p.x_label = "across [mm]", p.y_label = "along [mm]", p.equal_scales = true;
    // several thousand dots say no more than one thousand
    const std::size_t stride = 1 + r.arrivals.size() / 3000;
    PlotLine places = dots("", 0);
    for (std::size_t i = 0; i < r.arrivals.size(); i += stride) {
        places.x.insert(places.x.end(), {1e3 * r.arrivals[i].across, nan});
        places.y.insert(places.y.end(), {1e3 * r.arrivals[i].along, nan});
    }
    const double e = 500 * study.sensor->window.edge;
    p.lines = {places};
    PlotLine square = curve("", 0);
    square.x = {-e, e, e, -e, -e}, square.y = {-e, -e, e, e, -e};
    p.outlines = {square};
    const Window& w = r.anywhere->window;
    PlotLine fullest = square;
    for (double& x : fullest.x) x += 1e3 * w.across;
    for (double& y : fullest.y) y += 1e3 * w.along;
    if (w.across != 0 || w.along != 0) p.outlines.push_back(fullest);
    return figure(p, fmt::format("{}; the squares are the window in the middle and the one with the largest average.",
                                 drawn(stride, r.arrivals.size())));
}

std::string load_in_time(const SprayResult& r) {
    Plot p;
    p.title = "Load against time", p.x_label = "t [s]", p.y_label = "p [kPa]", p.include_zero = true;
    PlotLine peak = dots("peak (study)", 1), average = dots("average (study)", 2),
             corrected = dots("corrected (study)", 3), direct = faint("direct", 0), low = dashed("average, 95 %", 2),
             high = dashed("", 2);
    for (const WindowLoad& w : r.windows) {
        const double t = w.window.from + 0.5 * w.window.length,
                     hide = w.estimate.droplets > 0 && w.estimate.droplets < Estimate::enough ? std::nan("") : 0;
        for (auto [line, value] : {std::pair{&peak, w.estimate.peak + hide},
                                   {&average, w.estimate.average + hide},
                                   {&corrected, w.estimate.corrected + hide},
                                   {&low, w.droplets.average.low},
                                   {&high, w.droplets.average.high}})
            line->x.push_back(t), line->y.push_back(1e-3 * value);
    }
    const std::size_t stride = 1 + r.curve.pressure.size() / 4000;
    for (std::size_t k = 0; k < r.curve.pressure.size(); k += stride) {
        direct.x.push_back(r.curve.from + (static_cast<double>(k) + 0.5) * r.curve.step);
        direct.y.push_back(1e-3 * r.curve.pressure[k]);
    }
    p.lines = {direct, peak, average, corrected, low, high};
    if (r.measured) p.levels = {{"measured", 1e-3 * r.measured->kept_mean}};
    return figure(
        p,
        "Windows side by side in time, in the middle of the sensor; the dashed lines are the bootstrap's 95 % of the "
        "average. Values of windows with fewer than 30 droplets are not drawn.");
}

std::string convergence(const std::string& title, const std::string& label, const std::vector<WindowLoad>& loads,
                        const std::function<double(const Window&)>& at) {
    Plot p;
    p.title = title, p.x_label = label, p.y_label = "p [kPa]", p.log_x = true, p.include_zero = true;
    PlotLine peak = dots("peak (study)", 1), average = dots("average (study)", 2),
             corrected = dots("corrected (study)", 3), direct = dots("direct peak", 0),
             low = dashed("average, 95 %", 2), high = dashed("", 2);
    for (const WindowLoad& w : loads) {
        const double x = at(w.window), hide = w.estimate.droplets < Estimate::enough ? std::nan("") : 0;
        for (auto [line, value] : {std::pair{&peak, w.estimate.peak + hide},
                                   {&average, w.estimate.average + hide},
                                   {&corrected, w.estimate.corrected + hide},
                                   {&direct, w.estimate.direct_peak + hide},
                                   {&low, w.droplets.average.low},
                                   {&high, w.droplets.average.high}})
            line->x.push_back(x), line->y.push_back(1e-3 * value);
    }
    p.lines = {peak, average, corrected, direct, low, high};
    return figure(
        p, "At the time of the largest average. Values of fewer than 30 droplets are not drawn, their interval is.");
}

/// Windows that no droplet meets say nothing on a page.
void leave_out_empty(ReportTable& t) {
    const std::size_t droplets = 3, all = t.rows.size();
    std::erase_if(t.rows, [&](const ReportRow& row) { return row.cells.at(droplets).number == 0; });
    if (t.rows.size() < all)
        t.notes.push_back(fmt::format("{} of {} windows have no droplet and are left out; windows.csv has all.",
                                      all - t.rows.size(), all));
}

}  // namespace

std::string spray_html(const SprayStudy& study, const SprayResult& r) {
    const std::string title = study.title.empty() ? "Spray" : study.title;
    std::string out =
        page_begin(title) + "<h1>" + escaped(title) + "</h1>" +
        fmt::format("<p class=\"sub\">twinwake {}, {} droplets</p>", escaped(TWINWAKE_CODE_VERSION), r.droplets.size());
    std::vector<ReportTable> tables = spray_tables(study, r);
    constexpr std::size_t first_rows = 200;  // of a table on the page; the CSV file has them all
    for (ReportTable& t : tables) {
        if (t.title == "Load in time") leave_out_empty(t);
        if (t.rows.size() > first_rows) {
            t.notes.push_back(fmt::format("The first {} of {} rows; windows.csv has all.", first_rows, t.rows.size()));
            t.rows.resize(first_rows);
        }
    }
    for (const ReportTable& t : tables) out += html_of(t);
    if (r.droplets.empty()) return out + "<p>No droplets: nothing to draw.</p>" + page_end;
    out += "<h2>The spray</h2>";
    out += envelope("Envelope from the side", "x [m]", r.side) + envelope("Envelope from the front", "y [m]", r.front);
    out += distribution("Sizes", "d [mm]", r, [](const Droplet& d) { return 1e3 * d.diameter; });
    out += distribution("Speeds at release", "speed [m/s]", r, [](const Droplet& d) { return d.velocity.norm(); });
    std::string maps;
    for (std::size_t t = 0; t < study.targets.size(); ++t) maps += target_map(r, study.targets[t], static_cast<int>(t));
    if (!maps.empty()) out += "<h2>Arrivals</h2>" + maps;
    if (study.sensor && !r.arrivals.empty()) {
        out += "<h2>The load on the sensor</h2>" + arrival_map(study, r) + load_in_time(r) + pulse_figure(study, r);
        out += convergence("Over the window's area", "area [mm2]", r.by_area,
                           [](const Window& w) { return 1e6 * w.area(); });
        out += convergence("Over the window's length", "length [ms]", r.by_length,
                           [](const Window& w) { return 1e3 * w.length; });
    }
    return out + page_end;
}

}  // namespace tw::spray
