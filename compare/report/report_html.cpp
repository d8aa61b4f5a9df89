#include "compare/report/report_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "compare/metrics/splash.h"
#include "compare/read/record_numbers.h"
#include "compare/report/base64.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/page.h"
#include "compare/report/view3d.h"

namespace tw {

namespace {

std::string key(std::size_t source) { return fmt::format("<span class=\"key k{}\"></span>", source); }

std::string source_heads(const Comparison& c) {
    std::string out;
    for (std::size_t s = 0; s < c.names.size(); ++s)
        out += fmt::format("<th class=\"num\">{}{}</th>", key(s), escaped(c.names[s]));
    return out;
}

std::string quantity_rows(const Comparison& c, const Quantity& q) {
    const bool pair = c.sources.size() > 1;
    const std::size_t columns = 1 + c.sources.size() + (pair ? (q.judged ? 3u : 2u) : 0u);
    std::string out = fmt::format("<tr{}><td>{} <span class=\"note\">[{}]</span></td>",
                                  q.remark.empty() ? "" : " class=\"has-remark\"", escaped(q.label), escaped(q.unit));
    for (const MeanValue& m : q.values)
        out += m.known ? fmt::format("<td class=\"num\">{}</td>", mean_text(m))
                       : fmt::format("<td class=\"num\" title=\"{}\">–</td>", escaped(m.why_not));
    if (pair) {
        out += fmt::format("<td class=\"num\">{}</td><td class=\"num\">{}</td>", signed_text(q.difference, q.interval),
                           per_cent_text(q.per_cent));
        if (q.judged)
            out += fmt::format("<td><span class=\"badge {}\">{}</span></td>", to_string(q.verdict),
                               verdict_label(q.verdict));
    }
    out += "</tr>";
    if (!q.remark.empty())
        out += fmt::format("<tr class=\"remark\"><td colspan=\"{}\">{}</td></tr>", columns, escaped(q.remark));
    for (const Reference& r : c.references)
        if (r.quantity == q.name)
            out += fmt::format(
                "<tr class=\"ref\"><td>{} beside it</td><td class=\"num\">{}</td><td colspan=\"{}\">{}</td></tr>",
                escaped(r.source), value_text(r.value, r.half_width), columns - 2, escaped(r.remark));
    return out;
}

std::string quantity_table(const Comparison& c, bool judged) {
    std::string rows;
    for (const Quantity& q : c.quantities)
        if (q.judged == judged) rows += quantity_rows(c, q);
    if (rows.empty()) return {};
    std::string head = "<th>Quantity</th>" + source_heads(c);
    if (c.sources.size() > 1) {
        head += fmt::format(
            "<th class=\"num\">{}</th><th class=\"num\">relative</th>",
            c.sources.size() == 2 ? escaped(c.names[1]) + " − " + escaped(c.names[0]) : std::string("difference"));
        if (judged) head += "<th>verdict</th>";
    }
    return "<div class=\"wide\"><table><thead><tr>" + head + "</tr></thead><tbody>" + rows + "</tbody></table></div>";
}

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
            "the same place, on the same scale. Half models are mirrored.</p>" +
            pictures;
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

std::string gates_table(const Comparison& c) {
    if (c.gates.empty()) return {};
    std::string out =
        "<h2>Soundness of the runs</h2><div class=\"wide\"><table><thead><tr><th>Check</th><th>run</th><th "
        "class=\"num\">value</th><th class=\"num\">limit</th>"
        "<th></th><th></th></tr></thead><tbody>";
    for (const Gate& g : c.gates)
        out += fmt::format(
            "<tr><td>{}</td><td>{}</td><td class=\"num\">{:.3g} {}</td><td class=\"num\">{:.3g}</td><td><span "
            "class=\"badge {}\">{}</span></td><td class=\"note\">{}</td></tr>",
            escaped(g.name), escaped(g.source), g.value, g.unit == "-" ? "" : escaped(g.unit), g.limit,
            g.pass ? "agree" : "differ", g.pass ? "met" : "not met", escaped(g.remark));
    return out + "</tbody></table></div>";
}

std::string certificates(const Comparison& c) {
    std::string rows;
    for (std::size_t s = 0; s < c.sources.size(); ++s)
        for (const CertificateLine& l : c.sources[s].certificate)
            rows += fmt::format(
                "<tr><td>{}{}</td><td>{}</td><td class=\"num\">{:.3g} {}</td><td class=\"num\">{:.3g}</td><td "
                "class=\"num\">{:.4g} s</td><td>{}</td><td><span class=\"badge {}\">{}</span></td></tr>",
                key(s), escaped(c.names[s]), escaped(l.name), l.value, l.unit == "-" ? "" : escaped(l.unit), l.limit,
                l.time,
                l.place.allFinite() ? fmt::format("({:.3g}, {:.3g}, {:.3g}) m", l.place.x(), l.place.y(), l.place.z())
                                    : std::string("–"),
                l.met() ? "agree" : "differ", l.met() ? "met" : "not met");
    if (rows.empty()) return {};
    return "<h2>Stability certificates</h2><div class=\"wide\"><table><thead><tr><th>run</th><th>what has to stay "
           "bounded</th><th class=\"num\">worst</th><th class=\"num\">limit</th><th class=\"num\">when</th><th>where</"
           "th><th></th></tr></thead><tbody>" +
           rows +
           "</tbody></table></div><p class=\"note\">Worst values of the whole run, start-up and resumed parts "
           "included.</p>";
}

std::string effects_table(const Comparison& c) {
    const auto with = std::ranges::find_if(c.sources, [](const RunRecord& r) { return !r.effects.empty(); });
    if (with == c.sources.end()) return {};
    std::string out =
        "<h2>Effects solved and left out</h2><div "
        "class=\"wide\"><table><thead><tr><th>Effect</th><th>solved</th><th>why</th><th>thought to "
        "change</th><th>costs, or would cost</th></tr></thead><tbody>";
    for (const EffectChoice& e : with->effects)
        out += fmt::format("<tr><td>{}</td><td>{}{}</td><td>{}</td><td>{}</td><td>{}</td></tr>", escaped(e.name),
                           e.on ? "yes" : "no", e.forced ? " (asked for)" : "", escaped(e.reason), escaped(e.influence),
                           e.cost > 0 ? fmt::format("{:.0f} % of a particle run", 100 * e.cost) : "");
    return out + "</tbody></table></div>";
}

std::string hull_section(const Comparison& c) {
    const RunRecord& r = c.sources.front();
    if (r.hull.triangles.empty()) return {};
    std::string items;
    for (const auto& [name, text] : r.attributes) {
        if (name.starts_with("hull_finding_")) items += "<li>" + escaped(text) + "</li>";
        if (name.starts_with("hull_repair_")) items += "<li>mended: " + escaped(text) + "</li>";
    }
    return fmt::format(
               "<h2>The hull</h2><p>{}: {} triangles, {:.4g} m long, {:.4g} m wide, trim {:.3g}° bow up, draft {:.4g} "
               "m.</p>",
               escaped(text_of(r, "hull_source", "hull")), r.hull.triangles.size(), number_of(r, "length", 0),
               number_of(r, "beam", 0), number_of(r, "trim", 0) * 180 / M_PI, number_of(r, "draft", 0)) +
           (items.empty() ? "<p class=\"note\">Nothing was found wrong with its surface.</p>"
                          : "<ul>" + items + "</ul>");
}

std::string cost_table(const Comparison& c) {
    std::string out = "<h2>What it cost</h2><div class=\"wide\"><table><thead><tr><th></th>" + source_heads(c) +
                      "</tr></thead><tbody>";
    const auto row = [&](const std::string& name, const auto& value) {
        out += "<tr><td>" + escaped(name) + "</td>";
        for (const RunRecord& r : c.sources) out += "<td class=\"num\">" + value(r) + "</td>";
        out += "</tr>";
    };
    const auto total = [](const RunRecord& r, double Phase::*part) {
        double sum = 0;
        for (const Phase& p : r.phases) sum += p.*part;
        return sum;
    };
    row("particles or cells", [](const RunRecord& r) { return fmt::format("{:.0f}", r.elements); });
    row("time steps", [](const RunRecord& r) { return fmt::format("{:.0f}", r.steps); });
    row("wall time", [&](const RunRecord& r) { return fmt::format("{:.4g} s", total(r, &Phase::wall)); });
    row("processor time", [&](const RunRecord& r) { return fmt::format("{:.4g} s", total(r, &Phase::cpu)); });
    const auto predicted = [](const char* name, const char* format, double factor) {
        return [=](const RunRecord& r) {
            const double v = number_of(r, name, 0);
            return v > 0 ? fmt::format(fmt::runtime(format), v * factor) : std::string("–");
        };
    };
    row("predicted: particles with walls, or cells", predicted("predicted_elements", "{:.3g}", 1));
    row("predicted: wall time", predicted("predicted_seconds", "{:.3g} s", 1));
    row("predicted: memory", predicted("predicted_memory", "{:.3g} MB", 1e-6));
    row("peak memory", [](const RunRecord& r) { return fmt::format("{:.4g} MB", r.peak_memory / 1e6); });
    row("element steps per processor second", [&](const RunRecord& r) {
        const double cpu = total(r, &Phase::cpu);
        return cpu > 0 ? fmt::format("{:.3g}", r.elements * r.steps / cpu) : std::string("–");
    });
    std::vector<std::string> phases;
    for (const RunRecord& r : c.sources)
        for (const Phase& p : r.phases)
            if (std::ranges::find(phases, p.name) == phases.end()) phases.push_back(p.name);
    for (const std::string& phase : phases)
        row("of which " + phase + " (wall)", [&](const RunRecord& r) {
            double wall = 0;
            for (const Phase& p : r.phases)
                if (p.name == phase) wall += p.wall;
            return wall > 0 ? fmt::format("{:.4g} s", wall) : std::string("–");
        });
    return out + "</tbody></table></div>";
}

std::string provenance(const Comparison& c) {
    std::set<std::string> names;
    for (const RunRecord& r : c.sources)
        for (const auto& [name, text] : r.attributes)
            if (!name.starts_with("hull_finding_") && !name.starts_with("hull_repair_") && name != "title")
                names.insert(name);
    std::string out = "<h2>Where it comes from</h2><div class=\"wide\"><table><thead><tr><th></th>";
    for (std::size_t s = 0; s < c.names.size(); ++s) out += fmt::format("<th>{}{}</th>", key(s), escaped(c.names[s]));
    out += "</tr></thead><tbody>";
    for (const std::string& name : names) {
        out += "<tr><td>" + escaped(name) + "</td>";
        bool same = true;
        for (const RunRecord& r : c.sources) same = same && text_of(r, name) == text_of(c.sources.front(), name);
        if (same) {
            out += fmt::format("<td colspan=\"{}\" style=\"overflow-wrap:anywhere\">{}</td></tr>", c.sources.size(),
                               escaped(text_of(c.sources.front(), name)));
            continue;
        }
        for (const RunRecord& r : c.sources)
            out += "<td style=\"overflow-wrap:anywhere\">" + escaped(text_of(r, name, "–")) + "</td>";
        out += "</tr>";
    }
    return out + "</tbody></table></div>";
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
    std::string out = "<h2>How to do it again</h2><p>Save the scene below as <code>" + escaped(file) +
                      "</code> beside its hull file, with the code version named above:</p><pre>" + escaped(commands) +
                      "</pre>";
    if (!r.scene_text.empty())
        out += "<details><summary>The scene</summary><pre>" + escaped(r.scene_text) + "</pre></details>";
    return out;
}

std::string settling_table(const Comparison& c) {
    std::string rows;
    for (const Quantity& q : c.quantities)
        for (std::size_t s = 0; s < q.values.size(); ++s) {
            const MeanValue& m = q.values[s];
            if (!q.judged || !(m.n_effective > 0)) continue;
            rows += fmt::format(
                "<tr><td>{}</td><td>{}{}</td><td class=\"num\">{:.3g} … {:.3g} s</td><td class=\"num\">{:.3g}</td><td "
                "class=\"num\">{}</td><td class=\"num\">{}</td><td>{}</td></tr>",
                escaped(q.label), key(s), escaped(c.names[s]), m.from, m.to, m.n_effective,
                m.known ? value_text(m.half_width, 0) : "–",
                m.known && std::isfinite(m.second_opinion) ? value_text(m.second_opinion, 0) : "–",
                m.known ? (m.unreliable ? "the two estimates differ by more than 1.5" : "") : escaped(m.why_not));
        }
    if (rows.empty()) return {};
    return "<details><summary>How the settled means were taken</summary><p class=\"note\">The start is cut by MSER-5; "
           "the 95 % interval is Student's t with the number of independent samples "
           "from the autocorrelation time; overlapping batch means are the second opinion.</p><div "
           "class=\"wide\"><table><thead><tr><th>Quantity</th><th>run</th><th class=\"num\">window</th>"
           "<th class=\"num\">independent samples</th><th class=\"num\">± by autocorrelation</th><th class=\"num\">± "
           "by batch means</th><th></th></tr></thead><tbody>" +
           rows + "</tbody></table></div></details>";
}

}  // namespace

std::string report_html(const Comparison& c, const Figures& f, const std::string& above) {
    const RunRecord& first = c.sources.front();
    const std::string title = text_of(first, "title", "twinwake comparison");
    std::string sub;
    for (std::size_t s = 0; s < c.names.size(); ++s)
        sub += (s ? " · " : "") + key(s) + escaped(c.names[s]) +
               (c.sources[s].state == "finished" ? "" : " (" + escaped(c.sources[s].state) + ")");
    if (const double speed = number_of(first, "speed", 0); speed > 0) {
        sub += fmt::format(" · {:.4g} m/s", speed);
        const double length = number_of(first, "length", 0), g = number_of(first, "gravity", 9.81);
        if (length > 0) sub += fmt::format(" · Froude number {:.3g}", speed / std::sqrt(g * length));
    }
    if (const double spacing = number_of(first, "near_hull", 0); spacing > 0)
        sub += fmt::format(" · spacing at the hull {:.3g} m", spacing);

    const std::string view = view3d_section(c);
    std::string out =
        view.empty() ? page_begin(title) : page_begin(title, view3d_style, "'" + view3d_script_hash() + "'");
    out += "<h1>" + escaped(title) + "</h1><p class=\"sub\">" + sub + "</p>" + above;
    out += "<div class=\"verdict\">" + escaped(verdict_sentence(c)) + "</div>";
    for (const std::string& b : c.banners) out += "<div class=\"banner\">" + escaped(b) + "</div>";

    out += (c.sources.size() > 1 ? "<h2>Verdict by quantity</h2>" : "<h2>Values</h2>") + quantity_table(c, true);
    out += fmt::format(
        "<p class=\"note\">Values {} with 95 % intervals. Agree: the difference lies inside the joint interval, and "
        "that is at most {:g} % of the value. "
        "Differ: it lies outside. Undecided: inside, but the interval is too wide to tell. The intervals hold what the "
        "records show; the error of the resolution is not in "
        "them (a ladder of resolutions shows it).</p>",
        is_stream(first) ? "are settled means" : "of forces are settled means, of splash the largest of the run, each",
        100 * c.agree_within);
    out += settling_table(c);
    out += free_surfaces(c, f, view);
    if (!f.forces.empty())
        out += "<h2>Forces over time</h2>" + figure_list(f.forces) +
               "<p class=\"note\">Pale: the raw trace, from which the means are taken. Bars: the settled mean with its "
               "interval, over the window it was taken from.</p>";
    if (!f.splash.empty()) out += "<h2>Splash</h2>" + figure_list(f.splash);
    if (!f.wetting.empty() || !f.cuts.empty())
        out += "<h2>Wetted length and free surface</h2>" + figure_list(f.wetting) + figure_list(f.cuts);
    if (!f.probes.empty()) out += "<h2>Probes</h2>" + figure_list(f.probes);
    if (const std::string beside = quantity_table(c, false); !beside.empty())
        out += "<h2>Shown beside, not judged</h2>" + beside;
    out += gates_table(c) + certificates(c) + effects_table(c) + hull_section(c) + cost_table(c) + provenance(c) +
           "<h2>Definitions</h2>" + definitions(c) + reproduce(c);
    return out + page_end;
}

}  // namespace tw
