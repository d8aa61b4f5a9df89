#include "compare/report/first_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/numbers.h"
#include "compare/metrics/forces.h"
#include "compare/report/comparison_tables.h"
#include "compare/report/escape.h"
#include "compare/report/numbers.h"
#include "compare/report/sentences.h"
#include "compare/verdict/left_out.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

constexpr double planes_from = 0.8;     ///< Froude number on the length: from here on the beam's is used as well
constexpr std::size_t most_strips = 4;  ///< as many as fit on a screen of 768 pixels

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
        const double beam = number_of(r, "beam", 0), Fr = length > 0 && g > 0 ? speed / std::sqrt(g * length) : 0;
        if (Fr > 0) parts.back() += fmt::format(", Froude number {:.3g}", Fr);
        if (Fr >= planes_from && beam > 0) parts.back() += fmt::format(" (Cv {:.3g})", speed / std::sqrt(g * beam));
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
    return value_text(m.value, m.bar()) + (unit == "-" ? "" : " " + unit_text(unit)) +
           (std::isfinite(m.bar()) ? "" : ", no interval");
}

/// Where both values have an interval that a verdict could come from.
std::optional<Strip::Difference> drawn_difference(const Comparison& c, const Quantity& q) {
    const bool judged = q.verdict == Verdict::agree || q.verdict == Verdict::differ || q.verdict == Verdict::undecided;
    if (!judged || c.sources.size() != 2 || !(q.interval > 0) || !(q.size > 0)) return {};
    const bool in_per_cent = told_in_per_cent(q.values[q.a].value, q.values[q.b].value, q.size);
    return Strip::Difference{in_per_cent ? difference_text(q.per_cent, 100 * q.interval / q.size)
                                         : signed_text(q.difference, q.interval) + " " + unit_text(q.unit),
                             q.difference, q.interval, c.agree_within * q.size};
}

/// "measured (Fridsma 1969)" of "the measured value (Fridsma 1969)".
std::string short_source(const Reference& r) {
    constexpr std::string_view whole = "the measured value";
    return r.measured && r.source.starts_with(whole) ? "measured" + r.source.substr(whole.size()) : r.source;
}

/// "SPH +13 %, interFoam +6.1 %" from a reference.
std::string distances(const Comparison& c, const Quantity& q, const Reference& r) {
    std::string out;
    for (std::size_t s = 0; s < q.values.size(); ++s)
        if (q.values[s].known && !c.failed(s))
            out += (out.empty() ? "" : ", ") + method_label(c.names[s]) + " " +
                   per_cent_text(100 * (q.values[s].value - r.value) / std::abs(r.value));
    return out;
}

/// How far the values lie from each reference, in one line.
std::string beside_references(const Comparison& c, const Quantity& q) {
    const auto measured =
        std::ranges::count_if(c.references, [&](const Reference& r) { return r.measured && r.quantity == q.name; });
    std::string out;
    for (const Reference& r : c.references)
        if (const std::string far = r.value != 0 ? distances(c, q, r) : "";
            r.quantity == q.name && !r.of_one_run && !far.empty())
            out += (out.empty() ? "Against " : "; against ") +
                   (r.measured && measured == 1 ? "the measurement" : r.source) + ": " + far;
    return out.empty() ? out : "<p class=\"note\">" + escaped(out) + ".</p>";
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
        if (r.quantity == q.name && !r.of_one_run) strip.references.push_back({short_source(r), r.value, r.half_width});
    std::ranges::sort(strip.references, {}, &Strip::Reference::value);
    strip.difference = drawn_difference(c, q);
    return svg(strip);
}

/// The verdict as one reads it, and its colour.
std::pair<const char*, const char*> headline_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::agree: return {"agree", "agree"};
        case Verdict::differ: return {"differ", "differ"};
        case Verdict::undecided: return {"not decided yet", "undecided"};
        case Verdict::no_answer: return {"no answer yet", "undecided"};
        case Verdict::not_converged: return {"not converged", "undecided"};
        case Verdict::not_comparable:
        case Verdict::not_estimated: break;
    }
    return {"", ""};
}

