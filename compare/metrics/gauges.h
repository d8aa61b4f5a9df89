#pragma once
#include "compare/compare.h"

namespace tw {

/// Of every strain gauge on a body that bends (columns without a unit of the tables body_NAME, but for the attitude's):
///   strain_peak:BODY:GAUGE   the largest strain by magnitude, with its sign, over the time that all records cover [-]
/// Where one record's plate bends in the water and another's is rigid (attribute `structure`), a banner says so, and the
/// caveat of everything that is compared of the body: the difference contains the compliance. Call it after add_bodies.
void add_gauges(Comparison& comparison);

}  // namespace tw
