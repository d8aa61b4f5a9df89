#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/numbers.h"

namespace tw {

/// Values of one quantity below each other on one axis, each with its interval, and references as ticks across them.
struct Strip {
    struct Value {
        std::string name, text;  ///< of the run; the value in words, with interval and unit
        std::size_t source = 0;  ///< its colour
        double value = 0;
        double half_width = 0;     ///< not finite: no interval, drawn hollow
        double outer = nan;        ///< half width with what the run leaves out, above; not finite: not drawn
        double outer_below = nan;  ///< and below; not finite: as above
        double below() const { return std::isfinite(outer_below) ? outer_below : outer; }
    };
    struct Reference {
        std::string name;
        double value = 0, half_width = 0;
    };
    /// Of the second value from the first, in one unit.
    struct Difference {
        std::string text;
        double value = 0, half_width = 0;
        double target = 0;  ///< up to which the two agree
    };
    std::string title;
    std::vector<Value> values;
    std::vector<Reference> references = {};
    std::optional<Difference> difference = {};
};

/// One <svg> element without scripts; empty where no value is finite. Every interval is drawn whole. The difference has
/// a line and an axis of its own, about zero.
std::string svg(const Strip& strip);

}  // namespace tw
