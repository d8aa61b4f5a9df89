#pragma once
#include <string>
#include <string_view>

#include "record/run_record.h"

namespace tw {

// What the record of an empty twin is known by: the run of a scene with a wave without its free bodies.

/// Attribute of its record: the run hash of the run with the bodies.
inline constexpr std::string_view empty_twin_of_run = "empty_twin_of";
/// Its height gauge at the place of a body.
inline std::string gauge_of_empty_twin(const std::string& body) { return "without_" + body; }

/// In a record that was given its empty twin: levels at its gauges, one column a gauge [m], and in the attribute why the
/// twin that lies beside it does not count.
inline constexpr std::string_view empty_twin_table = "empty_twin", no_empty_twin = "no_empty_twin";

/// Gives the record of a run with bodies what its empty twin measured, in memory. A twin that is not finished, or not of
/// this very run (other size, wave, numerics), gives the reason in its place.
void take_empty_twin(RunRecord& record, const RunRecord& twin);

}  // namespace tw
