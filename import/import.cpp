#include "import/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "import/readers.h"
#include "text/csv_columns.h"

namespace tw {
namespace {

MomentPoint read_source(const Mapping& mapping, RunRecord& record) {
    if (mapping.kind == "openfoam") return read_openfoam(mapping, record);
    if (mapping.kind == "dualsphysics") return read_dualsphysics(mapping, record);
    return read_csv(mapping, record);
}

/// A series without a single number is a wrong column more often than a result.
void refuse_empty_series(const Mapping& mapping, const RunRecord& record) {
    for (const auto& table : record.tables)
        for (const Column& c : table.second.columns) {
            if (std::ranges::any_of(c.values, [](double v) { return std::isfinite(v); })) continue;
            const auto source = std::ranges::find_if(
                mapping.columns, [&](const ColumnSource& s) { return s.table == table.first && s.name == c.name; });
            throw InputError(fmt::format("{}: {} of {} has no number in any row; expected at least one",
                                         source == mapping.columns.end() ? mapping.source.string() : source->place,
                                         c.name, table.first));
        }
}

/// What the measurement itself is worth, for the verdict against it. A half model's loads are doubled.
void note_uncertainties(const Mapping& mapping, RunRecord& record) {
    for (const ColumnSource& c : mapping.columns)
        if (c.uncertainty > 0)
            record.numbers["uncertainty:" + c.table + ":" + c.name] =
                c.uncertainty * (mapping.half_model && c.table == "forces" ? 2 : 1);
}

/// Rows that are missing in the middle of a table: an interval far longer than those on both sides of it. Intervals
/// that change as a time step does are none.
void note_gaps(RunRecord& record) {
    constexpr double far_longer = 4;
    for (const auto& [name, table] : record.tables) {
        const std::vector<double>& time = table.time;
        for (std::size_t i = 1; i + 2 < time.size(); ++i) {
            const auto interval = [&](std::size_t k) { return time[k + 1] - time[k]; };
            const double usual = std::max(interval(i - 1), interval(i + 1));
            if (!(interval(i) > far_longer * usual)) continue;
            record.attributes["gap:" + name] = fmt::format(
                "no row between {:.6g} and {:.6g} s, where a row every {:.3g} s was expected: about {:.0f} "
                "rows are missing",
                time[i], time[i + 1], usual, interval(i) / usual - 1);
            break;  // the first says enough
        }
    }
}

/// Says whether the drag holds friction where no column tells it.
void note_friction(const Mapping& mapping, RunRecord& record) {
    if (!record.series("forces", "fx") || record.series("forces", "fx_viscous")) return;
    const bool included = mapping.friction.value_or(mapping.kind == "csv");
    record.attributes["friction"] = included ? "included" : "none";
}

}  // namespace

RunRecord import_record(const std::filesystem::path& file) {
    const Mapping mapping = read_mapping(file);
    RunRecord record = blank_record(mapping);
    const MomentPoint point = read_source(mapping, record);
    if (mapping.near_hull) record.numbers["near_hull"] = *mapping.near_hull;
    if (mapping.water) read_water(*mapping.water, record);
    refuse_empty_series(mapping, record);
    refer_moment(mapping, point, record);
    note_friction(mapping, record);
    note_gaps(record);
    note_uncertainties(mapping, record);
    if (mapping.half_model) make_whole(record);
    record.state = "finished";
    return record;
}

}  // namespace tw
