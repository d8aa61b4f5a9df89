#pragma once
#include <limits>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "compare/uncertainty/convergence.h"

namespace tw {

/// One method's runs of a ladder.
struct LadderSide {
    std::string method;
    std::vector<double> spacing;   ///< finest first [m]
    std::vector<double> seconds;   ///< wall time of each, everything counted [s]
    std::vector<double> elements;  ///< particles or cells
    bool similar = true;           ///< false: runs of other hulls, speeds or options are among them
};

/// What a ladder says of one quantity and one method.
struct LadderValue {
    std::vector<Level> levels;                                      ///< the levels whose mean is known, finest first
    std::vector<std::string> absent;                                ///< why a level is missing, with its spacing
    double statistical = std::numeric_limits<double>::quiet_NaN();  ///< half width of the finest level's 95 % interval
    Estimate estimate;                                              ///< of the resolution; no levels: nothing known
    double uncertainty = std::numeric_limits<double>::quiet_NaN();  ///< of the finest value, statistics and resolution
};

enum class LadderVerdict { agree, differ, undecided, not_converged, not_comparable };
std::string to_string(LadderVerdict verdict);

struct LadderQuantity {
    std::string name, label, unit;
    std::vector<LadderValue> values;                               ///< one per side
    double difference = std::numeric_limits<double>::quiet_NaN();  ///< of the finest values, side 1 - side 0
    double interval = std::numeric_limits<double>::quiet_NaN();    ///< half width of its 95 % interval
    double per_cent = std::numeric_limits<double>::quiet_NaN();    ///< difference over the mean of the two [%]
    LadderVerdict verdict = LadderVerdict::not_comparable;
    std::string reason;
};

struct Ladder {
    std::string title;
    std::vector<LadderSide> sides;
    std::vector<LadderQuantity> quantities;
    double agree_within = 0.05;
};

/// Finished runs of one scene at several sizes, one method or two, in any order. The size of a level is its spacing at
/// the hull. For every judged quantity, with the finest values S, statistics u and resolution U_num of each method:
///
///   E = S_1 - S_0     U^2 = sum over both methods of u^2 + U_num^2     S = |S_0 + S_1| / 2
///   no U_num for a method                not converged
///   |E| <= U  and  U <= target S         agree
///   |E| <= U  and  U >  target S         undecided; the reason names the largest term
///   |E| >  U                             differ
///
/// (E and U as in ASME V&V 20; here each method is the other's reference.) Throws InputError: no record, more than two
/// methods, two runs of one method with one spacing.
Ladder build_ladder(std::vector<RunRecord> records, const CompareOptions& options = {});

/// Tables and verdicts for people, in markdown.
std::string ladder_text(const Ladder& ladder);
std::string ladder_json(const Ladder& ladder);
/// Spacing and values of one side, as `twinwake uncertainty` reads it; levels that lack a quantity leave it out whole.
std::string ladder_csv(const Ladder& ladder, std::size_t side);

}  // namespace tw
