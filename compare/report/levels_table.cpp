#include "compare/report/comparison_tables.h"

#include <algorithm>
#include <cmath>

#include "methods/methods.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double last(const RunRecord& run, const std::string& table, const char* name) {
    const Column* column = run.series(table, name);
    return column && !column->values.empty() ? column->values.back() : unknown;
}

double largest_drift(const RunRecord& run, const std::string& table) {
    double largest = unknown;
    if (const Column* drift = run.series(table, "mass_drift"))
        for (const double d : drift->values) largest = std::fmax(largest, std::abs(d));
    return largest;
}

}  // namespace

ReportTable levels_table(const Comparison& c) {
    ReportTable table{
        "Sizes of particles at the last frame",
        {words("Run"), numbers("size", "m"), numbers("time step", "s"), numbers("active", "", 9),
         numbers("buffer", "", 9), numbers("overlap, slave", "", 9), numbers("split", "", 9), numbers("merged", "", 9),
         numbers("spray", "", 9), numbers("orphans", "", 9), numbers("mass drift", "%", 2), numbers("largest", "%", 2),
         numbers("time", "%", 2), numbers("edge", "%", 2)}};
    for (std::size_t s = 0; s < c.sources.size(); ++s) {
        const RunRecord& run = c.sources[s];
        std::vector<std::string> levels;
        double all_seconds = 0;
        while (run.tables.contains(level_table(levels.size()))) {
            levels.push_back(level_table(levels.size()));
            all_seconds += number_of(run, levels.back() + "_seconds", unknown);
            all_seconds += number_of(run, levels.back() + "_edge_seconds", 0);
        }
        for (const std::string& level : levels) {
            ReportRow row{{run_cell(method_label(c.names[s]), s), last(run, level, "spacing"), last(run, level, "dt"),
                           last(run, level, "active"), last(run, level, "guards"),
                           last(run, level, "band") + last(run, level, "carried")}};
            for (const char* name : {"births", "deaths", "spray", "orphans", "mass_drift"})
                row.cells.emplace_back(last(run, level, name));
            row.cells.emplace_back(largest_drift(run, level));
            for (const char* seconds : {"_seconds", "_edge_seconds"})
                row.cells.emplace_back(100 * number_of(run, level + seconds, unknown) / all_seconds);
            table.rows.push_back(std::move(row));
        }
    }
    if (table.rows.empty()) return {};
    table.notes = {
        "Buffer particles (in the record: guards) carry the fields of the next larger size; overlap and slave "
        "particles (band, carried) those of the next smaller one. Particles made by splitting (births) and removed by "
        "merging (deaths), and the mass drift, are counted since the start. Mass drift: mass of a zone, without spray "
        "beyond it, against that of the larger particles under it.",
        "Spray is active beyond the edge of its zone; orphans are buffer, overlap and slave particles without water of "
        "the other size nearby. The time is that of the pair loops and neighbour lists; at the edge, that of splitting "
        "and of the interpolation of fields to and from the next larger size."};
    return table;
}

}  // namespace tw
