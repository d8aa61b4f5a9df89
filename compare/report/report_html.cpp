#include "compare/report/report_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "compare/report/comparison_tables.h"
#include "compare/report/drawn_solids.h"
#include "compare/report/escape.h"
#include "compare/report/first_screen.h"
#include "compare/report/page.h"
#include "compare/report/view3d.h"
#include "methods/methods.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

std::string key(std::size_t source) { return fmt::format("<span class=\"key k{}\"></span>", source); }

std::string figure_list(const std::vector<Figure>& figures) {
    if (figures.empty()) return {};
    std::string out = "<div class=\"pair\">";
    for (const Figure& f : figures) out += figure_html(f.plot);
    return out + "</div>";
}

std::string picture_pair(const Comparison& c, const std::vector<std::string>& pngs, const std::string& what) {
    std::string out;
    for (std::size_t s = 0; s < pngs.size(); ++s)
        if (!pngs[s].empty())
            out += fmt::format(
                "<figure><figcaption>{}{}: {}</figcaption><img alt=\"{}, {}\" "
                "src=\"data:image/png;base64,{}\"></figure>",
                key(s), escaped(method_label(c.names[s])), what, what, escaped(method_label(c.names[s])),
                base64(pngs[s]));
    return out.empty() ? out : "<div class=\"pair\">" + out + "</div>";
}

std::string water_section(const Comparison& c, const Figures& f, const std::string& view) {
    std::string out = view;
    if (!f.maps.empty())
        out += std::string(is_stream(c.sources.front()) ? "<h2>Mean elevation seen from above</h2>"
                                                        : "<h2>Elevation of the last frame seen from above</h2>") +
               figure_list(f.maps) + f.elevation_legend;
    const bool any_picture = std::ranges::any_of(f.pictures.free_surface, [](auto& png) { return !png.empty(); });
    if (any_picture || !f.maps.empty())
        out +=
            "<p class=\"note\">Surfaces, on top of the page too, are where the water share of the common raster is one "
            "half, drawn by the same code, from the same place, on the same scale. Half models are mirrored." +
            std::string(
                std::ranges::any_of(
                    c.sources, [](const RunRecord& r) { return r.raster.count[1] > 1 && !bodies_at(r, 0).empty(); })
                    ? " In the pictures of a body that moves in a tank, the nearer half of the water is left out."
                    : "") +
            "</p>";
    const std::string pressures = picture_pair(c, f.pictures.hull_pressure, "pressure on the bottom, seen from below");
    if (!pressures.empty())
        out += "<h2>Pressure on the hull</h2>" + pressures + f.pressure_legend +
               "<p class=\"note\">Last frame; grey: dry or unknown. Stern on the right.</p>";
    if (!f.pictures.note.empty()) out += "<p class=\"note\">" + escaped(f.pictures.note) + "</p>";
    return out;
}

std::string hull_section(const Comparison& c) {
    const RunRecord& r = c.sources.front();
    if (r.hull.triangles.empty()) return {};
    std::string items;
    for (const auto& [name, text] : r.attributes) {
        if (name.starts_with("hull_finding_")) items += "<li>" + escaped(text) + "</li>";
        if (name.starts_with("hull_repair_")) items += "<li>repaired: " + escaped(text) + "</li>";
    }
    return fmt::format(
               "<details class=\"fold\"><summary>The hull</summary><p>{}: {} triangles, {:.4g} m long, {:.4g} m wide, "
               "trim {:.3g}° bow up, draft {:.4g} "
               "m.</p>",
               escaped(text_of(r, "hull_source", "hull")), r.hull.triangles.size(), number_of(r, "length", 0),
               number_of(r, "beam", 0), number_of(r, "trim", 0) * 180 / M_PI, number_of(r, "draft", 0)) +
           (items.empty() ? "<p class=\"note\">Nothing was found wrong with its surface.</p>"
                          : "<ul>" + items + "</ul>") +
           "</details>";
}

std::string resolution_section(const Comparison& c, const Figures& f) {
    if (f.resolution.empty()) return {};
    return "<h2>Resolution</h2><figure>" + f.resolution.front().plot.svg +
           "</figure><p class=\"note\">Sizes of particles and cells: each size applies in its box except where a "
           "smaller box lies "
           "within; "
           "cells along edges and on the hull may be smaller still. Zones of particles are as they were at the end of "
           "the "
           "run.</p>" +
           folded_html(levels_table(c));
}

