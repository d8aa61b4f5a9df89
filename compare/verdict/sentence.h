#pragma once
#include <limits>
#include <string>
#include <vector>

#include "compare/compare.h"

namespace tw {

/// What the sentence of one verdict is made of. Values in the quantity's unit; one or two methods, the names as in
/// records ("sph", "fvm").
struct Statement {
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::string label, unit;
    std::vector<std::string> methods = {};
    std::vector<double> values = {};
    double size = 0;                                               ///< what per cent refer to
    double interval = nan;                                         ///< half width of the 95 % interval; nan: none
    double discretisation = nan, statistics = nan, choices = nan;  ///< its parts
    Verdict verdict = Verdict::not_comparable;
    std::string why = {};            ///< not converged, not comparable: the reason
    double target = 0.05;            ///< of the interval, over the size
    double seconds_to_target = nan;  ///< wall time of the runs that would reach it; nan: not known
    std::string borrowed = {};       ///< the scene that the discretisation error was taken from; empty: this one
};

/// One sentence that can be forwarded as it is: "Lift: SPH 3.1 % above interFoam, discretisation error ±9 %: no
/// difference shown; 40 min of finer runs would bring it to ±5 %." No per cent in it is without an interval or the words
/// that it has none.
std::string sentence_of(const Statement& statement);

/// The quantities that stand first: drag, lift, trim moment, splash height.
bool is_main_quantity(const std::string& name);
/// "SPH", "interFoam"; others as they are.
std::string method_title(const std::string& method);

}  // namespace tw
