#include "compare/metrics/gauges.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/metrics/quantity.h"
#include "record/record_numbers.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"

namespace tw {
namespace {

bool is_gauge(const Column& c) {
    return c.unit == "-" && c.name != "q0" && c.name != "qx" && c.name != "qy" && c.name != "qz";
}

MeanValue peak_of(const RunRecord& r, const std::string& table, const std::string& gauge, double end) {
    MeanValue m;
    const Column* c = r.series(table, gauge);
    m.why_not = not_given;
    if (!c) return m;
    const std::vector<double>& time = r.tables.at(table).time;
    for (std::size_t k = 0; k < time.size() && time[k] <= end * (1 + 1e-9); ++k)
        if (std::isfinite(c->values[k]) && !(std::abs(c->values[k]) <= std::abs(m.value))) m.value = c->values[k];
    m.known = std::isfinite(m.value);
    if (!m.known) return m;
    m.why_not.clear();
    m.half_width = 0, m.from = time.front(), m.to = end;
    return m;
}

/// "SPH: elastic; interFoam: rigid", or nothing where all are alike.
std::string unlike_structures(const Comparison& c) {
    std::set<std::string> kinds;
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < c.sources.size(); ++i) {
        const std::string kind = text_of(c.sources[i], "structure");
        if (kind.empty()) continue;
        kinds.insert(kind);
        parts.push_back(fmt::format("{}: {}", method_label(c.names[i]), kind));
    }
    return kinds.size() < 2 ? std::string() : fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

void add_gauges(Comparison& comparison) {
    std::set<std::string> tables;
    for (const RunRecord& r : comparison.sources)
        for (const auto& [name, table] : r.tables)
            if (name.starts_with("body_") && std::ranges::any_of(table.columns, is_gauge)) tables.insert(name);
    for (const std::string& table : tables) {
        std::set<std::string> gauges;
        double end = HUGE_VAL;
        for (const RunRecord& r : comparison.sources) {
            const auto found = r.tables.find(table);
            if (found == r.tables.end() || found->second.time.empty()) continue;
            end = std::min(end, found->second.time.back());
            for (const Column& c : found->second.columns)
                if (is_gauge(c)) gauges.insert(c.name);
        }
        const std::string body = table.substr(5);
        for (const std::string& gauge : gauges) {
            Quantity q =
                new_quantity("strain_peak:" + body + ":" + gauge, fmt::format("Largest strain {} of {}", gauge, body),
                             "-", "the largest by magnitude, with its sign");
            for (const RunRecord& r : comparison.sources) q.values.push_back(peak_of(r, table, gauge, end));
            beside(q);
            q.judged_in_ladder = true;
            comparison.quantities.push_back(std::move(q));
        }
    }
    const std::string unlike = unlike_structures(comparison);
    if (unlike.empty()) return;
    const std::string contained = "the difference contains the compliance";
    comparison.banners.push_back(
        fmt::format("The plate bends in the water in one run and not in the other ({}): of its forces, its motion and "
                    "its strains {}.",
                    unlike, contained));
    for (Quantity& q : comparison.quantities)
        if (q.name.starts_with("body_") || q.name.starts_with("strain_peak:")) q.caveat = contained;
}

}  // namespace tw
