#include "waves/dispersion.h"

#include <algorithm>
#include <cmath>

namespace tw {

// By Newton's steps from above: the function is convex there.
double wave_number(double omega, double gravity, double depth) {
    const double k0 = omega * omega / gravity;
    double k = std::max(k0, omega / std::sqrt(gravity * depth));
    for (int step = 0; step < 50; ++step) {
        const double t = std::tanh(k * depth), f = k * t - k0, slope = t + k * depth * (1 - t * t);
        k -= f / slope;
        if (std::abs(f) < 1e-12 * k0) break;
    }
    return k;
}

double wave_frequency(double k, double gravity, double depth) { return std::sqrt(gravity * k * std::tanh(k * depth)); }

double group_speed_ratio(double k_depth) {
    return k_depth > 300 ? 0.5 : 0.5 + k_depth / std::sinh(2 * k_depth);  // sinh would overflow
}

}  // namespace tw
