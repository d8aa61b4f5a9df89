#include "compare/verdict/left_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "record/record_numbers.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "record/force_names.h"
#include "record/influence_words.h"

namespace tw {

namespace {

constexpr double negligible = 1e-3;  ///< of the value [-]

bool is_on(const RunRecord& run, const char* effect) {
    return std::ranges::any_of(run.effects, [&](const EffectChoice& e) { return e.on && e.name == effect; });
}

/// Of a method whose solution is not made of particles.
bool is_of_others(const std::string& elements, const RunRecord& run) {
    return !elements.empty() && elements_of(text_of(run, "method")) != elements;
}

/// Whether another effect that is on stands for it, or another that is off names it, or it is no shortcoming of this run.
bool is_not_charged(const EffectChoice& e, const std::string& kind, const RunRecord& run) {
    const auto is = [&](auto... names) { return ((e.name == names) || ...); };
    return is("no_slip", "friction", "gravity") ||
           (e.name == "viscosity" && kind == "drag" && is_on(run, "friction")) ||
           (is("shifting", "tension_control", "acoustic_damping") && is_of_others("particles", run));
}

/// Takes a number off the front of a text.
std::optional<double> take_number(std::string_view& text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// Takes a word off the front of a text; whether it stood there.
bool take_word(std::string_view& text, std::string_view word) {
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

/// "about 116 N of friction", "3 to 5 % (measured)": the larger number, of the value where it is in per cent.
double bound_of(std::string_view influence, const Quantity& q, double value) {
    take_word(influence, "about ");
    std::optional<double> most = take_number(influence);
    if (most && take_word(influence, " to ")) most = take_number(influence);
    if (!most || influence.find("and more") != influence.npos) return nan;
    if (take_word(influence, " %")) return std::abs(*most) / 100 * std::abs(value);
    return take_word(influence, " N") && q.unit == "N" ? std::abs(*most) : nan;
}

/// Without what stands in brackets behind it, and without who leaves it out.
std::string in_short(const std::string& influence) { return influence.substr(0, influence.find_first_of("(,:")); }

std::string trimmed(std::string text) {
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

std::string spoken(std::string effect) {
    std::ranges::replace(effect, '_', ' ');
    return effect;
}

}  // namespace

std::string influence_on(const std::string& quantity, const std::string& influence) {
    const auto begins = [&](const char* word) { return quantity.starts_with(word); };
    const std::string key = begins("drag")                           ? "drag: "
                            : begins("lift")                         ? "lift: "
                            : begins("splash") || begins("airborne") ? "splash: "
                                                                     : "";
    if (key.empty()) return {};
    auto at = influence.find(key);
    if (at == influence.npos || (at > 0 && influence.compare(at - 2, 2, "; ") != 0)) return {};
    at += key.size();
    return influence.substr(at, influence.find("; ", at) - at);
}

namespace {

/// What the plan bounds as a number for one of these kinds, the first that it knows.
const EffectBound* bound_of(const EffectChoice& e, const std::vector<std::string>& kinds) {
    for (const std::string& kind : kinds)
        if (const auto b = std::ranges::find(e.bounds, kind, &EffectBound::of); b != e.bounds.end()) return &*b;
    return nullptr;
}

void add(std::vector<LeftOut>& all, const std::string& name, const EffectBound& b, double value) {
    const bool share = b.unit == "-";
    const double unit = share ? std::abs(value) : 1;
    LeftOut l{name, in_words(b), unit * std::max(b.below, b.above), unit * b.below, unit * b.above};
    if (share && value < 0) std::swap(l.below, l.above);  // of its magnitude
    if (l.bound >= negligible * std::abs(value)) all.push_back(std::move(l));
}

/// What the words of the plan say of a kind of quantity.
void add_words(std::vector<LeftOut>& all, const EffectChoice& e, const std::string& kind, const Quantity& q,
               double value) {
    const std::string influence = influence_on(kind, e.influence);
    const auto begins = [&](const char* word) { return influence.starts_with(word); };
    if (influence.empty() || begins("none") || begins("below") || begins("not measured")) return;
    const double bound = bound_of(influence, q, value);
    if (bound < negligible * std::abs(value)) return;
    const double side = std::isfinite(bound) ? bound : 0;
    all.push_back({spoken(e.name), trimmed(in_short(influence)), bound, side, side});
}

}  // namespace

std::vector<LeftOut> left_out_of(const Quantity& quantity, const MeanValue& value, const RunRecord& run) {
    std::vector<LeftOut> all;
    const std::vector<std::string> kinds = kinds_of(quantity.name);
    if (kinds.empty() || !value.known) return all;
    for (const EffectChoice& e : run.effects) {
        if (e.on || is_not_charged(e, kinds.back(), run)) continue;
        if (const EffectBound* b = bound_of(e, kinds)) {
            if (!is_of_others(b->elements, run)) add(all, spoken(e.name), *b, value.value);
        } else if (is_main_quantity(quantity.name)) {
            add_words(all, e, kinds.back(), quantity, value.value);
        }
    }
    if (number_of(run, "dimensions", 3) == 2 && is_main_quantity(quantity.name))
        all.push_back({"the third dimension", ""});
    const double height = number_of(run, "released_height", 0), gravity = number_of(run, "gravity", 0);
    if (kinds.front() == "arrival" && height > 0 && gravity > 0) {
        const double gate = gate_time * std::sqrt(height / gravity);
        add(all, "the gate", {.of = "arrival", .below = gate, .above = gate, .unit = "s"}, value.value);
    }
    if (value.reading_below > 0 || value.reading_above > 0)
        all.push_back({value.reading_of, "", std::max(value.reading_below, value.reading_above), value.reading_below,
                       value.reading_above});
    return all;
}

OuterInterval outer_interval(const Quantity& quantity, const MeanValue& value, const RunRecord& run) {
    OuterInterval squares{0, 0};
    for (const LeftOut& l : left_out_of(quantity, value, run))
        if (std::isfinite(l.bound)) squares.below += l.below * l.below, squares.above += l.above * l.above;
    if (!value.known || !std::isfinite(value.bar()) || !(squares.below + squares.above > 0)) return {};
    return {std::hypot(value.bar(), std::sqrt(squares.below)), std::hypot(value.bar(), std::sqrt(squares.above))};
}

double outer_half_width(const Quantity& quantity, const MeanValue& value, const RunRecord& run) {
    const OuterInterval outer = outer_interval(quantity, value, run);
    return std::max(outer.below, outer.above);  // both or neither are known
}

std::string left_out_text(const Comparison& c) {
    struct Line {
        std::string name;
        std::vector<std::string> of = {};  ///< "drag 10 %"
    };
    std::vector<Line> lines;
    const ForceNames called = force_names(std::ranges::any_of(c.sources, is_stream));
    for (const Quantity* q : main_quantities(c.quantities))
        for (std::size_t s = 0; s < c.sources.size() && s < q->values.size(); ++s)
            for (const LeftOut& l : left_out_of(*q, q->values[s], c.sources[s])) {
                auto line = std::ranges::find(lines, l.name, &Line::name);
                if (line == lines.end()) line = lines.insert(line, {l.name});
                const std::string planned = kinds_of(q->name).back(),
                                  of = (planned == "drag"   ? lower_case_first(called.along)
                                        : planned == "lift" ? lower_case_first(called.up)
                                                            : planned) +
                                       " " + l.influence;
                if (std::isfinite(l.bound) && std::ranges::find(line->of, of) == line->of.end()) line->of.push_back(of);
            }
    std::string text;
    for (const Line& line : lines) {
        text += (text.empty() ? "" : ", ") + line.name;
        for (std::size_t k = 0; k < line.of.size(); ++k)
            text += (k == 0 ? " (" : ", ") + line.of[k] + (k + 1 == line.of.size() ? ")" : "");
    }
    return text;
}

}  // namespace tw
