#include "spray/report/two_sprays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.h"

namespace tw::spray {
namespace {

struct Statistics {
    double volume = 0, energy = 0;
    Vec3 momentum = Vec3::Zero();
    double mean = 0, sauter = 0, middle = 0;  ///< diameters: by number, volume over area, half of the volume below
    double speed = 0, rise = 0;               ///< by volume; rise: of the mean velocity over level [rad]
    std::vector<double> diameters, speeds;    ///< sorted
};

Statistics statistics(std::span<const Droplet> droplets, const Liquid& liquid) {
    Statistics s;
    std::vector<std::pair<double, double>> sizes;
    double areas = 0, level = 0, up = 0;
    for (const Droplet& d : droplets) {
        const double volume = sphere_volume(d.diameter), mass = liquid.density * volume, v = d.velocity.norm();
        s.volume += volume, s.energy += 0.5 * mass * v * v, s.momentum += mass * d.velocity;
        s.mean += d.diameter / static_cast<double>(droplets.size());
        areas += d.diameter * d.diameter, s.sauter += std::pow(d.diameter, 3);
        s.speed += volume * v;
        level += volume * d.velocity.head<2>().norm(), up += volume * d.velocity.z();
        sizes.emplace_back(d.diameter, volume);
        s.diameters.push_back(d.diameter), s.speeds.push_back(v);
    }
    if (droplets.empty()) return s;
    s.sauter /= areas, s.speed /= s.volume, s.rise = std::atan2(up, level);
    std::ranges::sort(sizes);
    double below = 0;
    for (const auto& [d, volume] : sizes)
        if (s.middle = d, (below += volume) >= 0.5 * s.volume) break;
    std::ranges::sort(s.diameters), std::ranges::sort(s.speeds);
    return s;
}

}  // namespace

double largest_share_difference(std::span<const double> a, std::span<const double> b) {
    double largest = 0;
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        const double x = std::min(a[i], b[j]) * (1 + 1e-6);  // a table's digits make no difference
        while (i < a.size() && a[i] <= x) ++i;
        while (j < b.size() && b[j] <= x) ++j;
        largest = std::max(largest, std::abs(static_cast<double>(i) / static_cast<double>(a.size()) -
                                             static_cast<double>(j) / static_cast<double>(b.size())));
    }
    return largest;
}

ReportTable two_sprays(const NamedSpray& one, const NamedSpray& other, const Liquid& liquid) {
    const Statistics a = statistics(one.droplets, liquid), b = statistics(other.droplets, liquid);
    ReportTable t{"Two sprays",
                  {words("of the droplets at release"), words("unit"), numbers(one.name, "", 4),
                   numbers(other.name, "", 4), numbers("second over first", "", 3)}};
    const auto row = [&](const char* what, const char* unit, double x, double y) {
        t.rows.push_back({{what, unit, x, y, y / x}});
    };
    row("number", "", static_cast<double>(one.droplets.size()), static_cast<double>(other.droplets.size()));
    row("volume", "cm3", 1e6 * a.volume, 1e6 * b.volume);
    if (one.droplets.empty() || other.droplets.empty()) {
        t.notes.emplace_back("One of the two has no droplets: there is nothing else to compare.");
        return t;
    }
    row("mean diameter", "mm", 1e3 * a.mean, 1e3 * b.mean);
    row("Sauter's diameter, volume over area", "mm", 1e3 * a.sauter, 1e3 * b.sauter);
    row("diameter with half of the volume below it", "mm", 1e3 * a.middle, 1e3 * b.middle);
    row("mean speed, by volume", "m/s", a.speed, b.speed);
    row("largest speed", "m/s", a.speeds.back(), b.speeds.back());
    row("rise of the water over level", "degrees", a.rise / degree, b.rise / degree);
    row("kinetic energy", "J", a.energy, b.energy);
    row("momentum x", "kg m/s", a.momentum.x(), b.momentum.x());
    row("momentum y", "kg m/s", a.momentum.y(), b.momentum.y());
    row("momentum z", "kg m/s", a.momentum.z(), b.momentum.z());
    const auto n = static_cast<double>(one.droplets.size()), m = static_cast<double>(other.droplets.size());
    const double chance = 1.36 * std::sqrt((n + m) / (n * m));
    const double sizes = largest_share_difference(a.diameters, b.diameters),
                 speeds = largest_share_difference(a.speeds, b.speeds);
    t.notes.push_back(fmt::format(
        "Largest difference of the shares by number (Kolmogorov, Smirnov): {:.3f} of sizes, {:.3f} of speeds; two "
        "samples of one spray of independent droplets stay below {:.3f} in 95 of 100 cases.",
        sizes, speeds, chance));
    return t;
}

}  // namespace tw::spray
