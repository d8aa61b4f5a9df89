#include <fmt/format.h>

#include "stability/report.h"
#include "stability/tables.h"

namespace tw {

StabilityCounts count(const std::vector<StabilityMap>& maps) {
    StabilityCounts n;
    for (const StabilityMap& map : maps)
        for (const MapCell& cell : map.cells) {
            if (cell.judgement.stability == Stability::stable) ++n.stable;
            if (cell.judgement.stability == Stability::warned) ++n.warned;
            if (cell.judgement.stability == Stability::failed) ++n.failed;
        }
    return n;
}

std::string stability_text(const std::vector<StabilityMap>& maps) {
    std::string out;
    for (const StabilityMap& map : maps) out += text_of(map_table(map)) + "\n";
    if (const ReportTable unstable = unstable_cells(maps); !unstable.empty()) out += text_of(unstable) + "\n";
    const StabilityCounts n = count(maps);
    return out +
           fmt::format("{} cells stable, {} ran with a warning (!), {} failed (X)\n", n.stable, n.warned, n.failed);
}

}  // namespace tw
