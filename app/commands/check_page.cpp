#include "app/commands/check_page.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "app/runs/solvers.h"
#include "compare/report/page.h"
#include "compare/report/report_table.h"
#include "compare/report/resolution_picture.h"
#include "methods/methods.h"
#include "record/influence_words.h"
#include "scene/new_record.h"
#include "scene/water/water_blocks.h"

namespace tw::app {
namespace {

/// Lines of the text that ask for a look, with those that go on from them.
ReportTable warnings_in(const std::string& text) {
    constexpr std::array<std::string_view, 4> begins{"  warning", "  note", "  spray jet", "! "};
    constexpr std::string_view goes_on = "            ";
    ReportTable table{"To be looked at first", {words("what")}};
    bool taken = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (taken && line.starts_with(goes_on)) {
            table.rows.back().cells.front().text += line.substr(goes_on.size() - 1);
            continue;
        }
        taken = std::ranges::any_of(begins, [&](std::string_view word) { return line.starts_with(word); });
        if (taken) table.rows.push_back({{line.substr(line.find_first_not_of(" !"))}});
    }
    return table;
}

ReportTable effects_of(const Scene& scene) {
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    ReportTable table{"Effects", {words("effect"), words("is"), words("why"), words("influence")}};
    for (const EffectChoice& e : scene.effects)
        table.rows.push_back({{e.name,
                               {e.on ? "on" : "off", e.on ? Mark::good : Mark::faint},
                               e.forced ? "as requested: " + e.reason : e.reason,
                               influence_in_words(e.influence, stream)}});
    return table;
}

/// All obstacles and bodies, where they stand at the start.
Surface solids_of(const Scene& scene) {
    Surface all;
    const auto add = [&](const Surface& solid) {
        const int first = static_cast<int>(all.points.size());
        all.points.insert(all.points.end(), solid.points.begin(), solid.points.end());
        for (auto triangle : solid.triangles) {
            for (int& corner : triangle) corner += first;
            all.triangles.push_back(triangle);
        }
    };
    for (const Obstacle& o : scene.obstacles) add(o.surface);
    for (const MovingBody& b : scene.bodies) add(b.surface);
    return all;
}

}  // namespace

std::string scene_picture(const Scene& scene) {
    std::vector<RunRecord> runs;
    std::vector<std::string> names;
    for (const std::string& method : scene.run.methods) {
        runs.push_back(new_record(scene, method));
        names.push_back(elements_of(method) + " (" + method + ")");
    }
    if (!scene.hull)
        for (RunRecord& run : runs) run.hull = solids_of(scene);
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    return domain_picture(runs, names, stream ? std::vector<Box>{} : blocks_of_water(scene));
}

std::string check_page(const Scene& scene, const std::string& text) {
    return page_begin(scene.title + ": before it is run") + "<h1>" + escaped(scene.title) +
           "</h1><p class=\"sub\">What would be solved. Nothing has been run.</p>" + html_of(warnings_in(text)) +
           "<h2>Hull, water, domain and sizes</h2>" + scene_picture(scene) + html_of(effects_of(scene)) +
           "<h2>All that was checked</h2><pre>" + escaped(text) + "</pre>" + page_end;
}

}  // namespace tw::app
