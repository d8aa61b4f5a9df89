#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "compare/compare.h"

namespace tw {

/// Further runs are proposed up to this wall time [s]. `check` refuses longer ones.
inline constexpr double longest_runs = 30 * 86400.0;
/// Further runs are offered up to so many times the study's own, or an hour; what needs more is no offer [-], [s].
inline constexpr double most_times_longer = 20, always_offered = 3600;
inline double longest_offer(double study_seconds) {
    return study_seconds > 0 ? std::clamp(most_times_longer * study_seconds, always_offered, longest_runs)
                             : longest_runs;
}

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
    double longest = longest_runs;   ///< further runs that are offered, see longest_offer [s]
    std::string borrowed = {};       ///< the scene that the discretisation error was taken from; empty: this one
};

/// One sentence that can be forwarded as it is: "Lift: SPH 3.1 % above interFoam, discretisation error ±9 %: no
/// difference shown; 40 min of finer runs would bring it to ±5 %." No per cent in it is without an interval or the words
/// that it has none.
std::string sentence_of(const Statement& statement);
/// The same without the quantity and the verdict, where these stand beside it: "SPH 3.1 % above interFoam, discretisation
/// error ±9 %; 40 min of further runs would bring it to ±5 %."
std::string finding_of(const Statement& statement);

/// "SPH failed: ...", for each run that did.
std::vector<std::string> failures_of(const Comparison& comparison);
/// The sentences on one quantity, to be forwarded: a verdict for every two runs where several sizes gave one, else how
/// far apart the values are; none where failures leave fewer than two runs.
std::vector<std::string> sentences_on(const Comparison& comparison, const Quantity& quantity);
/// The failures, and a sentence for each main quantity (drag, lift, trim moment, splash height), to be forwarded: the verdict where runs
/// of several sizes gave one, else how far apart the values are.
std::vector<std::string> verdict_sentences(const Comparison& comparison);

}  // namespace tw
