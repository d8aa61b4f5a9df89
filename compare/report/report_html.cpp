#include "compare/report/report_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "compare/metrics/splash.h"
#include "compare/read/record_numbers.h"
#include "compare/report/base64.h"
#include "compare/report/comparison_tables.h"
#include "compare/report/drawn_bodies.h"
#include "compare/report/escape.h"
#include "compare/report/levels_table.h"
#include "compare/report/numbers.h"
#include "compare/report/page.h"
#include "compare/report/view3d.h"

namespace tw {

namespace {

std::string key(std::size_t source) { return fmt::format("<span class=\"key k{}\"></span>", source); }

std::string figure_list(const std::vector<Figure>& figures) {
    if (figures.empty()) return {};
    std::string out = "<div class=\"pair\">";
    for (const Figure& f : figures) out += "<figure>" + f.svg + "</figure>";
    return out + "</div>";
}

std::string picture_pair(const Comparison& c, const std::vector<std::string>& pngs, const std::string& what) {
    std::string out;
    for (std::size_t s = 0; s < pngs.size(); ++s)
        if (!pngs[s].empty())
            out += fmt::format(
                "<figure><figcaption>{}{}: {}</figcaption><img alt=\"{}, {}\" "
                "src=\"data:image/png;base64,{}\"></figure>",
                key(s), escaped(c.names[s]), what, what, escaped(c.names[s]), base64(pngs[s]));
    return out.empty() ? out : "<div class=\"pair\">" + out + "</div>";
}

std::string free_surfaces(const Comparison& c, const Figures& f, const std::string& view) {
    std::string out;
    const std::string pictures = picture_pair(c, f.pictures.free_surface, "free surface of the last frame");
    if (!pictures.empty() || !f.maps.empty()) {
        out +=
            "<h2>The water</h2><p class=\"note\">Surfaces are where the water share of the common raster is one half, "
            "drawn by the same code, from "
            "the same place, on the same scale. Half models are mirrored." +
            std::string(
                std::ranges::any_of(
                    c.sources, [](const RunRecord& r) { return r.raster.count[1] > 1 && !bodies_at(r, 0).empty(); })
                    ? " Where a body moves in a tank, the nearer half of the water is left out."
                    : "") +
            "</p>" + pictures;
        if (!f.maps.empty()) {
            out += std::string(is_stream(c.sources.front()) ? "<h3>Mean elevation seen from above</h3>"
                                                            : "<h3>Elevation of the last frame seen from above</h3>") +
                   figure_list(f.maps);
        }
        out += f.elevation_legend;
    }
    out += view;
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
               "<h2>The hull</h2><p>{}: {} triangles, {:.4g} m long, {:.4g} m wide, trim {:.3g}° bow up, draft {:.4g} "
               "m.</p>",
               escaped(text_of(r, "hull_source", "hull")), r.hull.triangles.size(), number_of(r, "length", 0),
               number_of(r, "beam", 0), number_of(r, "trim", 0) * 180 / M_PI, number_of(r, "draft", 0)) +
           (items.empty() ? "<p class=\"note\">Nothing was found wrong with its surface.</p>"
                          : "<ul>" + items + "</ul>");
}

std::string resolution_section(const Comparison& c, const Figures& f) {
    if (f.resolution.empty()) return {};
    return "<h2>Resolution</h2><figure>" + f.resolution.front().svg +
           "</figure><p class=\"note\">Sizes of particles and cells: each size applies in its box except where a "
           "smaller box lies "
           "within; "
           "cells along edges and on the hull may be smaller still. Zones of particles are as they were at the end of "
           "the "
           "run.</p>" +
           html_of(levels_table(c), 3);
}

std::string definitions(const Comparison& c) {
    std::string out = "<details open><summary>What each quantity means</summary><dl>";
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
        for (const char* note : {"mesh_motion", "compliance", "one_way"})
            if (const std::string how = text_of(c.sources[i], note); !how.empty())
                out += "<p class=\"note\">" + escaped(c.names[i] + ": " + how + ".") + "</p>";
    return out;
}

std::string settling(const Comparison& c) {
    const std::string table = html_of(settling_table(c));
    if (table.empty()) return {};
    return "<details><summary>How the settled means were taken</summary><p class=\"note\">The start is cut by MSER-5; "
           "the 95 % interval is Student's t with the number of independent samples from the autocorrelation time; "
           "overlapping batch means are the second opinion.</p>" +
           table + "</details>";
}

}  // namespace

std::string report_html(const Comparison& c, const Figures& f, const std::string& details) {
    const RunRecord& first = c.sources.front();
    const std::string title = text_of(first, "title", "twinwake comparison");
    std::string sub;
    for (std::size_t s = 0; s < c.names.size(); ++s)
        sub += (s ? " · " : "") + key(s) + escaped(c.names[s]) +
               (c.sources[s].state == "finished" ? "" : " (" + escaped(c.sources[s].state) + ")");
    if (const double speed = number_of(first, "speed", 0); speed > 0) {
        sub += fmt::format(" · {:.4g} m/s", speed);
        const double length = number_of(first, "length", 0), g = number_of(first, "gravity", 9.81);
        if (length > 0 && g > 0) sub += fmt::format(" · Froude number {:.3g}", speed / std::sqrt(g * length));
    }
    if (const double spacing = number_of(first, "near_hull", 0); spacing > 0)
        sub += fmt::format(" · spacing at the hull {:.3g} m", spacing);

    const std::string view = view3d_section(c);
    std::string out =
        view.empty() ? page_begin(title) : page_begin(title, view3d_style, "'" + view3d_script_hash() + "'");
    out += "<h1>" + escaped(title) + "</h1><p class=\"sub\">" + sub + "</p>";
    std::string verdict;
    for (const std::string& sentence : verdict_sentences(c))
        verdict += (verdict.empty() ? "" : "<br>") + escaped(sentence);
    out += "<div class=\"verdict\">" + verdict + "</div>";
    for (const std::string& b : c.banners) out += "<div class=\"banner\">" + escaped(b) + "</div>";

    out += html_of(quantities_table(c, true)) + settling(c) + details;
    out += free_surfaces(c, f, view);
    if (!f.forces.empty())
        out += "<h2>Forces over time</h2>" + figure_list(f.forces) +
               "<p class=\"note\">Pale: the raw trace, from which the means are taken. Bars: the settled mean with its "
               "interval, over the window it was taken from.</p>";
    if (!f.splash.empty()) out += "<h2>Splash</h2>" + figure_list(f.splash);
    if (!f.wetting.empty() || !f.cuts.empty())
        out += "<h2>Wetted length and free surface</h2>" + figure_list(f.wetting) + figure_list(f.cuts);
    if (!f.bodies.empty()) out += "<h2>Bodies that move</h2>" + figure_list(f.bodies) + mesh_motion_note(c);
    if (!f.probes.empty()) out += "<h2>Probes</h2>" + figure_list(f.probes);
    out += html_of(quantities_table(c, false)) + html_of(checks_table(c.gates, false)) + html_of(effects_table(c)) +
           hull_section(c) + resolution_section(c, f) + html_of(cost_table(c)) + html_of(provenance_table(c)) +
           "<h2>Definitions</h2>" + definitions(c) + reproduce(c);
    return out + page_end;
}

}  // namespace tw
