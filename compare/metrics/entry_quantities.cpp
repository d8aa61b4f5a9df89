#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "compare/metrics/entry.h"
#include "compare/metrics/quantity.h"
#include "compare/verdict/judge.h"

namespace tw {
namespace {

/// What a body did in one record.
struct Entry {
    const Table* series = nullptr;  ///< null: the record has no frames of it
    CavityClosure closure;
    double voxel = 0, half_step = NAN;  ///< [m], [s]

    /// Row of the largest value of a column.
    std::size_t at_largest(const char* column) const {
        const auto& values = series->find(column)->values;
        return static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
    }
    double largest(const char* column) const { return series->find(column)->values[at_largest(column)]; }
    double time_of_largest(const char* column) const { return series->time[at_largest(column)]; }
    bool shows_something() const {
        return series && (closure.deepest > 2 * voxel || largest("crown_height") > 2 * voxel);
    }
};

Entry entry_of(const Comparison& c, std::size_t source, const std::string& name) {
    Entry e;
    e.voxel = c.sources[source].raster.voxel;
    const auto& all = c.analyses[source].entries;
    const auto found = std::ranges::find(all, "entry_" + name, &Table::name);
    if (found == all.end() || found->time.empty()) return e;
    e.series = &*found;
    e.closure = closure_of(*e.series, e.voxel);
    if (e.series->time.size() > 1)
        e.half_step =
            (e.series->time.back() - e.series->time.front()) / (2 * static_cast<double>(e.series->time.size() - 1));
    return e;
}

/// Difference of the water lines on the two sides, of the row where it is largest; NaN where no row has both.
double asymmetry(const Entry& e) {
    const auto &low = e.series->find("waterline_low_x")->values, &high = e.series->find("waterline_high_x")->values;
    double most = NAN;
    for (std::size_t k = 0; k < low.size(); ++k)
        if (const double d = low[k] - high[k]; std::isfinite(d) && !(std::abs(most) >= std::abs(d))) most = d;
    return most;
}

void add_of_body(Comparison& c, const std::string& name, const std::vector<Entry>& entries) {
    const auto add = [&](const char* kind, const std::string& label, const std::string& unit,
                         const std::string& definition, const std::string& why_not,
                         const std::function<double(const Entry&)>& value,
                         const std::function<double(const Entry&)>& half_width) {
        Quantity q = new_quantity(fmt::format("{}:{}", kind, name), label + name, unit, definition);
        for (const Entry& e : entries) {
            MeanValue m;
            if (e.series) m.value = value(e);
            m.known = std::isfinite(m.value);
            if (m.known) {
                m.half_width = half_width(e);
                m.from = e.series->time.front(), m.to = e.series->time.back();
                m.limited_by = unit == "s" ? "the interval between frames" : "the raster";
            } else {
                m.why_not = e.series ? why_not : "no raster frames of the body";
            }
            q.values.push_back(m);
        }
        beside(q);
        q.judged_in_grid_study = true;
        c.quantities.push_back(std::move(q));
    };
    const auto of_frames = [](const Entry& e) { return e.half_step; };
    const auto of_closure = [](const Entry& e) { return e.closure.half_step; };
    const auto half_voxel = [](const Entry& e) { return e.voxel / 2; };
    const std::string m3 = [&] {
        for (const Entry& e : entries)
            if (e.series) return e.series->find("crown_volume")->unit;
        return std::string();
    }();
    add(
        "cavity_seal", "Cavity sealed behind ", "s",
        "first frame in which the air at the body is no longer connected to the air above the water; gaps narrower "
        "than "
        "a voxel are not seen",
        "no closed air was seen", [](const Entry& e) { return e.closure.seal; }, of_closure);
    add(
        "cavity_seal_depth", "Depth of the seal behind ", "m",
        "of the top of that closed air below still water; negative: a dome above it", "no closed air was seen",
        [](const Entry& e) { return e.closure.seal_depth; }, [](const Entry& e) { return e.voxel; });
    add(
        "cavity_closure", "Cavity closed round ", "s",
        "after it was deepest, the first frame in which no open air beside the body lies deeper than a voxel below "
        "still "
        "water",
        "it is open at the end, or none opened by more than two voxels",
        [](const Entry& e) { return e.closure.closed; }, of_closure);
    add(
        "cavity_depth", "Deepest open cavity at ", "m", "of air beside the body that is connected to the air above",
        "no frames", [](const Entry& e) { return e.closure.deepest; }, half_voxel);
    add("cavity_asymmetry", "Water line, low x less high x, at ", "m",
        "highest water beside the body on the side of smaller x less that on the other, in its middle plane, where the "
        "two are farthest apart",
        "no frame has water on both sides", asymmetry, [](const Entry& e) { return e.voxel; });
    add(
        "crown_height", "Height of the crown of ", "m", "highest water of the main body above still water", "no frames",
        [](const Entry& e) { return e.largest("crown_height"); }, half_voxel);
    add(
        "crown_time", "The crown is highest, ", "s", "time of that height", "no frames",
        [](const Entry& e) { return e.time_of_largest("crown_height"); }, of_frames);
    add(
        "crown_volume", "Water above still water, ", m3,
        "largest volume of water more than a surface cell above still water", "no frames",
        [](const Entry& e) { return e.largest("crown_volume"); }, [](const Entry&) { return 0.0; });
    add(
        "crown_volume_time", "Most water is up, ", "s", "time of that volume", "no frames",
        [](const Entry& e) { return e.time_of_largest("crown_volume"); }, of_frames);
}

}  // namespace

void add_entries(Comparison& c) {
    std::set<std::string> names;
    for (const Analysis& a : c.analyses)
        for (const Table& t : a.entries) names.insert(t.name.substr(t.name.find('_') + 1));
    for (const std::string& name : names) {
        std::vector<Entry> entries;
        for (std::size_t s = 0; s < c.sources.size(); ++s) entries.push_back(entry_of(c, s, name));
        if (std::ranges::any_of(entries, &Entry::shows_something)) add_of_body(c, name, entries);
    }
}

}  // namespace tw
