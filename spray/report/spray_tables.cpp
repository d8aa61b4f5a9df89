#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "spray/report/two_sprays.h"
#include "spray/report/write_spray.h"

namespace tw::spray {
namespace {

ReportTable ledger_table(const SprayStudy& study, const SprayResult& r) {
    const Ledger& l = r.extraction.ledger;
    ReportTable t{"Ledger of the water",
                  {words("water"), numbers("pieces", "", 9), numbers("volume", "m3", 6),
                   numbers("momentum x", "kg m/s", 5), numbers("y", "kg m/s", 5), numbers("z", "kg m/s", 5),
                   numbers("kinetic energy", "J", 6), numbers("potential energy", "J", 6)}};
    const auto row = [&](const char* name, const Budget& b) {
        t.rows.push_back({{name, b.pieces, b.volume, b.momentum.x(), b.momentum.y(), b.momentum.z(), b.kinetic_energy,
                           b.potential_energy}});
    };
    row("all, frame by frame", l.all);
    row("the body of water", l.body);
    row(study.extraction.attached ? "before the gate" : "detached, before the gate", l.before_gate);
    row("beyond it at the frame before", l.earlier);
    row("too large", l.lumps);
    row("too few particles or cells", l.crumbs);
    row("taken", l.taken);
    row("droplets", l.droplets);
    row("droplets as they fell back", r.back);
    row("droplets as they met a surface", r.landed);
    if (r.away.pieces > 0) row("droplets that still fly", r.away);
    t.notes.push_back(fmt::format(
        "Taken and droplets agree to {:.1e} of the volume. Kinetic energy within the components, which a sphere does "
        "not "
        "carry: {:.4g} J. Volume that came back through the gate: {:.4g} m3.",
        l.taken.volume > 0 ? std::abs(l.droplets.volume / l.taken.volume - 1) : 0, l.inner_energy, l.returned));
    if (!study.source.fvm.empty())
        t.notes.push_back(fmt::format("Left out beforehand: {:.4g} m3 in cells with a water share below {:g}.",
                                      r.left_out, study.source.least_share));
    return t;
}

ReportTable fates_table(const SprayResult& r, const Liquid& liquid) {
    ReportTable t{"Where the droplets went",
                  {words("end"), numbers("droplets", "", 9), numbers("volume", "m3", 6),
                   numbers("mean normal speed", "m/s"), numbers("impulse", "N s"),
                   numbers("outside Re > 230, We > 50", "%"), numbers("largest pressure under one drop", "Pa")}};
    const auto row = [&](const std::string& name, Fate fate, int target) {
        double volume = 0, speed = 0, impulses = 0, under_one = 0;
        std::size_t count = 0, outside = 0;
        for (std::size_t i = 0; i < r.landings.size(); ++i) {
            const Landing& l = r.landings[i];
            if (l.fate != fate || (fate == Fate::hit && l.target != target)) continue;
            const double d = r.droplets[i].diameter;
            ++count, volume += sphere_volume(d), speed += l.normal_speed;
            if (fate != Fate::hit) continue;
            impulses += impulse(l.normal_speed, d, liquid);
            outside += !within_law(l.normal_speed, d, liquid);
            under_one = std::max(under_one, pressure_of_one(l.normal_speed, d, 0, liquid));
        }
        ReportRow cells{{name, count, volume}};
        if (fate == Fate::hit && count > 0) {
            const auto n = static_cast<double>(count);
            cells.cells.insert(cells.cells.end(),
                               {speed / n, impulses, 100 * static_cast<double>(outside) / n, under_one});
        } else {
            cells.cells.insert(cells.cells.end(), {"", "", "", ""});
        }
        t.rows.push_back(cells);
        return count;
    };
    for (std::size_t k = 0; k < r.target_names.size(); ++k)
        if (row(r.target_names[k], Fate::hit, static_cast<int>(k)) == 0)
            t.rows.back().remark = "No droplet reaches this surface: its load is zero.";
    row("fell back into the water", Fate::fell_back, -1);
    row("still flying at the end", Fate::flying, -1);
    row("left the air field", Fate::left_air, -1);
    return t;
}

constexpr double kilo = 1e-3;  ///< kPa in a Pa

/// A pressure in kPa, or what an estimate of few droplets is worth.
ReportCell pressure(const Estimate& e, double value) {
    if (e.droplets >= Estimate::enough || e.droplets == 0) return kilo * value;
    return std::string("too few");
}
std::string interval(const Interval& i) { return fmt::format("{:.3g} to {:.3g}", kilo * i.low, kilo * i.high); }

ReportTable loads_table(const std::string& title, const std::vector<WindowLoad>& loads,
                        std::span<const Arrival> arrivals) {
    ReportTable t{
        title,
        {numbers("window", "mm2", 4), numbers("from", "s", 6), numbers("length", "ms", 4), numbers("droplets", "", 9),
         numbers("outside", "%"), numbers("peak", "kPa"), numbers("average", "kPa"), numbers("Monte Carlo", "kPa"),
         numbers("corrected", "kPa"), numbers("direct mean", "kPa"), numbers("direct peak", "kPa"),
         words("average, 95 %", "kPa"), words("direct peak, 95 %", "kPa")}};
    for (const WindowLoad& w : loads) {
        const Estimate& e = w.estimate;
        ReportRow row{{1e6 * w.window.area(), w.window.from, 1e3 * w.window.length, e.droplets,
                       e.droplets > 0 ? 100.0 * static_cast<double>(e.outside) / static_cast<double>(e.droplets) : 0.0,
                       pressure(e, e.peak), pressure(e, e.average), pressure(e, e.monte_carlo),
                       pressure(e, e.corrected), pressure(e, e.direct_mean), pressure(e, e.direct_peak),
                       interval(w.droplets.average), interval(w.droplets.direct_peak)}};
        if (wider_than_spray(arrivals, w.window)) row.remark = "This window is wider than the spray on the sensor.";
        t.rows.push_back(row);
    }
    t.notes.push_back(fmt::format("Fewer than {} droplets give an interval and no value.", Estimate::enough));
    return t;
}

/// Whether the droplets are fast enough for the surfaces.
ReportTable reach_table(const SprayResult& r) {
    ReportTable t{"Speed that the way to a surface asks for",
                  {words("surface"), numbers("least speed", "m/s"), numbers("fastest droplet", "m/s"),
                   numbers("mean speed", "m/s"), numbers("fast enough", "", 9), numbers("share of the volume", "%")}};
    double volume = 0;
    for (const Droplet& d : r.droplets) volume += sphere_volume(d.diameter);
    for (std::size_t k = 0; k < r.reaches.size() && !r.droplets.empty(); ++k) {
        const Reach& x = r.reaches[k];
        t.rows.push_back({{r.target_names[k], x.least, x.fastest, x.mean, x.enough, 100 * x.volume / volume}});
    }
    t.notes.emplace_back(
        "Least speed: of the droplet that stands best, to the middle of the surface, without air and in the best "
        "direction. Fast enough: droplets with at least their own least speed, whatever their direction.");
    return t;
}

ReportTable face_table(const SensorStudy& s, const SprayResult& r) {
    ReportTable t{"A small face, hit by one droplet at a time",
                  {numbers("face", "mm2", 4), numbers("droplets that touch it", ""), numbers("chance of one", "%"),
                   numbers("pressure of one, median", "kPa"), numbers("95 % below", "kPa"), numbers("largest", "kPa")}};
    const FaceHits& f = r.face;
    t.rows.push_back(
        {{1e6 * s.face * s.face, f.touches, 100 * f.chance, kilo * f.median, kilo * f.high, kilo * f.largest}});
    t.notes.emplace_back(
        "The droplets on the whole sensor, as if spread evenly over it. One that is wider than the face presses with "
        "1.07 rho V^2, however wide it is: the largest reading of such a face says how fast one droplet is, and not "
        "how much water comes.");
    return t;
}

/// The study's Table 5: its estimates against what was measured.
ReportTable measured_table(const SprayResult& r) {
    const Repeats& m = *r.measured;
    ReportTable t{"Against the measurement",
                  {words("estimate"), numbers("value", "kPa", 4), words("95 % over droplets", "kPa"),
                   words("95 % over droplets and windows", "kPa"), numbers("over measured - 1", "%")}};
    t.rows.push_back(
        {{fmt::format("measured, {} repeats", m.values.size() - m.left_out), kilo * m.kept_mean, "", "", ""}});
    const auto row = [&](const char* name, double Estimate::*value, Interval Intervals::*interval_of) {
        if (!r.peak) {
            t.rows.push_back({{name, 0, "", "", -100}});
            return;
        }
        const Estimate& e = r.peak->estimate;
        ReportRow cells{{name, pressure(e, e.*value), interval(r.peak->droplets.*interval_of),
                         interval(r.over_windows.*interval_of)}};
        if (e.droplets >= Estimate::enough || e.droplets == 0)
            cells.cells.emplace_back(100 * (e.*value / m.kept_mean - 1));
        else
            cells.cells.emplace_back("");
        t.rows.push_back(cells);
    };
    row("average (study)", &Estimate::average, &Intervals::average);
    row("corrected (study)", &Estimate::corrected, &Intervals::corrected);
    row("peak (study)", &Estimate::peak, &Intervals::peak);
    row("direct peak", &Estimate::direct_peak, &Intervals::direct_peak);
    if (!r.peak) t.rows.back().remark = "No droplet reaches the sensor: its load is zero.";
    t.notes.push_back(fmt::format(
        "Measured: mean of all {} repeats {:.4g} kPa, standard deviation {:.3g} kPa (n - 1). The farthest is {:.2f} of "
        "them away; Pauta's criterion leaves out what is farther than 3: {}. Mean of the rest {:.4g} kPa with a "
        "standard error of {:.3g} kPa.",
        m.values.size(), kilo * m.mean, kilo * m.deviation, m.farthest,
        m.left_out == 0 ? std::string("none") : fmt::format("{}", m.left_out), kilo * m.kept_mean, kilo * m.error));
    t.notes.emplace_back("The window is the one in the sensor's middle with the largest average.");
    return t;
}

}  // namespace

std::vector<ReportTable> spray_tables(const SprayStudy& study, const SprayResult& r) {
    std::vector<ReportTable> tables;
    if (!r.extraction.frames.empty()) tables.push_back(ledger_table(study, r));
    tables.push_back(fates_table(r, study.extraction.liquid));
    if (!study.against_name.empty())
        tables.push_back(
            two_sprays({"this one", r.droplets}, {study.against_name, study.against}, study.extraction.liquid));
    if (!r.target_names.empty()) tables.push_back(reach_table(r));
    if (r.measured && !r.peak) tables.push_back(measured_table(r));
    if (!study.sensor || !r.peak) return tables;
    tables.push_back(loads_table("Largest load on the sensor", {*r.peak}, r.arrivals));
    const Intervals& i = r.over_windows;
    tables.back().notes.push_back(fmt::format(
        "Bootstrap over the {} windows of this size on the sensor and over their droplets, 95 %: peak {} kPa, "
        "average {} kPa, corrected {} kPa, direct peak {} kPa.",
        r.tiles, interval(i.peak), interval(i.average), interval(i.corrected), interval(i.direct_peak)));
    tables.push_back(loads_table("Largest load anywhere on the sensor", {*r.anywhere}, r.arrivals));
    tables.back().notes.push_back(
        fmt::format("This window's middle is {:.4g} mm across and {:.4g} mm along from the "
                    "sensor's; see the map of arrivals.",
                    1e3 * r.anywhere->window.across, 1e3 * r.anywhere->window.along));
    tables.push_back(face_table(*study.sensor, r));
    if (r.measured) tables.push_back(measured_table(r));
    tables.push_back(loads_table("Load in time", r.windows, r.arrivals));
    tables.push_back(loads_table("Convergence over the window's area", r.by_area, r.arrivals));
    tables.push_back(loads_table("Convergence over the window's length", r.by_length, r.arrivals));
    return tables;
}

}  // namespace tw::spray
