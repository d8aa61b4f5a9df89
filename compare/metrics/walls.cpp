#include "compare/metrics/walls.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/numbers.h"
#include "compare/metrics/quantity.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"
#include "record/record_numbers.h"
#include "text/plain_number.h"
#include "text/unit_text.h"

namespace tw {
namespace {

const std::string force_prefix = "suction_force_", area_prefix = "suction_area_", angle_prefix = "leaving_angle_";
constexpr double share_that_decides = 0.05;  ///< of the force on the solid: the target of most verdicts

/// Mean of value(row) over the rows in which it is known; NaN without one.
template <class Value>
double mean_of_rows(std::size_t rows, Value value) {
    double sum = 0;
    std::size_t known = 0;
    for (std::size_t i = 0; i < rows; ++i)
        if (const double v = value(i); std::isfinite(v)) sum += v, ++known;
    return known > 0 ? sum / static_cast<double>(known) : nan;
}

double mean_of_samples(const RunRecord& r, const std::string& column) {
    const Column* c = r.series("samples", column);
    return c ? mean_of_rows(c->values.size(), [&](std::size_t i) { return c->values[i]; }) : nan;
}

/// Whether a record's table of forces is that of one solid: a hull, or what stands alone in a tank.
bool forces_are_of(const RunRecord& r, const std::string& name) {
    const auto samples = r.tables.find("samples");
    return name == "hull" ||
           (samples != r.tables.end() && 1 == std::ranges::count_if(samples->second.columns, [](const Column& c) {
                                             return c.name.starts_with("suction_force_");
                                         }));
}

/// Mean of the water's force on a body, on the hull or on an only obstacle, by magnitude.
double mean_force(const RunRecord& r, const std::string& name) {
    const std::string table = r.tables.contains(body_table(name)) ? body_table(name) : "forces";
    if (table == "forces" && !forces_are_of(r, name)) return nan;
    const Column *x = r.series(table, "fx"), *z = r.series(table, "fz");
    if (!x || !z) return nan;
    return mean_of_rows(x->values.size(), [&](std::size_t i) { return std::hypot(x->values[i], z->values[i]); });
}

void warn(Comparison& comparison, std::size_t i, const std::string& name, double pull, const std::string& unit) {
    const std::string walls = text_of(comparison.sources[i], "walls");
    const double force = mean_force(comparison.sources[i], name);
    if (!walls.starts_with("hold") || !(pull > share_that_decides * force)) return;
    comparison.banners.push_back(
        fmt::format("{}: the walls {}. Water is held on {} by suction of {:.3g} {} on average, {:.0f} % of the force "
                    "on it: where air can reach, real water separates there, and the force differs.",
                    method_label(comparison.names[i]), walls, name, pull, unit, 100 * pull / force));
}

/// What follows the prefix in the samples' columns of any source.
std::set<std::string> names_after(const std::string& prefix, const Comparison& comparison) {
    std::set<std::string> names;
    for (const RunRecord& r : comparison.sources)
        if (const auto samples = r.tables.find("samples"); samples != r.tables.end())
            for (const Column& c : samples->second.columns)
                if (c.name.starts_with(prefix)) names.insert(c.name.substr(prefix.size()));
    return names;
}

void add_suction(Comparison& comparison) {
    for (const std::string& name : names_after(force_prefix, comparison)) {
        Quantity q =
            new_quantity("suction:" + name, "Suction on " + name, "",
                         "where the water's pressure is below the air's: sum of -pressure times area, whatever "
                         "the direction; mean over the record");
        std::string areas;
        for (std::size_t i = 0; i < comparison.sources.size(); ++i) {
            const RunRecord& r = comparison.sources[i];
            MeanValue m;
            m.value = mean_of_samples(r, force_prefix + name);
            m.known = std::isfinite(m.value);
            if (m.known) {
                const Table& samples = r.tables.at("samples");
                m.half_width = 0, m.from = samples.time.front(), m.to = samples.time.back();
                q.unit = r.series("samples", force_prefix + name)->unit;
                if (const Column* area = r.series("samples", area_prefix + name))
                    areas += fmt::format("{}{}: on {} {}", areas.empty() ? "" : "; ", method_label(comparison.names[i]),
                                         plain_number(mean_of_samples(r, area_prefix + name)), unit_text(area->unit));
                warn(comparison, i, name, m.value, q.unit);
            } else {
                m.why_not = not_given;
            }
            q.values.push_back(m);
        }
        q.judged = false;
        beside(q);
        q.remark = areas;
        comparison.quantities.push_back(std::move(q));
    }
}

void add_leaving_angles(Comparison& comparison) {
    constexpr double all_round = 150;  // [deg]: a little air in a wake is no line at which water leaves
    for (const std::string& name : names_after(angle_prefix, comparison)) {
        Quantity q =
            new_quantity("leaving_angle:" + name, "Angle at which water leaves " + name, "deg",
                         "from straight down; the area that is wet, as an angle of the faces that look down most "
                         "steeply; mean over the time in which the body is partly wet");
        for (const RunRecord& r : comparison.sources) {
            MeanValue m;
            if (const Column* c = r.series("samples", angle_prefix + name)) {
                const std::vector<double>& angle = c->values;
                m.value = mean_of_rows(
                    angle.size(), [&](std::size_t i) { return angle[i] > 0 && angle[i] < all_round ? angle[i] : nan; });
                m.known = std::isfinite(m.value);
                const Table& samples = r.tables.at("samples");
                m.half_width = 0, m.from = samples.time.front(), m.to = samples.time.back();
                if (!m.known) m.why_not = "it was dry or wet all round";
            } else {
                m.why_not = not_given;
            }
            q.values.push_back(m);
        }
        q.judged = false;
        beside(q);
        comparison.quantities.push_back(std::move(q));
    }
}

}  // namespace

void add_walls(Comparison& comparison) {
    add_suction(comparison);
    add_leaving_angles(comparison);
}

}  // namespace tw