std::string definitions(const Comparison& c) {
    std::string out = "<details class=\"fold\"><summary>What each quantity means</summary><dl>";
    for (const Quantity& q : c.quantities)
        out += "<dt>" + escaped(q.label) + "</dt><dd>" + escaped(q.definition) + "</dd>";
    return out + "</dl></details>";
}

std::string reproduce(const Comparison& c) {
    const RunRecord& r = c.sources.front();
    const std::string file = text_of(r, "scene_file", "scene.toml");
    std::string commands;  // each once; a record's words are quoted one by one, whatever it says
    for (const RunRecord& source : c.sources) {
        std::istringstream words(text_of(source, "command", ""));
        std::string command;
        for (std::string word; std::getline(words, word);) command += " " + shell_word(word);
        if (!command.empty() && commands.find("twinwake" + command + "\n") == std::string::npos)
            commands += "twinwake" + command + "\n";
    }
    if (commands.empty()) commands = "twinwake run " + shell_file(file) + "\n";
    std::string out = "<h2>How to reproduce it</h2><p>Save the scene below as <code>" + escaped(file) +
                      "</code> beside its hull file, with the code version named above:</p><pre>" + escaped(commands) +
                      "</pre>";
    if (!r.scene_text.empty())
        out += "<details><summary>The scene</summary><pre>" + escaped(r.scene_text) + "</pre></details>";
    return out;
}

/// How a mesh followed its body, and who bends: what each leaves out.
std::string mesh_motion_note(const Comparison& c) {
    std::string out;
    for (std::size_t i = 0; i < c.sources.size(); ++i)
        for (const char* note : {"mesh_motion", "hull_release", "compliance", "one_way"})
            if (const std::string how = text_of(c.sources[i], note); !how.empty())
                out += "<p class=\"note\">" + escaped(method_label(c.names[i]) + ": " + how + ".") + "</p>";
    return out;
}

std::string settling(const Comparison& c) {
    const std::string table = html_of(settling_table(c));
    if (table.empty()) return {};
    return "<details class=\"fold\"><summary>How the settled means were taken</summary><p class=\"note\">The start is "
           "cut by MSER-5; "
           "the 95 % interval is Student's t with the number of independent samples from the autocorrelation time; "
           "overlapping batch means are the second opinion.</p>" +
           table + "</details>";
}

}  // namespace

std::string report_html(const Comparison& c, const Figures& f, const std::string& details) {
    const std::string title = text_of(c.sources.front(), "title", "twinwake comparison");
    const std::string view = *view3d_script ? view3d_section(c) : std::string();
    std::string sources;
    for (const char* script : {plots_script, view.empty() ? "" : view3d_script})
        if (*script) sources += (sources.empty() ? "" : " ") + script_source(script);
    std::string out = page_begin(title, view.empty() ? "" : view3d_style, sources);
    out += first_screen(c, f);
    if (!f.forces.empty())
        out += "<h2>Forces over time</h2>" + figure_list(f.forces) +
               "<p class=\"note\">Pale: the raw trace, from which the means are taken. Bars: the settled mean with its "
               "interval, over the window it was taken from.</p>";
    if (!f.bodies.empty()) out += "<h2>Bodies that move</h2>" + figure_list(f.bodies) + mesh_motion_note(c);
    if (!f.probes.empty()) out += "<h2>Probes</h2>" + figure_list(f.probes);
    out += water_section(c, f, view);
    if (!f.splash.empty() || !f.splash_not_drawn.empty())
        out += "<h2>Splash</h2>" + figure_list(f.splash) +
               (f.splash_not_drawn.empty() ? ""
                                           : "<p class=\"note\">Height and amount of the spray are not drawn: " +
                                                 escaped(f.splash_not_drawn) + ".</p>");
    if (!f.wetting.empty() || !f.cuts.empty())
        out += "<h2>Wetted length and free surface</h2>" + figure_list(f.wetting) + figure_list(f.cuts);
    out += details + resolution_section(c, f) + "<h2>All numbers</h2>";
    for (const ReportTable& table : {quantities_table(c, true), left_out_table(c), quantities_table(c, false)})
        out += folded_html(table);
    out += settling(c) + folded_html(checks_table(c.checks, false)) + folded_html(effects_table(c)) + hull_section(c) +
           folded_html(cost_table(c)) + folded_html(provenance_table(c)) + definitions(c) + reproduce(c);
    return out + (*plots_script ? std::string("<script>") + plots_script + "</script>" : "") + page_end;
}

}  // namespace tw
