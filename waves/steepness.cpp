#include "waves/steepness.h"

#include <cmath>
#include <numbers>

namespace tw {

double highest_wave(double length, double depth) {
    const double r = length / depth;
    return depth * (0.141063 * r + 0.0095721 * r * r + 0.0077829 * r * r * r) /
           (1 + 0.0788340 * r + 0.0317567 * r * r + 0.0093407 * r * r * r);
}

double ursell_number(double height, double length, double depth) {
    return height * length * length / (depth * depth * depth);
}

std::string wave_regime(double height, double length, double depth) {
    const double of_highest = height / highest_wave(length, depth);
    if (of_highest >= 1) return "breaking";
    if (of_highest > 0.9) return "nearly breaking";
    if (ursell_number(height, length, depth) > 40) return "cnoidal";
    const double k = 2 * std::numbers::pi / length, t = std::tanh(k * depth),
                 second = k * height / 8 * (3 - t * t) / (t * t * t);
    if (second < 0.02) return "linear";
    if (second < 0.1) return "Stokes, second order";
    return "Stokes, higher order";
}

std::string depth_regime(double length, double depth) {
    const double of_length = depth / length;
    return of_length > 0.5 ? "deep" : of_length < 0.05 ? "shallow" : "intermediate";
}

}  // namespace tw
