#pragma once
#include <string>

namespace tw::app {

/// How long this machine takes, with this method, for work that the table of scene/cost/cost_estimate.cpp calls one second:
/// the median of the last nine runs; before these, what was calibrated; 1 where nothing is known.
/// $XDG_CACHE_HOME/twinwake/pace.json (~/.cache where that is not set) holds it, by processor; a file that cannot be
/// read counts as nothing.
double machine_pace(const std::string& method);
/// A short calibration (1 s): the particle engine's throughput over that of the table's machine, for all methods until
/// runs have taught more. Returns the pace [-].
double calibrate_pace();
/// The same of the GPU here, for the method that names it (pace_of in solvers.h): how long it takes for work that the
/// table calls one second of one core. Takes some seconds.
double calibrate_gpu_pace(const std::string& method);
/// Whether this method has a calibration of its own, or runs have taught it.
bool knows_pace(const std::string& method);
/// Of one method, or of all those that have none ("").
void remember_calibration(const std::string& method, double pace);
/// A finished run: `expected` seconds by the table alone (pace 1), `taken` seconds, both of processor time, or by the clock
/// for a GPU. `undisturbed`: other programs beside it did not make that time longer. One under 10 s, or disturbed, teaches
/// only that the machine is faster than was known; and what was learned before is forgotten where it was more than twice
/// as slow as a later run: that was a busy hour. What cannot be written is silently not learned.
void learn_pace(const std::string& method, double expected, double taken, bool undisturbed);

}  // namespace tw::app
