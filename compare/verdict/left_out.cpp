#include "compare/verdict/left_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "compare/metrics/splash.h"
#include "compare/read/record_numbers.h"
#include "compare/verdict/sentence.h"
#include "record/force_names.h"

namespace tw {

namespace {

constexpr double negligible = 1e-3;  ///< of the value [-]

/// What the plan calls a quantity; empty: it does not speak of it.
std::string planned_name(const std::string& quantity) {
    const bool of_tank = quantity.starts_with("load_");
    if (quantity == "drag" || quantity == "total_drag" || (of_tank && quantity.ends_with("_x"))) return "drag";
    if (quantity == "lift" || quantity == "trim_moment" || (of_tank && quantity.ends_with("_z"))) return "lift";
    return quantity.starts_with("splash") ? "splash" : "";
}

bool is_on(const RunRecord& run, const char* effect) {
    return std::ranges::any_of(run.effects, [&](const EffectChoice& e) { return e.on && e.name == effect; });
}

/// Whether another effect that is on stands for it, or another that is off names it.
bool said_elsewhere(const EffectChoice& e, const std::string& planned, const RunRecord& run) {
    return e.name == "no_slip" || e.name == "friction" ||
           (e.name == "viscosity" && planned == "drag" && is_on(run, "friction"));
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

std::vector<LeftOut> left_out_of(const Quantity& quantity, const MeanValue& value, const RunRecord& run) {
    std::vector<LeftOut> all;
    const std::string planned = planned_name(quantity.name);
    if (planned.empty() || !is_main_quantity(quantity.name) || !value.known) return all;
    for (const EffectChoice& e : run.effects) {
        if (e.on || said_elsewhere(e, planned, run)) continue;
        const std::string influence = influence_on(planned, e.influence);
        const auto begins = [&](const char* word) { return influence.starts_with(word); };
        if (influence.empty() || begins("none") || begins("below") || begins("not measured")) continue;
        const double bound = bound_of(influence, quantity, value.value);
        if (bound < negligible * std::abs(value.value)) continue;
        all.push_back({spoken(e.name), trimmed(in_short(influence)), bound});
    }
    if (number_of(run, "dimensions", 3) == 2) all.push_back({"the third dimension", "", nan});
    return all;
}

double outer_half_width(const Quantity& quantity, const MeanValue& value, const RunRecord& run) {
    double squares = 0;
    for (const LeftOut& l : left_out_of(quantity, value, run))
        if (std::isfinite(l.bound)) squares += l.bound * l.bound;
    return value.known && std::isfinite(value.bar()) && squares > 0 ? std::hypot(value.bar(), std::sqrt(squares)) : nan;
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
                const std::string planned = planned_name(q->name),
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
