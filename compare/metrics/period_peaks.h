#pragma once
#include <string>
#include <vector>

#include "compare/compare.h"
#include "compare/metrics/wave_samples.h"

namespace tw {

// Peaks in waves, one a period, and what is said of them.

/// The periods of which a peak is taken, none of a focused wave: it is one event.
struct PeakTime {
    WavePeriods periods;
    bool regular = false;  ///< each period is like the one before
};
/// Whole periods at the end of the time that all records cover, from mean_from on; of a sea peak periods.
PeakTime peak_time(const Comparison& comparison);

/// A history of which peaks are taken; without times: the record has none.
struct PeakHistory {
    std::vector<double> t, x;        ///< [s], [unit]
    std::vector<double> lasts = {};  ///< what of it is no sound; empty: there is none
};
/// The highest mean over `window` [s] in each period, 0: the highest sample. Of two peaks of irregular waves that are
/// nearer to each other than a quarter of a period the higher counts.
std::vector<double> peaks_of(const std::vector<double>& t, const std::vector<double>& x, double window,
                             const PeakTime& time);

/// Something of which each record has a history.
struct PeakedThing {
    std::string name, label, unit, definition;
    std::string name_of_mean = {};                ///< empty: peak_mean:NAME
    double window = 0;                            ///< [s]
    double threshold = NAN;                       ///< of an event; NaN: none is asked for
    std::vector<int> percentiles = {50, 90, 99};  ///< [%]
    std::vector<PeakHistory> histories = {};
};
/// Adds what wave_peaks.h lists of it.
void add_peaks(Comparison& comparison, const PeakedThing& thing, const PeakTime& time);

}  // namespace tw
