#include "spray/extract/breakup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.h"

namespace tw::spray {
namespace {

/// Share of the number of drops below each diameter: the number density is the volume density over d^3.
class NumberDistribution {
public:
    NumberDistribution(double smallest, double q) {
        const double x = std::pow(std::log(1000.0), 1 / q);  // d_max / X
        double sum = 0;
        for (std::size_t i = 0; i < nodes; ++i) {
            d_[i] = smallest * std::pow(1 / smallest, static_cast<double>(i) / (nodes - 1));
            const double t = d_[i] * x;
            const double density = std::pow(t, q - 1) * std::exp(-std::pow(t, q)) / (t * t * t);
            if (i > 0) sum += 0.5 * (density + last_) * (d_[i] - d_[i - 1]);
            below_[i] = sum;
            last_ = density;
        }
        for (double& b : below_) b /= sum;
    }
    /// Diameter over d_max at the share u of the number.
    double at(double u) const {
        const auto above = std::upper_bound(below_.begin() + 1, below_.end() - 1, u);
        const auto i = static_cast<std::size_t>(above - below_.begin());
        const double s = (u - below_[i - 1]) / (below_[i] - below_[i - 1]);
        return d_[i - 1] + s * (d_[i] - d_[i - 1]);
    }

private:
    static constexpr std::size_t nodes = 400;
    std::array<double, nodes> d_{}, below_{};
    double last_ = 0;
};

}  // namespace

void check_breakup(const BreakupOptions& o) {
    if (!(o.critical_weber > 0)) throw InputError(fmt::format("critical_weber = {:g}: above 0", o.critical_weber));
    if (!(o.spread >= 1 && o.spread <= 10)) throw InputError(fmt::format("spread = {:g}: from 1 to 10", o.spread));
    if (!(o.smallest >= 0.01 && o.smallest <= 0.9))
        throw InputError(fmt::format("smallest = {:g}: from 0.01 to 0.9 of the largest fragment", o.smallest));
}

double largest_stable_diameter(double slip, const AirState& air, const Liquid& liquid, double critical_weber) {
    return critical_weber * liquid.surface_tension / (air.density * slip * slip);
}

std::vector<double> fragments(double volume, double d_max, const BreakupOptions& options, std::mt19937_64& random) {
    if (!(sphere_diameter(volume) > d_max)) return {sphere_diameter(volume)};
    const NumberDistribution distribution(options.smallest, options.spread);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> diameters;
    double made = 0;
    while (made < volume) {
        diameters.push_back(d_max * distribution.at(unit(random)));
        made += sphere_volume(diameters.back());
    }
    const double shrink = std::cbrt(volume / made);  // the last one is too much; all give a little
    for (double& d : diameters) d *= shrink;
    return diameters;
}

}  // namespace tw::spray
