#include "record/influence_words.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "record/force_names.h"

namespace tw {

namespace {

/// "14 %", "0.0041 %", "22 ms", "120 N".
std::string amount(double number, const std::string& unit) {
    if (unit == "-") return fmt::format("{:.2g} %", 100 * number);
    if (unit == "s" && number < 1) return fmt::format("{:.3g} ms", 1e3 * number);
    return fmt::format("{:.3g} {}", number, unit);
}

}  // namespace

std::string influence_in_words(std::string influence, bool stream) {
    if (stream) return influence;
    const ForceNames called = force_names(stream);
    for (const auto& [kept, force] :
         {std::pair<std::string_view, std::string>{"drag: ", called.along}, {"lift: ", called.up}}) {
        const std::string said = lower_case_first(force) + ": ";
        for (std::size_t at = influence.find(kept); at != influence.npos; at = influence.find(kept, at + said.size()))
            if (at == 0 || influence.compare(at - 2, 2, "; ") == 0) influence.replace(at, kept.size(), said);
    }
    return influence;
}

std::string in_words(const EffectBound& b) {
    if (b.below == b.above) return "±" + amount(b.below, b.unit);
    const bool time = b.of == "arrival";
    const std::string less = amount(b.below, b.unit) + (time ? " earlier" : " less"),
                      more = amount(b.above, b.unit) + (time ? " later" : " more");
    return b.below == 0 ? "up to " + more : b.above == 0 ? "up to " + less : less + " to " + more;
}

std::vector<std::string> bounds_in_words(const std::vector<EffectBound>& bounds) {
    std::vector<std::pair<std::string, std::string>> lines;  // kinds, what is said of them
    for (const EffectBound& b : bounds) {
        if (b.of == "drag" || b.of == "lift" || b.of == "splash") continue;  // stand in the influence itself
        const std::string said =
            in_words(b) + " (" + b.source + (b.elements.empty() ? "" : ", " + b.elements + " alone") + ")";
        bool named = false;
        for (auto& [kinds, of_them] : lines)
            if (of_them == said) kinds += ", " + b.of, named = true;
        if (!named) lines.emplace_back(b.of, said);
    }
    std::vector<std::string> words;
    for (const auto& [kinds, said] : lines) words.push_back(kinds + ": " + said);
    return words;
}

}  // namespace tw
