#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "compare/uncertainty/convergence.h"

namespace tw {

/// The true value of a quantity, as far as it is known.
struct Truth {
    double value = nan, half_width = 0;  ///< of its 95 % interval [unit]
    std::string standing;                ///< exact, measured, digitised, derived
    std::string source;                  ///< where it is from, in words
};

/// The result of one method's value against the truth (the rule stands at judge_against).
enum class Outcome { met, near, undecided, not_converged, missed, failed, not_run };
std::string to_string(Outcome outcome);       ///< "met", "near", "undecided", "not_converged", ...
std::string outcome_label(Outcome outcome);   ///< "met", "within the goal", "undecided", ...
Outcome outcome_of(const std::string& name);  ///< throws std::out_of_range

/// What a value was made for, as digests (suite/basis.h): of the scene, of how the case defines the quantity, and of a
/// measured truth. Empty: not known.
struct ValueBasis {
    std::string scene, definition, truth;
    bool known() const { return !scene.empty(); }
};

/// One method's value of one quantity. Half widths are of 95 % intervals [unit].
struct ValidatedValue {
    std::string method;
    double value = nan;                                             ///< [unit]
    double statistical = nan, discretisation = nan, choices = nan;  ///< parts of U_num [unit]: scatter, sizes, box
    double input = 0;                                               ///< what is not known of the scene [unit]
    double own_discretisation = nan;        ///< as every report of this program has it, whatever was chosen [unit]
    std::map<std::string, double> inputs;   ///< of which, by the name of the scene's number [unit]
    std::vector<MethodEstimate> by_method;  ///< what each method makes of the sizes [unit]
    double outer_below = nan, outer_above = nan;   ///< with what the run leaves out [unit]; nan: nothing has a bound
    double order = nan;                            ///< observed [-]; nan: none
    std::string convergence;                       ///< monotone, scattered, ..., or small_changes (bound_by_spread)
    std::vector<std::pair<double, double>> sizes;  ///< spacing at the hull [m] and value, finest first
    std::string why_not;                           ///< why there is no value, or no interval, or one by the spread
    std::string version = {}, date = {};           ///< of the program and of the day that made its runs
    ValueBasis made_for = {};                      ///< what it was made for
    bool kept = false;                             ///< of an earlier report: see keep_values
    std::string kept_note = {};  ///< why an earlier value was not kept, or what is not known of one that was

    // what judge_against makes of them
    double E = nan, U_num = nan, U_val = nan;  ///< [unit]
    Outcome outcome = Outcome::not_run;

