#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "compare/compare.h"

namespace tw {

/// What nobody waits for: further runs are spoken of up to this wall time [s]. `check` refuses longer ones.
inline constexpr double longest_runs = 30 * 86400.0;

/// What the sentence of one verdict is made of. Values in the quantity's unit; one or two methods, the names as in
/// records (methods/methods.h).
struct Statement {
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

/// Where a quantity stands among those that a first page speaks of, by its name; negative: it is not one of them. Drag,
/// lift and trim moment of a hull; way, velocity, largest force and strains of a body that moves; impulse and largest
/// force on what stands in a tank; the splash sheet.
int main_rank(const std::string& name);
inline bool is_main_quantity(const std::string& name) { return main_rank(name) >= 0; }
/// Those of a list, in that order, without those that are shown beside and never judged.
template <class Quantities>
auto main_quantities(const Quantities& all) {
    std::vector<decltype(all.data())> of_all;
    const auto only_beside = [](const auto& q) {
        if constexpr (requires { q.judged_in_ladder; })
            return !q.judged && !q.judged_in_ladder && q.not_resolved.empty();
        else
            return false;
    };
    for (const auto& q : all)
        if (is_main_quantity(q.name) && !only_beside(q)) of_all.push_back(&q);
    std::ranges::stable_sort(of_all, {}, [](const auto* q) { return main_rank(q->name); });
    return of_all;
}

}  // namespace tw
