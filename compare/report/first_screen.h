#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "compare/compare.h"
#include "compare/report/figures.h"

namespace tw {

/// What a page shows before anybody scrolls (1400 x 900): hull and conditions; per main quantity the sentence and a
/// strip with the values; the pictures side by side; what speaks against it; what to do next.
std::string first_screen(const Comparison& comparison, const Figures& figures);

// Its parts: strip.cpp, trust.cpp, next_steps.cpp.

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

/// Two <svg> elements without scripts, of which the style sheet shows the one for the screen's width; empty where no
/// value is finite. Every interval is drawn whole. The difference has a line and an axis of its own, about zero.
std::string svg(const Strip& strip);

/// The reservations that a reader has to know before trusting the numbers, one line each.
struct Doubt {
    bool grave = false;  ///< a check that is not met, or a reference that every method misses; else something to know
    std::string text;
};

/// In this order: references outside the interval of every method, then of one of them (the interval is the root of the
/// squares of the value's and the reference's); checks that are not met; what stands on top of the report.
std::vector<Doubt> doubts_of(const Comparison& comparison);

/// The next runs that would make a comparison more conclusive, as commands.
struct NextStep {
    std::string what;     ///< "Simulate longer: the means need about 0.9 s more."
    std::string command;  ///< for a shell; empty: a fact, nothing to run
};
/// The most useful first, at most three. Those that keep the study's own size come before finer ones; runs that take
/// more than longest_offer (sentences.h) are no command.
std::vector<NextStep> next_steps(const Comparison& comparison);

}  // namespace tw
