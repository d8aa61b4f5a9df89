#pragma once
#include <limits>
#include <span>
#include <string>

namespace tw {

/// 95 % interval of a settled mean, or why there is none.
struct SettledMean {
    bool known = false;
    double value = std::numeric_limits<double>::quiet_NaN();       ///< [unit of the series]
    double half_width = std::numeric_limits<double>::quiet_NaN();  ///< 95 % interval of the mean alone [its unit]
    double from = 0, to = 0;                                       ///< the window used [s]
    double n_effective = 0;                                        ///< number of independent samples [-]
    std::string why_not;                                           ///< "record too short: about 0.8 s more is needed"
    double seconds_needed = 0;  ///< > 0: not known because the record is too short, by about this much [s]
    double second_opinion = std::numeric_limits<double>::quiet_NaN();  ///< by overlapping batch means [its unit]
    std::string limited_by;  ///< what makes the interval as wide as it is, where that is not the series: "half a voxel"
    bool unreliable = false;  ///< the two estimates of the interval differ by more than 1.5; the wider one is used
};

/// The conditions under which a settled mean is printed.
struct SettledRules {
    double from = 0;                    ///< no sample before this time counts [s]
    double flow_through = 0;            ///< length over speed [s]; 0: no such rule
    double fewest_flow_throughs = 1.5;  ///< after the cut [-]
    double fewest_independent = 10;     ///< n_eff [-]
    double largest_error = 0.02;        ///< standard error over |mean| [-]
    /// A standard error below this is fine whatever the mean; single values are no better [unit of the series].
    double allowed_error = 0;  ///< [unit of the series]
};

/// The mean of a series after its transient, with its 95 % interval:
/// - rows whose value is not finite are left out; the rest is averaged into equal time bins (means are kept exactly);
/// - transient cut by MSER-5 (mser.h);
/// - a straight trend under the autocorrelated noise of the rest (drift.h). Where its change D over the window
///   T is seen (beyond its 95 % interval), an exponential approach with a time constant of up to the whole record,
///   T_record, lacks up to D T_record/T of its limit: the value is known where that is at most twice the permitted
///   standard error, and its half width contains it, D's own interval and the mean's;
/// - n_eff = n / (2 tau_int), u = s / sqrt(n_eff), half width t_95 u with the degrees of freedom that a correlated
///   series has (correlated_t_95 in error_of_mean.h);
/// - overlapping batch means as a second opinion: where the two differ by more than 1.5 the wider one is used and the
///   value is marked unreliable.
/// A series of too few independent samples whose whole standard deviation s is within `allowed_error` or half of
/// `largest_error` (a height that flickers inside one voxel) is taken as it is, +- 2 s or D T_record/T, the larger. Not known, with the reason and
/// about how many seconds more would do, where a rule is not met; where `largest_error` alone is allowed, none is named for
/// a mean whose interval holds zero. A drift of less than about three and a half half
/// widths over the window is not told from noise and not contained.
SettledMean settled_mean(std::span<const double> time, std::span<const double> values, const SettledRules& rules);

}  // namespace tw