    bool holds() const { return E <= U_val && -E <= U_val; }
};

struct ValidatedQuantity {
    std::string name, label, unit;
    Truth truth;
    double goal = nan;                              ///< |E| that is aimed at [unit]
    double scale = nan;                             ///< what per cent refer to: |truth|, or what the suite says [unit]
    std::map<std::string, std::string> known_miss;  ///< by method: why it is known to miss
    std::vector<ValidatedValue> values;             ///< one per method that was asked
    std::map<std::string, ValueBasis> basis = {};   ///< by method: what its values have to be made for
};

/// The cost of one method in a case, all sizes together.
struct CaseCost {
    std::string method;
    double core_seconds = 0, seconds = 0;  ///< processor time, wall time [s]
    int runs = 0;
};

struct ValidatedCase {
    std::string name, title, family, tier, why, shows, shows_not;
    std::vector<std::string> scenes;  ///< files
    std::string why_not;              ///< why it was not run; empty: it was
    std::vector<ValidatedQuantity> quantities;
    std::vector<CaseCost> costs;
};

/// The results of one call of `twinwake validate`.
struct ValidationReport {
    std::string title, tier, version, machine, date, command;
    std::vector<ValidatedCase> cases;
    std::string estimator = {};  ///< of the discretisation error, if not this program's own: see judge_by
};

/// Judges one value by ASME V&V 20-2009, all as half widths of 95 % intervals (the standard's u times 2):
///
///   E = S - D      U_num^2 = U_statistical^2 + U_discretisation^2 + U_choices^2
///   U_val^2 = U_num^2 + U_input^2 + U_D^2
///
///   no value                         failed (why_not says it)
///   no U_num                         not converged
///   |E| <= U_val  and  U_val <= goal  met: the interval holds the truth and is as narrow as was aimed at
///   |E| <= U_val  and  U_val >  goal  undecided: the interval holds the truth and is wider than that
///   |E| >  U_val  and  |E| <= goal    near: within the goal, and the interval claims more than that
///   |E| >  U_val  and  |E| >  goal    missed: an error of the model, or of the interval
void judge_against(ValidatedValue& value, const ValidatedQuantity& quantity);

/// Values whose changes grow from size to size have no limit that could be estimated, but may still all lie close
/// together: where three times their whole range, 3 (phi_max - phi_min), is at most the goal, that is the
/// discretisation error, and `convergence` becomes small_changes. The factor is that of Eca & Hoekstra for data without
/// an order (2014, doi:10.1016/j.jcp.2014.01.006). Nothing happens to other values.
void bound_by_spread(ValidatedValue& value, const ValidatedQuantity& quantity);
inline constexpr const char* small_changes = "small changes";
inline constexpr double factor_of_spread = 3;

/// Puts what `earlier` knows in the place of values that `report` has not run, case by case, by the name of the
/// quantity and the method, judges them by the truths and goals of `report`, and marks them as kept. Their cost comes
/// along. A value whose scene, definition or measured truth was another is refused and stays not run, with a note that
/// says so; a value of which either report does not say what it was made for is kept with a note that says that.
/// Returns the refused ones, for people: "weir, Mean level, SPH: not run with this version: its scene has changed since
/// 0.1.0 (4bc74fc4), 2026-11-29".
std::vector<std::string> keep_values(ValidationReport& report, const ValidationReport& earlier);

/// Judges every value anew with the discretisation error by one of uncertainty_methods(): "trend_and_noise" is what
/// every report has (of two sizes the GCI with an assumed order); of the others a value without an uncertainty is not
/// converged for the reason that the method gives. The outer intervals, which are made with this program's own, are
/// left out.
void judge_by(ValidationReport& report, const std::string& method);

/// How often the intervals of one method of estimating the discretisation error hold the truth, of one solver's values.
struct EstimatorSummary {
    std::string estimator, method;
    int values = 0, given = 0;         ///< that have a value, and those of them that have an interval by it
    int holds = 0;                     ///< |E| <= U_val with it, of those given
    int narrow = 0, narrow_holds = 0;  ///< U_num with it below 15 % of the value
    double median_U = nan;             ///< of the discretisation error alone, over the scale [%]
};
/// In the order of uncertainty_methods(), each for the methods in the order of methods().
std::vector<EstimatorSummary> estimators_of(const ValidationReport& report);

/// Of all values, in the order of methods().
std::vector<std::string> methods_of(const ValidationReport& report);

/// Missed, or not converged and farther away than the goal: not what the suite aims at.
bool falls_short(const ValidatedValue& value, const ValidatedQuantity& quantity);

/// What the cases of one family say of one method's intervals. Counted are values that have an interval.
struct FamilySummary {
    std::string family, method;  ///< family "": all
    int values = 0, without_interval = 0;
    int inner = 0;                     ///< |E| <= U_val
    int outer = 0;                     ///< the same with the outer interval, where there is one, in place of U_num
    int narrow = 0, narrow_inner = 0;  ///< U_num below 15 % of the value; of these |E| <= U_val
    int met = 0, fall_short = 0;
    double median_error = nan;  ///< |E| over the scale, of all that have a value [%]
    double core_seconds = 0;    ///< [s]
};
inline constexpr double narrow_share = 0.15;
/// All families together first, then each in the order of the cases; methods in the order of methods().
std::vector<FamilySummary> summaries_of(const ValidationReport& report);

/// A value that became worse, better, new, or is gone since an earlier report.
struct ValidationChange {
    enum class Kind { worse, better, new_value, gone } kind = Kind::worse;
    std::string what;  ///< "still_tank, Lift, SPH"
    std::string was, is;
};
/// Worse: its outcome is a worse one, or its error has grown by more than a quarter of the goal; better: the reverse. A
/// value that neither is, is not listed. New and gone are those whose case, quantity and method only one report has
/// with a value.
std::vector<ValidationChange> changes_between(const ValidationReport& earlier, const ValidationReport& now);

}  // namespace tw
