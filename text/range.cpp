#include "text/range.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tw {

std::string value_text(double si, std::string_view unit) {
    if (unit == "rad") return fmt::format("{:.4g} deg", si * 180 / std::numbers::pi);
    return fmt::format("{:.6g}{}{}", si, unit == "-" ? "" : " ", unit == "-" ? "" : unit);
}

std::string range_text(const Range& range, std::string_view unit) {
    const bool low = std::isfinite(range.min), high = std::isfinite(range.max);
    if (!low && !high) return "";
    if (!low) return "at most " + value_text(range.max, unit);
    const std::string from = (range.open_min ? "greater than "
                              : high         ? "from "
                                             : "at least ") +
                             value_text(range.min, unit);
    if (!high) return from;
    return from + (range.open_min ? " and at most " : " to ") + value_text(range.max, unit);
}

}  // namespace tw
