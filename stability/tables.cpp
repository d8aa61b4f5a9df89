#include "stability/tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace tw {

namespace {

Mark mark_of(Stability stability) {
    switch (stability) {
        case Stability::stable: return Mark::good;
        case Stability::warned: return Mark::open;
        case Stability::failed: break;
    }
    return Mark::bad;
}

}  // namespace

ReportTable map_table(const StabilityMap& map) {
    static constexpr const char* marks[] = {"", " !", " X"};
    ReportTable table{map.title, {numbers(map.y.name + " \\ " + map.x.name, "", 6)}};
    for (const double x : map.x.values) table.columns.push_back(numbers(fmt::format("{:g}", x)));
    for (std::size_t iy = 0; iy < map.y.values.size(); ++iy) {
        ReportRow row{{map.y.values[iy]}};
        for (std::size_t ix = 0; ix < map.x.values.size(); ++ix) {
            const StabilityJudgement& j = map.at(ix, iy).judgement;
            row.cells.emplace_back(j.label + marks[static_cast<int>(j.stability)]);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

ReportTable unstable_cells(const std::vector<StabilityMap>& maps) {
    ReportTable table{"What was not stable, and why", {words("Case"), words(""), words("reason")}};
    std::vector<HardCase> told;
    for (const StabilityMap& map : maps)
        for (const MapCell& cell : map.cells) {
            const StabilityJudgement& j = cell.judgement;
            if (j.stability == Stability::stable || std::ranges::find(told, cell.c) != told.end()) continue;
            told.push_back(cell.c);
            table.rows.push_back(
                {{describe(cell.c), ReportCell(to_string(j.stability), mark_of(j.stability)), j.reason}});
        }
    return table;
}

ReportTable limits_of_the_map() {
    ReportTable table{"Validity checks",
                      {words("check"), words("unit"), numbers("warned above"), numbers("failed above"), words("means"),
                       words("reason of the limits")}};
    for (const StabilityLimit& limit : stability_limits())
        table.rows.push_back(
            {{limit.line, limit.unit == "-" ? "" : limit.unit, limit.warned,
              limit.failed < 1e300 ? ReportCell(limit.failed) : ReportCell("–"), limit.meaning, limit.why}});
    return table;
}

}  // namespace tw
