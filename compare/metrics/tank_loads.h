#pragma once
#include "compare/compare.h"

namespace tw {

/// Of what stands in a tank, at rest in its axes (a hull in still water, or all obstacles together): the force of the
/// water, and of the air where it is solved, over the time that all records cover. It is an event more often than a
/// settled flow, so besides the means of metrics/forces.h there are, without a statistical interval and judged by runs of
/// several sizes:
///   load_impulse_x, load_impulse_z   integral of the force along x and up [N s]
///   load_peak_x, load_peak_z         its largest mean over 5 ms, with its sign [N]; shorter peaks are sound and sampling
/// A direction is left out whose impulse is below 2 % of the other's in every record.
void add_tank_loads(Comparison& comparison);

}  // namespace tw
