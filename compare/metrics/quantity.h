#pragma once
#include <string>
#include <utility>

#include "compare/compare.h"
#include "methods/methods.h"

namespace tw {

/// Why a value is missing where nothing went wrong.
inline constexpr const char* not_given = "this method does not give it";

inline Quantity new_quantity(std::string name, std::string label, std::string unit, std::string definition) {
    Quantity q;
    q.name = std::move(name);
    q.label = std::move(label);
    q.unit = std::move(unit);
    q.definition = std::move(definition);
    return q;
}

/// A value that is missing, and why.
inline MeanValue unknown_value(const std::string& why) {
    MeanValue m;
    m.why_not = why;
    return m;
}
/// A value from `from` to `to` [s]; `half_width`: of its 95 % interval, NaN: not known.
inline MeanValue known_value(double value, double half_width, double from, double to) {
    MeanValue m;
    m.known = true;
    m.value = value;
    m.half_width = half_width;
    m.from = from, m.to = to;
    return m;
}

/// What is to be said of every two sources: of only two as it is, of more behind their names. `say(a, b)`: of these
/// places; empty: nothing.
template <class Say>
std::string of_every_pair(const std::vector<std::string>& names, Say say) {
    std::string all;
    for (std::size_t a = 0; a < names.size(); ++a)
        for (std::size_t b = a + 1; b < names.size(); ++b)
            if (const std::string one = say(a, b); !one.empty())
                all += (all.empty() ? "" : "; ") +
                       (names.size() > 2 ? method_label(names[a]) + " and " + method_label(names[b]) + ": " : "") + one;
    return all;
}

}  // namespace tw
