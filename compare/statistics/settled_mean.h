#pragma once
#include <span>

#include "compare/compare.h"

namespace tw {

/// What a settled mean must fulfil to be printed.
struct SettledRules {
    double from = 0;                    ///< no sample before this time counts [s]
    double flow_through = 0;            ///< length over speed [s]; 0: no such rule
    double fewest_flow_throughs = 1.5;  ///< after the cut
    double fewest_independent = 10;     ///< n_eff
    double largest_error = 0.02;        ///< standard error over |mean|
    /// A standard error below this is fine whatever the mean; single values are no better [unit of the series].
    double allowed_error = 0;
};

/// The mean of a series after its transient, with its 95 % interval:
/// - rows whose value is not finite are left out; the rest is averaged into equal time bins (means are kept exactly);
/// - transient cut by MSER-5 (statistics/mser.h);
/// - n_eff = n / (2 tau_int), u = s / sqrt(n_eff), half width t_95(n_eff - 1) u;
/// - overlapping batch means as a second opinion: where the two differ by more than 1.5 the wider one is used and the
///   value is marked unreliable.
/// A series of too few independent samples whose whole standard deviation s is within `allowed_error` or half of
/// `largest_error` (a slow creep, a height that flickers inside one voxel) is taken as it is, +- 2 s. Not known, with
/// the reason and about how many seconds more would do, where a rule is not met.
MeanValue settled_mean(std::span<const double> time, std::span<const double> values, const SettledRules& rules);

}  // namespace tw
