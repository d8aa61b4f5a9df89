#include "compare/report/first_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "compare/gates/gates.h"
#include "record/record_numbers.h"
#include "compare/report/base64.h"
#include "compare/report/comparison_tables.h"
#include "compare/report/escape.h"
#include "compare/report/next_steps.h"
#include "compare/report/numbers.h"
#include "compare/report/sentences.h"
#include "compare/report/strip.h"
#include "compare/verdict/left_out.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "text/plain_number.h"

namespace tw {

namespace {

constexpr std::size_t most_strips = 5;  ///< as many as fit on a screen of 900 pixels

/// "prismatic hull, 4 m long, 1 m wide, draft 0.2 m, trim 5° bow up · 8 m/s, Froude number 1.27 · ..."
std::string conditions(const Comparison& c) {
    const RunRecord& r = c.sources.front();
    const double length = number_of(r, "length", 0), speed = number_of(r, "speed", 0);
    std::vector<std::string> parts;
    if (!r.hull.triangles.empty())
        parts.push_back(fmt::format("{}, {:.4g} m long, {:.4g} m wide, draft {:.4g} m, trim {:.3g}° bow up",
                                    text_of(r, "hull_source", "hull"), length, number_of(r, "beam", 0),
                                    number_of(r, "draft", 0), number_of(r, "trim", 0) / degree));
    if (speed > 0) {
        const double g = number_of(r, "gravity", 9.81);
        parts.push_back(fmt::format("{:.4g} m/s", speed));
        if (length > 0 && g > 0) parts.back() += fmt::format(", Froude number {:.3g}", speed / std::sqrt(g * length));
    }
    if (const double size = number_of(r, "near_hull", 0); size > 0)
        parts.push_back(fmt::format("size at the hull {:.3g} mm", 1e3 * size));
    std::string runs;
    for (std::size_t s = 0; s < c.names.size(); ++s)
        runs += fmt::format("<span class=\"key k{}\"></span>{}{} ", s, escaped(method_label(c.names[s])),
                            c.sources[s].state == "finished" ? "" : " (" + escaped(c.sources[s].state) + ")");
    std::string out = "<p class=\"sub\">" + runs;
    for (const std::string& part : parts) out += "· " + escaped(part) + " ";
    return out + "</p>";
}

std::string value_with_unit(const MeanValue& m, const std::string& unit) {
    if (!m.known) return "no value";
    return value_text(m.value, m.bar()) + (unit == "-" ? "" : " " + unit) +
           (std::isfinite(m.bar()) ? "" : ", no interval");
}

std::string strip_of(const Comparison& c, const Quantity& q) {
    Strip strip{q.label, {}};
    for (std::size_t s = 0; s < q.values.size(); ++s) {
        const MeanValue& m = q.values[s];
        const OuterInterval outer = outer_interval(q, m, c.sources[s]);
        strip.values.push_back({method_label(c.names[s]), c.failed(s) ? "failed" : value_with_unit(m, q.unit), s,
                                m.known && !c.failed(s) ? m.value : std::nan(""), m.bar(), outer.above, outer.below});
    }
    for (const Reference& r : c.references)
        if (r.quantity == q.name) strip.references.push_back({r.source, r.value, r.half_width});
    return svg(strip);
}

/// The sentences, with a strip each for the first quantities.
std::string answer(const Comparison& c) {
    std::string failures, out;
    for (const std::string& sentence : failures_of(c)) failures += "<p>" + escaped(sentence) + "</p>";
    std::size_t strips = 0;
    for (const Quantity* q : main_quantities(c.quantities)) {
        std::string sentences;
        for (const std::string& sentence : sentences_on(c, *q)) sentences += "<p>" + escaped(sentence) + "</p>";
        const std::string strip = strips < most_strips ? strip_of(c, *q) : "";
        if (!strip.empty()) ++strips;
        if (sentences.empty() && !strip.empty()) sentences = "<p>" + escaped(q->label) + "</p>";
        if (!sentences.empty()) out += "<div class=\"answer\">" + sentences + strip + "</div>";
    }
    if (out.empty() && failures.empty())
        for (const std::string& sentence : verdict_sentences(c)) out += "<p>" + escaped(sentence) + "</p>";
    if (const std::string left_out = left_out_text(c); !left_out.empty())
        out += "<p class=\"note\">Not in these intervals: " + escaped(left_out) + "; thin lines are with it.</p>";
    return "<div class=\"verdict\">" + failures + out + "</div>";
}

std::string pictures(const Comparison& c, const Figures& f) {
    std::string out;
    for (std::size_t s = 0; s < f.pictures.free_surface.size(); ++s)
        if (!f.pictures.free_surface[s].empty())
            out += fmt::format(
                "<figure><figcaption><span class=\"key k{}\"></span>{}</figcaption><img alt=\"free surface of the last "
                "frame, {}\" src=\"data:image/png;base64,{}\"></figure>",
                s, escaped(method_label(c.names[s])), escaped(method_label(c.names[s])),
                base64(f.pictures.free_surface[s]));
    if (!out.empty()) return "<div class=\"shots\">" + out + "</div>" + f.elevation_legend;
    return f.forces.empty() ? std::string() : figure_html(f.forces.front().plot);
}

/// One line on the screen; opened, and on paper, all of it.
std::string line_of(const char* kind, const std::string& text) {
    return fmt::format("<details class=\"line {}\"><summary>{}</summary></details>", kind, escaped(text));
}

std::string trust(const Comparison& c) {
    std::string out;
    for (const Gate& g : failed_gates(c.gates)) {
        const std::string unit = g.unit == "-" || g.unit.empty() ? "" : " " + g.unit;
        out += line_of(g.warns ? "open" : "bad",
                       fmt::format("{}: {} {}{}, limit {}{}{}", method_label(g.source), g.name, plain_number(g.value),
                                   unit, plain_number(g.limit), unit, g.remark.empty() ? "" : "; " + g.remark));
    }
    for (const std::string& banner : c.banners) out += line_of("open", banner);
    const auto met = std::ranges::count_if(c.gates, &Gate::pass);
    out += fmt::format("<p class=\"note\">{} of {} checks are met. Discretisation error: {}.</p>", met, c.gates.size(),
                       c.discretisation_from.empty() ? "not estimated" : "from " + escaped(c.discretisation_from));
    return "<h2>Can it be trusted?</h2>" + out;
}

std::string next(const Comparison& c) {
    std::string out;
    for (const NextStep& step : next_steps(c))
        out += "<li>" + escaped(step.what) + "<br><code>" + escaped(step.command) + "</code></li>";
    return out.empty() ? out : "<h2>What to do next</h2><ul class=\"next\">" + out + "</ul>";
}

}  // namespace

std::string first_screen(const Comparison& c, const Figures& f) {
    return "<header><h1>" + escaped(text_of(c.sources.front(), "title", "twinwake comparison")) + "</h1>" +
           conditions(c) + "</header><div class=\"first\"><div>" + answer(c) + "</div><div>" + pictures(c, f) +
           trust(c) + next(c) + "</div></div>";
}

}  // namespace tw
