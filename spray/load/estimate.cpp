#include "spray/load/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/errors.h"

namespace tw::spray {
namespace {

bool on_square(const Arrival& a, const Window& w) {
    return std::abs(a.across - w.across) <= 0.5 * w.edge && std::abs(a.along - w.along) <= 0.5 * w.edge;
}

/// Law and pulse of one droplet.
struct Impact {
    double time, peak, impulse, section;  ///< [s], [N], [N s], [m2]
    bool within;
    Pulse pulse;
};

Impact impact_of(const Arrival& a, const LoadOptions& o) {
    const double F = peak_force(a.normal_speed, a.diameter, o.liquid),
                 I = impulse(a.normal_speed, a.diameter, o.liquid);
    return {a.time,
            F,
            I,
            std::numbers::pi / 4 * a.diameter * a.diameter,
            within_law(a.normal_speed, a.diameter, o.liquid),
            Pulse(o.shape, F, I)};
}

/// Impacts on the window's square from so early that they may press within it, to its end.
std::vector<Impact> impacts_on(std::span<const Arrival> arrivals, const Window& w, const LoadOptions& o) {
    std::vector<Impact> all;
    const double end = w.from + w.length;
    for (const Arrival& a : arrivals) {
        if (a.time >= end) break;
        if (!on_square(a, w)) continue;
        const Impact i = impact_of(a, o);
        if (a.time + i.pulse.duration() <= w.from) continue;
        if (i.within || o.keep_outside) all.push_back(i);
    }
    return all;
}

/// Means over the samples of the pressure that the impacts make together.
std::vector<double> pressures(std::span<const Impact> impacts, const Window& w, double step) {
    const auto n = static_cast<std::size_t>(std::max(1.0, std::ceil(w.length / step - 1e-9)));
    std::vector<double> p(n);
    for (const Impact& i : impacts) {
        const double begin = (i.time - w.from) / step, end = (i.time + i.pulse.duration() - w.from) / step;
        const auto first = static_cast<std::size_t>(std::clamp(std::floor(begin), 0.0, static_cast<double>(n)));
        const auto last = static_cast<std::size_t>(std::clamp(std::ceil(end), 0.0, static_cast<double>(n)));
        for (std::size_t k = first; k < last; ++k) {
            const double t = w.from + static_cast<double>(k) * step - i.time;
            p[k] += (i.pulse.impulse_until(t + step) - i.pulse.impulse_until(t)) / (step * w.area());
        }
    }
    return p;
}

/// The estimates from impacts that touch the window in time; those before it count for the direct ones only.
Estimate from_impacts(std::span<const Impact> impacts, const Window& w, const LoadOptions& o, std::mt19937_64& random,
                      int repeats) {
    Estimate e;
    const double A = w.area(), T = w.length;
    std::vector<const Impact*> here;
    for (const Impact& i : impacts)
        if (i.time >= w.from) here.push_back(&i);
    e.droplets = here.size();
    for (const Impact* i : here) {
        e.outside += !i->within;
        e.peak += i->peak / A;
        e.average += i->impulse / (T * A);
    }
    std::uniform_real_distribution<double> unit(0, 1);
    for (int r = 0; r < repeats && !here.empty(); ++r) {
        std::shuffle(here.begin(), here.end(), random);
        double filled = 0;
        for (const Impact* i : here) {
            const double tau = i->pulse.duration(), span = std::max(T, tau);
            e.monte_carlo += span / T * i->pulse.force(span * unit(random)) / (A * repeats);
            const bool at_peak = filled < A;
            e.corrected += (at_peak ? i->peak : i->pulse.force(tau * unit(random))) / (A * repeats);
            filled += i->section;
        }
    }
    const double step = std::min(o.sampling, T);
    const auto p = pressures(impacts, w, step);
    e.direct_mean = std::accumulate(p.begin(), p.end(), 0.0) / static_cast<double>(p.size());
    e.direct_peak = *std::ranges::max_element(p);
    return e;
}

void check(const Window& w, const LoadOptions& o) {
    if (!(w.edge > 0) || !(w.length > 0))
        throw InputError(fmt::format("window: an edge of {:g} m for {:g} s; both are above 0", w.edge, w.length));
    if (!(o.sampling > 0) || o.repeats < 1) throw InputError("load: sampling and repeats are above 0");
}

Interval middle_95(std::vector<double>& values) {
    std::ranges::sort(values);
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
    };
    return {at(0.025), at(0.975)};
}

}  // namespace

std::vector<Arrival> within(std::span<const Arrival> arrivals, const Window& w) {
    std::vector<Arrival> result;
    for (const Arrival& a : arrivals)
        if (a.time >= w.from && a.time < w.from + w.length && on_square(a, w)) result.push_back(a);
    return result;
}

Estimate estimate(std::span<const Arrival> arrivals, const Window& window, const LoadOptions& options) {
    check(window, options);
    std::mt19937_64 random(options.seed);
    return from_impacts(impacts_on(arrivals, window, options), window, options, random, options.repeats);
}

LoadCurve direct_load(std::span<const Arrival> arrivals, const Window& window, const LoadOptions& options) {
    check(window, options);
    return {window.from, options.sampling, pressures(impacts_on(arrivals, window, options), window, options.sampling)};
}

Intervals bootstrap(std::span<const Arrival> arrivals, std::span<const Window> windows, const LoadOptions& options,
                    int draws) {
    std::vector<std::vector<Impact>> impacts;
    for (const Window& w : windows) {
        check(w, options);
        impacts.push_back(impacts_on(arrivals, w, options));
    }
    std::mt19937_64 random(options.seed);
    std::uniform_int_distribution<std::size_t> any_window(0, windows.size() - 1);
    std::vector<double> peak, average, corrected, direct_mean, direct_peak;
    for (int draw = 0; draw < draws; ++draw) {
        const std::size_t k = any_window(random);
        std::vector<Impact> resampled;
        if (!impacts[k].empty()) {
            std::poisson_distribution<std::size_t> how_many(static_cast<double>(impacts[k].size()));
            std::uniform_int_distribution<std::size_t> any(0, impacts[k].size() - 1);
            const std::size_t n = how_many(random);
            for (std::size_t i = 0; i < n; ++i) resampled.push_back(impacts[k][any(random)]);
        }
        const Estimate e = from_impacts(resampled, windows[k], options, random, 1);
        peak.push_back(e.peak), average.push_back(e.average), corrected.push_back(e.corrected);
        direct_mean.push_back(e.direct_mean), direct_peak.push_back(e.direct_peak);
    }
    return {middle_95(peak), middle_95(average), middle_95(corrected), middle_95(direct_mean), middle_95(direct_peak)};
}

std::vector<Window> tiled(const Sensor& sensor, const Window& window) {
    std::vector<Window> windows{window};
    const int side = static_cast<int>(std::floor((0.5 * sensor.extent - 0.5 * window.edge) / window.edge + 1e-9));
    for (int i = -side; i <= side; ++i)
        for (int j = -side; j <= side; ++j) {
            if (i == 0 && j == 0) continue;
            Window w = window;
            w.across += i * window.edge, w.along += j * window.edge;
            windows.push_back(w);
        }
    return windows;
}

bool wider_than_spray(std::span<const Arrival> arrivals, const Window& w) {
    if (arrivals.empty()) return true;
    const auto [left, right] = std::ranges::minmax(arrivals, {}, &Arrival::across);
    const auto [low, high] = std::ranges::minmax(arrivals, {}, &Arrival::along);
    return w.edge > right.across - left.across || w.edge > high.along - low.along;
}

}  // namespace tw::spray
