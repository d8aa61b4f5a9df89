#pragma once
#include <string>
#include <string_view>

#include "record/run_record.h"

namespace tw {

// What the record of a scene's twin is known by: the run of a scene with a wave without its free bodies or obstacles (the
// empty twin), or, before a hull in a stream, without the wave (the calm twin).

/// Attribute of its record: the run hash of the whole scene's run.
inline constexpr std::string_view wave_twin_of_run = "wave_twin_of";
/// An empty twin's height gauge at the place of a body, or of an obstacle.
inline std::string gauge_of_empty_twin(const std::string& body) { return "without_" + body; }
/// Of both kinds: beside FOLDER/METHOD lies FOLDER/<this>/METHOD.
inline constexpr std::string_view empty_twins_folder = "without_bodies", calm_twins_folder = "without_wave";

/// In a record that was given its twin: levels at an empty twin's gauges, one column a gauge [m]; a calm twin's tables
/// `forces` and `hull_motion` (a free hull's) by these names; and in the attribute why the
/// twin that lies beside it does not count.
inline constexpr std::string_view empty_twin_table = "empty_twin", calm_forces_table = "calm_forces",
                                  calm_motion_table = "calm_hull_motion", no_wave_twin = "no_wave_twin";

/// Gives a record what its twin measured, in memory. A twin that is not finished, or not of this very run (other size,
/// wave, numerics), gives the reason in its place.
void take_wave_twin(RunRecord& record, const RunRecord& twin);

}  // namespace tw
