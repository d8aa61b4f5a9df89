#pragma once
#include <string>
#include <vector>

#include "base/numbers.h"
#include "compare/compare.h"

namespace tw {

/// What one method's run of an ablation gave: its values, and what they cost.
struct AblationSide {
    std::string method;
    std::vector<Quantity> quantities;   ///< one value each
    double processor = nan;             ///< processor seconds of solving per simulated second [-]
    double steps = nan;                 ///< time steps per simulated second [1/s]
    std::vector<EffectChoice> effects;  ///< the plan as solved
};
AblationSide ablation_side(RunRecord record);

/// The base, or one effect switched.
struct AblationRun {
    std::string name;          ///< "base", "surface_tension on", "viscosity on (with no_slip)"
    std::string effect = {};   ///< the one that was switched; empty: the base
    std::size_t against = 0;   ///< the run it is held against: the base, or for an effect that needs another, the run
                               ///< that has this other one on
    std::string why_not = {};  ///< why it was not run, or did not finish; empty where it did
    std::vector<AblationSide> sides = {};
};

/// One quantity of one method before and after one effect was switched:
///
///   E = after - before      U = sqrt(U_before^2 + U_after^2)      S = max(|before|, scale of the quantity)
///
/// In per cent E counts as above 0 where the value grows away from 0: a moment of -300 after -200 N m is +50 %.
///
/// seen: |E| > U. Two runs that differ by rounding alone give |E| > U in one of twenty quantities, as U is that of 95
/// %.
struct AblationChange {
    enum class Seen {
        unchanged,    ///< not one digit differs
        nothing,      ///< within the intervals
        seen,         ///< beyond them
        no_interval,  ///< it differs, but one of the values has no interval (the highest value of a probe)
        not_known     ///< one of the values is not known
    };
    std::string name, label, unit;
    MeanValue before, after;
    double difference = nan, interval = nan;         ///< [unit]
    double per_cent = nan, per_cent_interval = nan;  ///< over S [%]
    Seen seen = Seen::not_known;
    std::string predicted;  ///< what the plan says of the effect's influence on it; empty: nothing
    std::string remark;     ///< why it is not known
};
std::string to_string(AblationChange::Seen seen);

/// One method's answer to one effect switched.
struct AblationRow {
    std::size_t run = 0;    ///< in Ablation::runs
    std::string influence;  ///< what the plan says of the effect, in full
    std::vector<AblationChange> changes;
    double processor_before = nan, processor_after = nan;  ///< as in AblationSide [s]
    double cost = nan;                                     ///< change of it [%]
    double steps = nan;                                    ///< change of the number of time steps [%]
    double predicted_cost = nan;  ///< change that the plan's costs make [%]; of a particle run only
};

struct AblationMethod {
    std::string method;
    std::vector<AblationRow> rows;
};
struct Ablation {
    std::string title;
    std::vector<AblationRun> runs;  ///< the base first
    std::vector<AblationMethod> methods;
};

/// The base first. Runs that failed stay in the list with their reason and make no row, nor do runs that are held
/// against one of them. Throws InputError: no base, a base without values, or a run that is held against none before
/// it.
Ablation build_ablation(std::string title, std::vector<AblationRun> runs);

/// Change of the cost of a particle run that the two plans' costs make [%].
double predicted_cost_change(const std::vector<EffectChoice>& before, const std::vector<EffectChoice>& after);

/// Names of the quantities that stand in the table of all effects: the forces and heights, in a tank its probes.
std::vector<std::string> headline_of(const AblationMethod& method);
/// "+3.1 ± 0.5 %"; "+12 %" without an interval, "unchanged", "–".
std::string change_text(const AblationChange& change);
std::string ablation_summary(const Ablation& ablation);  ///< markdown: every effect against the main quantities
std::string ablation_text(const Ablation& ablation);     ///< the same, then effect by effect with every quantity
std::string ablation_json(const Ablation& ablation);
std::string ablation_csv(const Ablation& ablation);   ///< one row per effect, method and quantity; cost is one of them
std::string ablation_html(const Ablation& ablation);  ///< a page of its own

}  // namespace tw
