#pragma once
#include <string>
#include <vector>

#include "record/run_record.h"
#include "statistics/settled_mean.h"

namespace tw {

/// When a run's answer has settled. A mean is settled where the comparison's own rules (settled_mean.h) know it, with a
/// 95 % interval of at most `interval` of its scale to each side, and where a slow approach to its limit (approach.h)
/// lacks at most `lacking` of the scale in it, one standard error included. The scale is |mean|, of the trim moment at
/// least a tenth of lift times length.
///
/// A rule that looks again and again until a scatter is small stops where it happens to look small. Therefore it has to
/// hold at this look and at the one before, looks are at frames whose number has grown by `between_looks`, and the
/// comparison takes the mean of a run that was ended so as known to `known_to` of its scale at best. How often these
/// intervals hold the truth then: docs/results/settled.md.
struct SettledStop {
    double interval = 0.015;      ///< half width over the scale [-]
    double lacking = 0.0075;      ///< over the scale [-]
    double between_looks = 0.03;  ///< growth of the number of frames [-]
    /// Period of waves that the start leaves [s], 0: none. With one, the means over the last two whole periods and over
    /// the last one lie within `interval` of each other, and a run ends a whole number of periods after means begin.
    double period = 0;                        ///< [s]
    static constexpr double known_to = 0.02;  ///< half width over the value, of what is known only [-]
};

/// One mean that the run is asked for.
struct LoadMean {
    std::string name;
    bool settled = false;
    double share = 0;        ///< half width of its interval over its scale [-]
    std::string still = {};  ///< what it lacks, where it is not settled
};
struct SettledLoads {
    bool settled = false;
    std::vector<LoadMean> means;
    /// "drag known to 0.8 %, ..." of the means, or what the first of them lacks.
    std::string sentence() const;
};

/// Of the loads of a run so far: drag, lift, trim moment, and the wetted length, which only has to be known. From the
/// record's tables alone, up to the last row of `samples`, so that a resumed run is ended where it would
/// have been. Not settled while fewer than the comparison's flow-through times have passed since means begin.
SettledLoads settled_loads(const RunRecord& record, const SettledStop& rule);
/// Whether the last frame of `samples` is one at which the rule is looked at; others cost nothing.
bool is_look(const RunRecord& record, const SettledStop& rule);

/// The interval of a load of a run that was ended so, whose |values| refer to at least `least_scale` [unit]; others are
/// left as they are.
void widen_where_ended(const RunRecord& record, SettledMean& mean, double least_scale = 0);

/// Attribute of a record: why its run ended. Absent in older records and where its duration alone ends a run.
inline constexpr const char* ended_by = "ended_by";
inline constexpr const char* by_settling = "settled";
inline constexpr const char* at_bound = "bound";  ///< before its loads had settled
/// Number of the record: how long the run might have gone on at most [s].
inline constexpr const char* bound_number = "duration_bound";

}  // namespace tw
