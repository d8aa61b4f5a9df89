#pragma once
#include "compare/compare.h"

namespace tw {

/// Of every box of the table `volume` (record/water_in_box.h), judged by grid studies:
///   volume_gain:NAME   what it holds at the end of the time that all records cover less what it held at the beginning:
///                      what came in, without what left again [m3, of two dimensions m3/m]
///   volume_rate:NAME   with waves: how fast that grows over the last whole periods that all records cover, from mean_from
///                      on [m3/s, m3/m/s]: mean of the gains of the periods over their length T, with its 95 % interval
///
///   rate = 1/N sum_n (V(t_n + T) - V(t_n)) / T
///
/// from how far the periods differ; of a sum of waves, whose T is the peak period, that of a correlated series. Where the
/// scene knows a wall before the box (numbers wall_freeboard_NAME, ...) it is, over the width of the box, in its place
///   overtopping:NAME   per metre of crest [m3/m/s], with EurOtop's formula as reference (reference/overtopping.h)
void add_volumes(Comparison& comparison);

}  // namespace tw
