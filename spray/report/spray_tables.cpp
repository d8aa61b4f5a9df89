#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
    row("detached, before the gate", l.before_gate);
    row("beyond it at the frame before", l.earlier);
    row("too large", l.lumps);
    row("too few particles or cells", l.crumbs);
    row("taken", l.taken);
    row("droplets", l.droplets);
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
    ReportTable t{
        "Where the droplets went",
        {words("end"), numbers("droplets", "", 9), numbers("volume", "m3", 6), numbers("mean normal speed", "m/s"),
         numbers("impulse", "N s"), numbers("outside Re > 230, We > 50", "%")}};
    const auto row = [&](const std::string& name, Fate fate, int target) {
        double volume = 0, speed = 0, impulses = 0;
        std::size_t count = 0, outside = 0;
        for (std::size_t i = 0; i < r.landings.size(); ++i) {
            const Landing& l = r.landings[i];
            if (l.fate != fate || (fate == Fate::hit && l.target != target)) continue;
            const double d = r.droplets[i].diameter;
            ++count, volume += sphere_volume(d), speed += l.normal_speed;
            if (fate != Fate::hit) continue;
            impulses += impulse(l.normal_speed, d, liquid);
            outside += !within_law(l.normal_speed, d, liquid);
        }
        ReportRow cells{{name, count, volume}};
        if (fate == Fate::hit && count > 0) {
            const auto n = static_cast<double>(count);
            cells.cells.insert(cells.cells.end(), {speed / n, impulses, 100 * static_cast<double>(outside) / n});
        } else {
            cells.cells.insert(cells.cells.end(), {"", "", ""});
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

/// A pressure, or what an estimate of few droplets is worth.
ReportCell pressure(const Estimate& e, double value) {
    if (e.droplets >= Estimate::enough || e.droplets == 0) return value;
    return std::string("too few");
}
std::string interval(const Interval& i) { return fmt::format("{:.3g} to {:.3g}", i.low, i.high); }

ReportTable loads_table(const std::string& title, const std::vector<WindowLoad>& loads,
                        std::span<const Arrival> arrivals) {
    ReportTable t{title,
                  {numbers("window", "mm2", 4), numbers("from", "s", 6), numbers("length", "ms", 4),
                   numbers("droplets", "", 9), numbers("outside", "%"), numbers("peak", "Pa"), numbers("average", "Pa"),
                   numbers("Monte Carlo", "Pa"), numbers("corrected", "Pa"), numbers("direct mean", "Pa"),
                   numbers("direct peak", "Pa"), words("average, 95 %", "Pa"), words("direct peak, 95 %", "Pa")}};
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

}  // namespace

std::vector<ReportTable> spray_tables(const SprayStudy& study, const SprayResult& r) {
    std::vector<ReportTable> tables;
    if (!r.extraction.frames.empty()) tables.push_back(ledger_table(study, r));
    tables.push_back(fates_table(r, study.extraction.liquid));
    if (!study.sensor || !r.peak) return tables;
    tables.push_back(loads_table("Largest load on the sensor", {*r.peak}, r.arrivals));
    const Intervals& i = r.over_windows;
    tables.back().notes.push_back(fmt::format(
        "Bootstrap over the {} windows of this size on the sensor and over their droplets, 95 %: peak {} Pa, "
        "average {} Pa, corrected {} Pa, direct peak {} Pa.",
        r.tiles, interval(i.peak), interval(i.average), interval(i.corrected), interval(i.direct_peak)));
    tables.push_back(loads_table("Load in time", r.windows, r.arrivals));
    tables.push_back(loads_table("Convergence over the window's area", r.by_area, r.arrivals));
    tables.push_back(loads_table("Convergence over the window's length", r.by_length, r.arrivals));
    return tables;
}

}  // namespace tw::spray
