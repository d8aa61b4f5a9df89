#pragma once
#include <span>
#include <string>
#include <vector>

#include "compare/compare.h"

namespace tw {

/// Quantities per pressure and height probe of any source. `pressure:P1`: the raw peak, with the root mean square
/// difference of the histories in the remark, never judged. Judged by a grid study: `pressure_mean:P1`, the time mean;
/// and in tanks `pressure_peak:P1`, the largest mean over 5 ms or the probe's filter, `pressure_p99:P1`, exceeded 1 %
/// of the time, and `pressure_arrival:P1` [s].
void add_probes(Comparison& comparison, const CompareOptions& options);

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

// What reading a number off a history leaves open, whatever the resolution's own error (MeanValue::reading_below).

/// How far below and above the value the truth may lie [unit].
struct ReadingBounds {
    double below = 0, above = 0;  ///< [unit of the value]
};

/// Of an arrival [s]: to either side root of the sum of squares of the time from half the threshold on, or to twice the
/// threshold (where water comes slowly it has no sharper arrival), of half a spacing and of half the time between samples.
ReadingBounds reading_of_arrival(std::span<const double> t, std::span<const double> x, double first, double peak,
                                 const RunRecord& record);

/// Of a level [m]: half a spacing; none stands finer.
ReadingBounds reading_of_height(const RunRecord& record);

/// Puts it into a value that is known, with what it is.
void set_reading(MeanValue& value, const ReadingBounds& reading, const char* of);
inline constexpr const char* of_arrival = "the reading (threshold, spacing, sampling)";
inline constexpr const char* of_height = "the reading (half a spacing)";

}  // namespace tw
