#include <fmt/format.h>

#include <algorithm>

#include "compare/report/escape.h"
#include "stability/report.h"

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
    static constexpr const char* marks[] = {" ", "!", "X"};
    std::string out;
    for (const StabilityMap& map : maps) {
        const std::string corner = map.y.name + " \\ " + map.x.name;
        const std::size_t first = corner.size();
        out += fmt::format("{}\n{}", map.title, corner);
        for (const double x : map.x.values) out += fmt::format("{:>14g}", x);
        out += "\n";
        for (std::size_t iy = 0; iy < map.y.values.size(); ++iy) {
            out += fmt::format("{:>{}g}", map.y.values[iy], first);
            for (std::size_t ix = 0; ix < map.x.values.size(); ++ix) {
                const StabilityJudgement& j = map.at(ix, iy).judgement;
                out += fmt::format("{:>12} {}", j.label, marks[static_cast<int>(j.stability)]);
            }
            out += "\n";
        }
        for (const MapCell& cell : map.cells)
            if (cell.judgement.stability != Stability::stable)
                out += fmt::format("  {} {}: {}\n", marks[static_cast<int>(cell.judgement.stability)], describe(cell.c),
                                   cell.judgement.reason);
        out += "\n";
    }
    const StabilityCounts n = count(maps);
    out += fmt::format("{} cells stable, {} ran with a warning (!), {} failed (X)\n", n.stable, n.warned, n.failed);
    return for_terminal(out);
}

}  // namespace tw
