#pragma once
#include <span>

#include "compare/compare.h"

namespace tw {

/// Of every body that moves (tables body_NAME), over the time that the scene runs and all records cover. What the scene
/// determines has no statistical interval; a grid study judges all of them by the runs of several sizes:
///   body_depth:NAME    how far the centre of mass has come down at the end [m]
///   body_speed:NAME    velocity downward at the end [m/s]
///   body_peak:NAME     largest vertical force of the water, mean over 5 ms or its filter [N]; shorter peaks are sound and sampling
///   body_arrival:NAME  when that force has risen by a tenth of the way to its largest value [s]
///   body_impulse:NAME  what the water has given it upward, over that time [N s]
///   body_turn:NAME     how far it has turned at the end [deg]; where it turns at all
/// Remarks: root mean square of the depths' difference over the first one's range, the lag of the second history at which
/// the velocities differ least, and the ratio of the impulses.
void add_bodies(Comparison& comparison);

/// Of every strain gauge on a body that bends (columns without a unit of the tables body_NAME, but for the attitude's):
///   strain_peak:BODY:GAUGE   the largest strain by magnitude, with its sign, over the time that all records cover [-]
/// Where one record's plate bends in the water and another's is rigid (attribute `structure`), a banner says so, and the
/// caveat of everything that is compared of the body: the difference contains the compliance. Call it after add_bodies.
void add_gauges(Comparison& comparison);

/// The lag [s] by which `b` comes later than `a`: that of the least mean square of the difference of the two histories
/// where both are known, within a tenth of the time that they share; NaN where they share none.
double lag_of(std::span<const double> ta, std::span<const double> a, std::span<const double> tb,
              std::span<const double> b);

}  // namespace tw
