#pragma once
#include <string>
#include <vector>

#include "compare/metrics/regular_wave.h"

namespace tw {

// The wave at the place of a body or an obstacle in the run without it, which a record was given (record/wave_twin.h).

/// Of one record.
struct WaveWithout {
    bool known = false;    ///< the record was given such a run
    PeriodHarmonics wave;  ///< of the surface there [m]
};
WaveWithout wave_without(const RunRecord& record, const std::string& what, const WavePeriods& periods);

/// The one obstacle that a record's empty twin leaves out; empty: it has none, or several, whose forces are summed.
std::string obstacle_left_out(const RunRecord& record);

/// Why it is not there, of each record that was not given it, to end a definition with; `what`: "body".
std::string without_twin(const Comparison& comparison, const std::vector<WaveWithout>& waves, const std::string& what);

/// wave_without:NAME, twice its amplitude, beside the height asked for [m].
void add_wave_without(Comparison& comparison, const std::string& name, const std::vector<WaveWithout>& waves,
                      double height, const WavePeriods& periods);

}  // namespace tw
