#pragma once
#include "compare/compare.h"

namespace tw {

/// Of records with a wave, regular or irregular: the highest value in each of the last whole periods that all records
/// cover, from mean_from on (periods of encounter; of a sea its peak periods, where of two peaks nearer to each other
/// than a quarter of a period the higher counts), of
///   force_x, force_z          what stands fixed or is towed: along the wave's way and upward, mean over 5 ms; in oblique
///                             waves force_y too, each positive on the wave's way [N]
///   pressure:PROBE            mean over its filter [Pa]
///   height:GAUGE              in a sea, and where the scene gives the gauge a deck [m]
///   acceleration_centre:NAME  upward, of the hull and of free bodies at their centre of mass, over a fortieth of the
///                             period [m/s2]
///   acceleration_bow:NAME     at a hull's bow, at the end of a body that meets the waves
/// and of each, judged by grid studies, as far as the number of peaks bounds it (statistics/peak_statistics.h):
///   peak_mean:OF              their mean, of accelerations by the name acceleration_centre:NAME, acceleration_bow:NAME
///   peak_median:OF, peak_p90:OF, peak_p99:OF   what half, 90 and 99 % of them do not exceed: of 6, 29 and 299 peaks
///   peak_third:OF             mean of the highest third, of nine peaks and more
///   peak_events:OF            in how many periods it is above the scene's threshold ([[probe]] slam, deck) [-]
void add_wave_peaks(Comparison& comparison);

}  // namespace tw
