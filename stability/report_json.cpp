#include <cmath>

#include <nlohmann/json.hpp>

#include "record/code_version.h"
#include "stability/report.h"

namespace tw {

namespace {
using Json = nlohmann::ordered_json;

Json number(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }

Json cell_json(const MapCell& cell) {
    const HardCase& c = cell.c;
    Json validity_checks = Json::array();
    for (const RecordedCheck& line : cell.run.lines)
        validity_checks.push_back(
            {{"name", line.name},
             {"unit", line.unit},
             {"value", number(line.value)},
             {"time", number(line.time)},
             {"place", {number(line.place.x()), number(line.place.y()), number(line.place.z())}}});
    return {{"case", to_string(c.kind)},
            {"speed", c.speed},
            {"deadrise_deg", c.deadrise_deg},
            {"h_over_dp", c.h_over_dp},
            {"cfl", c.cfl},
            {"c0_over_speed", c.c0_over_speed},
            {"spacing", 1 / c.spacings_per_m},
            {"zone", c.zone},
            {"stability", to_string(cell.judgement.stability)},
            {"reason", cell.judgement.reason},
            {"label", cell.judgement.label},
            {"steps", cell.run.steps},
            {"particles", cell.run.particles},
            {"time", cell.run.time},
            {"duration", c.duration()},
            {"seconds", cell.run.seconds},
            {"certificate", validity_checks}};
}

}  // namespace

std::string stability_json(const std::vector<StabilityMap>& maps, bool quick) {
    Json limits = Json::array();
    for (const StabilityLimit& limit : stability_limits())
        limits.push_back({{"name", limit.line},
                          {"unit", limit.unit},
                          {"warned", number(limit.warned)},
                          {"failed", number(limit.failed)},
                          {"meaning", limit.meaning},
                          {"why", limit.why}});
    Json list = Json::array();
    for (const StabilityMap& map : maps) {
        Json cells = Json::array();
        for (const MapCell& cell : map.cells) cells.push_back(cell_json(cell));
        list.push_back({{"title", map.title},
                        {"x", {{"name", map.x.name}, {"values", map.x.values}}},
                        {"y", {{"name", map.y.name}, {"values", map.y.values}}},
                        {"cells", cells}});
    }
    const StabilityCounts n = count(maps);
    const Json all = {{"code_version", TWINWAKE_CODE_VERSION},
                      {"quick", quick},
                      {"stable", n.stable},
                      {"warned", n.warned},
                      {"failed", n.failed},
                      {"stated_courant_limit", stated_courant_limit},
                      {"gates", limits},
                      {"maps", list}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tw
