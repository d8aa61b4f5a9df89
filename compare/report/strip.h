#pragma once
#include <cmath>
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
    std::string title;
    std::vector<Value> values;
    std::vector<Reference> references = {};
};

/// One <svg> element without scripts; empty where no value is finite. An interval that is wider than the values are
/// large runs to the end of the axis.
std::string svg(const Strip& strip);

}  // namespace tw
