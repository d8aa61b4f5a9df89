#pragma once
#include "compare/compare.h"

namespace tw {

/// The table of a record's force at every step: a method that solves air has it in one of its own, `forces_total`, with
/// the air's; null: it has neither fx nor fz.
const Table* loads_of(const RunRecord& record);

/// Of what stands in a tank, at rest in its axes (a hull in still water, or all obstacles together): the force of the
/// water, and of the air where it is solved, over the time that all records cover. It is an event more often than a
/// settled flow, so besides the means of metrics/forces.h there are, without a statistical interval and judged by runs of
/// several sizes:
///   load_impulse_x, load_impulse_z   integral of the force along x and up [N s]
///   load_peak_x, load_peak_z         its largest mean over 5 ms, with its sign [N]; shorter peaks are sound and sampling
/// A direction is left out whose impulse is below 2 % of the other's in every record.
void add_tank_loads(Comparison& comparison);

}  // namespace tw
