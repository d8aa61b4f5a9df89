#include "compare/reference/overtopping.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tw {

std::optional<Overtopping> eurotop_overtopping(const WavesAtWall& of) {
    constexpr double gentlest = 2, power = 1.3, deviation_a = 0.15, deviation_b = 0.1, least_depth = 0.23,
                     highest = 3.5;
    if (!(of.height > 0) || !(of.freeboard >= 0) || !(of.cot_slope >= 0 && of.cot_slope <= gentlest)) return {};
    const double steep = gentlest - of.cot_slope, a = 0.09 - 0.01 * std::pow(steep, 2.1),
                 b = std::min(1.5 + 0.42 * std::pow(steep, 1.5), 2.35),
                 exponent = std::pow(b * of.freeboard / of.height, power),
                 length = of.gravity * of.period * of.period / (2 * std::numbers::pi);
    Overtopping out;
    out.rate = a * std::exp(-exponent) * std::sqrt(of.gravity * std::pow(of.height, 3));
    out.half_width = 1.96 * std::hypot(deviation_a, power * exponent * deviation_b) * out.rate;
    out.in_range = of.freeboard < highest * of.height && of.depth * of.depth > least_depth * of.height * length;
    return out;
}

}  // namespace tw
