#pragma once
#include <algorithm>

namespace tw {

/// Shepard sum at a distance d from water that fills a half space (equations/kernel.h, in three dimensions; in two
/// it is 0 to 0.003 more):
///
///   S = integral_d^2h A(z) dz,   A(z) = 2 pi integral_z^2h W r dr
///   S = T^6 (7/2 - 9/2 T + 3/2 T^2),   T = 1 - d/2h
///
/// `d` in h.
inline double half_space_support(double d) {
    const double T = std::clamp(1 - d / 2, 0.0, 1.0);
    return T * T * T * T * T * T * (3.5 - 4.5 * T + 1.5 * T * T);
}

/// The distance at which the Shepard sum is this [h]: 0 from a half on, 2 without any.
inline double half_space_distance(double support) {
    double low = 0, high = 2;
    for (int i = 0; i < 20; ++i) (half_space_support((low + high) / 2) > support ? low : high) = (low + high) / 2;
    return support >= 0.5 ? 0 : (low + high) / 2;
}

}  // namespace tw
