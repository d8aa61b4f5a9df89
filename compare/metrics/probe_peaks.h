#pragma once
#include <span>
#include <string>
#include <vector>

#include "record/run_record.h"

namespace tw {

// Peaks of a probe's history that can be compared. The raw maximum cannot: where water lands on a wall a weakly
// compressible method shows the sound of it, rho c0 v, for a few steps, and any method's maximum grows with its sampling
// rate. All take the history as linear between its samples; samples that are not finite end a stretch.

/// Largest mean over a window of `width` [s]: the largest impulse that the place takes in that time, over the time.
/// NaN where no stretch is as long.
double largest_window_mean(std::span<const double> t, std::span<const double> x, double width);

/// The value that is exceeded during the share 1 - `part` of the time. NaN with fewer than two samples.
double time_percentile(std::span<const double> t, std::span<const double> x, double part);

/// First time at which the history is above `threshold` [s]: linear between the samples. NaN where it never is.
double arrival_time(std::span<const double> t, std::span<const double> x, double threshold);

/// Time over which peaks are means where the scene does not say one [s]: shorter peaks of pressure on a wall are sound and
/// sampling; structures of a hull answer in tens of milliseconds.
inline constexpr double default_filter = 5e-3;

/// That of a probe or body, by the longest that a record has for it (peak_filter of record/run_record.h) [s].
double filter_of(const std::vector<RunRecord>& records, const std::string& table, const std::string& name);

/// Water has arrived when a tenth of what it brings has.
inline constexpr double arrival_share = 0.1;

}  // namespace tw