std::string capital(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

/// What is said of one quantity: of two methods the verdict in bold and how far they are apart, else whole sentences.
std::string said_of(const Comparison& c, const Quantity& q) {
    const auto [verdict, colour] = headline_of(q.verdict);
    if (c.sources.size() == 2 && *verdict && !q.finding.empty() && q.not_resolved.empty())
        return fmt::format("<p><b>{}: <span class=\"said {}\">{}</span>.</b> {}{}</p>", escaped(q.label), colour,
                           verdict, escaped(q.finding), q.caveat.empty() ? "" : " (" + escaped(q.caveat) + ")");
    const auto open_because = [&](const char* badge, const std::string& why) {
        return fmt::format("<p><b>{}: <span class=\"said undecided\">{}</span>.</b> {}</p>", escaped(q.label), badge,
                           escaped(why));
    };
    if (constexpr std::string_view not_resolved = "not resolved: "; q.not_resolved.starts_with(not_resolved))
        return open_because("not resolved", capital(q.not_resolved.substr(not_resolved.size())) + ".");
    if (c.sources.size() == 2 && q.verdict == Verdict::undecided && q.finding.empty() && !q.remark.empty())
        return open_because("no mean yet", q.remark + ".");
    std::string sentences;
    for (const std::string& sentence : sentences_on(c, q)) {
        const bool labelled = sentence.starts_with(q.label + ":");
        const std::string rest = labelled ? sentence.substr(q.label.size() + 1) : sentence;
        sentences += "<p>" + (labelled ? "<b>" + escaped(q.label) + ":</b>" : "") + escaped(rest) + "</p>";
    }
    return sentences;
}

/// Whether an interval of a difference is visibly narrower than the two bars above it.
bool is_narrower(const Quantity& q) { return q.interval < 0.97 * std::hypot(q.values[q.a].bar(), q.values[q.b].bar()); }

/// Total drag times speed, and its coefficient, where it is known.
std::string power_text(const Comparison& c) {
    const Quantity *power = c.find("effective_power"), *coefficient = c.find("resistance_coefficient"),
                   *total = resistance_of(c);
    if (!power || !total) return {};
    std::string powers, coefficients;
    double largest = 0;
    for (const MeanValue& P : power->values)
        if (P.known) largest = std::max(largest, P.value);
    const bool kilo = largest >= 1000;
    for (std::size_t s = 0; s < c.sources.size(); ++s) {
        const MeanValue &P = power->values[s], &R = total->values[s];
        if (!P.known || c.failed(s) || !(R.value > 0)) continue;
        const std::string who = method_label(c.names[s]);
        const double shown = (kilo ? 1e-3 : 1) * P.value;
        powers += fmt::format("{}{} {} {}", powers.empty() ? "" : ", ", who,
                              value_text(shown, shown * R.bar() / R.value), kilo ? "kW" : "W");
        if (coefficient && coefficient->values[s].known)
            coefficients += fmt::format("{}{} {}", coefficients.empty() ? "" : ", ", who,
                                        number_text(coefficient->values[s].value, 3));
    }
    if (powers.empty()) return {};
    return "<p class=\"note\">Effective power P<sub>E</sub> = R<sub>T</sub> U: " + escaped(powers) +
           (coefficients.empty() ? "" : "; C<sub>T</sub> on what is wet: " + escaped(coefficients)) + ".</p>";
}

/// The sentences, with a strip each for the first quantities.
std::string answer(const Comparison& c) {
    std::string failures, out;
    for (const std::string& sentence : failures_of(c)) failures += "<p>" + escaped(sentence) + "</p>";
    const Quantity* resistance = resistance_of(c);
    std::size_t strips = 0;
    bool explained = false;
    for (const Quantity* q : main_quantities(c.quantities)) {
        std::string sentences = said_of(c, *q);
        const bool drawn = strips < most_strips && q->verdict != Verdict::no_answer && q->not_resolved.empty();
        std::string strip = drawn ? strip_of(c, *q) : "";
        if (!strip.empty()) ++strips;
        if (sentences.empty() && !strip.empty()) sentences = "<p><b>" + escaped(q->label) + "</b></p>";
        if (!strip.empty() && !explained && drawn_difference(c, *q) && is_narrower(*q)) {
            strip +=
                "<p class=\"note why\">The difference is better known than the values: what the box adds is the same "
                "in both. Shaded: agreement.</p>";
            explained = true;
        }
        if (!strip.empty()) strip += beside_references(c, *q);
        if (q == resistance) strip += power_text(c);
        if (!sentences.empty()) out += "<div class=\"answer\">" + sentences + strip + "</div>";
    }
    if (out.empty() && failures.empty())
        for (const std::string& sentence : verdict_sentences(c)) out += "<p>" + escaped(sentence) + "</p>";
    if (const std::string left_out = left_out_text(c); !left_out.empty())
        out += "<p class=\"note\">The thin lines include what no run solves, the bars do not: " + escaped(left_out) +
               ".</p>";
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

/// As much as there is room for; opened, and on paper, all of it.
std::string line_of(const Doubt& doubt) {
    return fmt::format(
        "<details class=\"line {}\"><summary><span class=\"icon\" aria-hidden=\"true\">{}</span>{}"
        "</summary></details>",
        doubt.grave ? "bad" : "open", doubt.grave ? "×" : "!", escaped(doubt.text));
}

std::string trust(const Comparison& c) {
    std::string out;
    for (const Doubt& doubt : doubts_of(c)) out += line_of(doubt);
    const auto met = std::ranges::count_if(c.checks, &ValidityCheck::pass);
    out += fmt::format("<p class=\"note\">{} of {} checks are met. Discretisation error: {}.</p>", met, c.checks.size(),
                       c.discretisation_from.empty() ? "not estimated" : "from " + escaped(c.discretisation_from));
    return "<div class=\"trust\"><h2>Can it be trusted?</h2>" + out + "</div>";
}

std::string next(const Comparison& c) {
    std::string out;
    for (const NextStep& step : next_steps(c))
        out += "<li>" + escaped(step.what) +
               (step.command.empty() ? "" : "<br><code>" + escaped(step.command) + "</code>") + "</li>";
    return out.empty() ? out : "<div class=\"todo\"><h2>What to do next</h2><ul class=\"next\">" + out + "</ul></div>";
}

}  // namespace

std::string first_screen(const Comparison& c, const Figures& f) {
    return "<header><h1>" + escaped(text_of(c.sources.front(), "title", "twinwake comparison")) + "</h1>" +
           conditions(c) + "</header><div class=\"first\"><div>" + answer(c) +
           "</div><div class=\"beside\"><div class=\"seen\">" + pictures(c, f) + "</div>" + trust(c) + next(c) +
           "</div></div>";
}

}  // namespace tw
