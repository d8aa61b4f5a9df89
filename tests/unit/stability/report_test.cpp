#include "stability/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "stability/heat_map.h"

namespace tw {
namespace report_test {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

/// Two by one cells: one stable, one that failed with a message that would be markup.
std::vector<StabilityMap> two_cells() {
    StabilityMap map;
    map.title = "a <map> & its \"title\"";
    map.x = {"speed U [m/s]", &HardCase::speed, {8, 80}};
    map.y = {"h/dp", &HardCase::h_over_dp, {1.5}};
    map.cells.resize(2);
    map.cells[0].c.speed = 8, map.cells[1].c.speed = 80;
    map.cells[0].run.steps = 10;
    map.cells[0].run.lines = {{"Mach number", "-", 0.1}};
    map.cells[1].run.failure = "</title><script>alert(1)</script>\x1b[31m";
    for (MapCell& cell : map.cells) cell.judgement = judge_stability(cell.c, cell.run);
    return {map};
}

TEST(StabilityReport, IsMarkupOfItsOwnOnly) {
    for (const std::string& page : {stability_html(two_cells(), false), stability_svg(two_cells())}) {
        EXPECT_EQ(page.find("<script"), std::string::npos);
        EXPECT_EQ(page.find("<map>"), std::string::npos);
        EXPECT_EQ(page.find('\x1b'), std::string::npos);
        EXPECT_NE(page.find("&lt;script&gt;alert(1)"), std::string::npos);
        EXPECT_EQ(count(page, "<svg"), count(page, "</svg>"));
        EXPECT_EQ(count(page, "<g"), count(page, "</g>"));
        // nothing is loaded from anywhere
        EXPECT_EQ(page.find("href=\"http"), std::string::npos);
        EXPECT_EQ(page.find("src="), std::string::npos);
    }
    EXPECT_EQ(stability_text(two_cells()).find('\x1b'), std::string::npos);
}

TEST(StabilityReport, AMapHasAColouredCellForEachPairOfValues) {
    const std::string svg = heat_map(two_cells().front()).svg;
    EXPECT_EQ(count(svg, colour_of(Stability::stable)), 1u);
    EXPECT_EQ(count(svg, colour_of(Stability::failed)), 1u);
    EXPECT_EQ(count(svg, colour_of(Stability::warned)), 0u);
    EXPECT_NE(svg.find(">80<"), std::string::npos);
    EXPECT_NE(svg.find(">Ma 0.1<"), std::string::npos);
}

TEST(StabilityReport, ProgramsGetEveryCellWithItsValidityChecks) {
    const auto json = nlohmann::json::parse(stability_json(two_cells(), true));
    EXPECT_EQ(json["stable"], 1);
    EXPECT_EQ(json["failed"], 1);
    EXPECT_EQ(json["quick"], true);
    const auto& cells = json["maps"][0]["cells"];
    ASSERT_EQ(cells.size(), 2u);
    EXPECT_EQ(cells[0]["stability"], "stable");
    EXPECT_EQ(cells[0]["certificate"][0]["value"], 0.1);
    EXPECT_EQ(cells[1]["speed"], 80);
    EXPECT_EQ(json["gates"].size(), stability_limits().size());
}

TEST(StabilityMaps, HoldTheWholeRangeAndEachCellIsACase) {
    double slowest = 1e9, fastest = 0, longest_step = 0;
    for (const StabilityMap& map : stability_maps(false)) {
        ASSERT_EQ(map.cells.size(), map.x.values.size() * map.y.values.size()) << map.title;
        for (std::size_t iy = 0; iy < map.y.values.size(); ++iy)
            for (std::size_t ix = 0; ix < map.x.values.size(); ++ix) {
                const HardCase& c = map.at(ix, iy).c;
                EXPECT_EQ(c.*map.x.number, map.x.values[ix]);
                EXPECT_EQ(c.*map.y.number, map.y.values[iy]);
                EXPECT_GT(c.predicted_work(), 0);
                if (c.kind == HardCaseKind::tank) continue;
                slowest = std::min(slowest, c.speed), fastest = std::max(fastest, c.speed);
                longest_step = std::max(longest_step, c.cfl);
            }
    }
    EXPECT_EQ(slowest, 8);
    EXPECT_EQ(fastest, 80);
    EXPECT_GT(longest_step, stated_courant_limit);
}

TEST(StabilityMaps, EqualCasesAreRunOnceAndAStopIsHeeded) {
    HardCase c;
    c.spacings_per_m = 10, c.c0_over_speed = 4, c.deadrise_deg = 45;
    StabilityMap map{
        "m", c, {"speed", &HardCase::speed, {30}}, {"h/dp", &HardCase::h_over_dp, {1.5}}, {MapCell{c, {}, {}}}};
    std::vector<StabilityMap> maps{map, map};
    MapProgress last;
    EXPECT_TRUE(run_stability_maps(maps, 2, [&](const MapProgress& p) { last = p; }, {}));
    EXPECT_EQ(last.all, 1u);
    EXPECT_EQ(last.done, 1u);
    EXPECT_DOUBLE_EQ(last.share, 1);
    for (const StabilityMap& m : maps) EXPECT_NE(m.cells[0].judgement.label, "");
    EXPECT_EQ(maps[0].cells[0].run.steps, maps[1].cells[0].run.steps);
    EXPECT_FALSE(run_stability_maps(maps, 1, {}, [] { return true; }));
}

}  // namespace report_test
}  // namespace tw
