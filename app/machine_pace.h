#pragma once
#include <string>

#include "scene/scene.h"

namespace tw::app {

/// What runs on this machine have taught about its speed: $XDG_CACHE_HOME/twinwake/pace.json (~/.cache where that is
/// not set), by processor. The median of the last five of each method; 1 where nothing is known. A file that cannot be
/// read counts as nothing.
MachinePace machine_pace();
/// A short calibration (1 s): the particle engine's throughput over that of the table's machine, for both methods until
/// runs have taught more. Returns the pace [-].
double calibrate_pace();
/// A finished run: `expected` seconds by the table alone (pace 1), `taken` seconds. Runs under 10 s teach nothing. What
/// cannot be written is silently not learned.
void learn_pace(const std::string& method, double expected, double taken);

}  // namespace tw::app
