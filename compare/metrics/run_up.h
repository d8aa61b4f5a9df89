#pragma once
#include "compare/metrics/period_peaks.h"

namespace tw {

/// Height of the waterline on the seaward face of an obstacle in each raster frame of a time [m]: the top of the main
/// body of water in the farthest column up the face that it reaches without a gap from the sea, the highest of all rows
/// along y. Up to its crest: more is overtopping. Of records that know the face (numbers slope_crest_NAME,
/// obstacle_x_min_NAME, obstacle_x_max_NAME); else none.
PeakHistory waterline_on(const RunRecord& record, const std::string& obstacle, const WavePeriods& time);

/// Of every such obstacle, by the waterline's peaks (period_peaks.h):
///   run_up:NAME           mean of the highest in each period [m]
///   peak_median:run_up:NAME, peak_p90, peak_p98   what half, 90 and 98 % of the run-ups do not exceed (R_2%: of 149)
///   peak_third:run_up:NAME                        mean of the highest third
/// Beside the run-up of a regular wave stand the formulas of reference/run_up_formulas.h, beside R_2% that of EurOtop.
void add_run_up(Comparison& comparison, const PeakTime& time);

}  // namespace tw
