#pragma once

namespace tw {

/// Linear waves on still water of uniform depth: omega^2 = g k tanh(k d) (Airy 1845; Lamb, Hydrodynamics, 229).

/// k of a frequency omega [rad/s] > 0, to rounding [1/m]. `gravity` [m/s2] and `depth` [m] > 0.
double wave_number(double omega, double gravity, double depth);
/// omega of a wave number k [1/m] > 0 [rad/s].
double wave_frequency(double k, double gravity, double depth);
/// Speed of the energy over the speed of the crests, cg/c = 1/2 (1 + 2 k d / sinh(2 k d)), from 1/2 (deep) to 1 [-].
double group_speed_ratio(double k_depth);

}  // namespace tw
