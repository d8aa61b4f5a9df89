#pragma once
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "spray/load/impact.h"
#include "spray/load/pulse.h"
#include "spray/load/sensor.h"

namespace tw::spray {

/// How droplets become a load.
struct LoadOptions {
    Liquid liquid;
    PulseShape shape = PulseShape::root;
    bool keep_outside = true;  ///< droplets outside the law's Re and We are loaded by it all the same; false: left out
    int repeats = 200;         ///< Monte Carlo draws, whose mean is given
    double sampling = 1e-4;    ///< width of the direct load's samples [s]
    std::uint64_t seed = 1;
};

/// A square of the sensor during a span of time.
struct Window {
    double edge = 0.01;              ///< [m]
    double from = 0, length = 3e-3;  ///< [s]
    double across = 0, along = 0;    ///< its centre on the sensor [m]
    double area() const { return edge * edge; }
};

/// The droplets of a window.
std::vector<Arrival> within(std::span<const Arrival> arrivals, const Window& window);

/// Pressures on one window [Pa]. With A its area, T its length, F_i and I_i peak and impulse of droplet i, f_i its pulse:
///
///   peak         sum F_i / A                     all at their peak at once (study)
///   average      sum I_i / (T A)                 (study); unbiased for the mean pressure of a steady stream
///   monte_carlo  w sum f_i(s_i) / A              the pressure at one moment, arrivals uniform over the window: s_i from
///                                                0 to max(T, duration_i), w = max(T, duration_i) / T. Unbiased too
///   corrected    (sum_P F_i + sum_rest f_i(s_i)) / A  (study): droplets drawn at random whose cross-sections together
///                                                fill A stand at their peak, the others anywhere in their pulse
///   direct_mean, direct_peak                     every pulse at its own arrival time, those from before the window
///                                                included; the peak is of means over `sampling`
///
/// The study's peak and corrected value grow with T in a steady stream, since they let droplets act together that arrive
/// up to T apart; only where T is about a pulse's duration do they mean a pressure at one moment.
struct Estimate {
    std::size_t droplets = 0;
    std::size_t outside = 0;  ///< of them outside Re > 230 and We > 50
    double peak = 0, average = 0, monte_carlo = 0, corrected = 0, direct_mean = 0, direct_peak = 0;

    /// Below this number an estimate is given as an interval only.
    static constexpr std::size_t enough = 30;
};
/// `arrivals`: in the order of time. Throws InputError: edge, length or sampling not above 0.
Estimate estimate(std::span<const Arrival> arrivals, const Window& window, const LoadOptions& options);

/// Direct pressure on a square of the sensor: means over `sampling` from `from` on [Pa].
struct LoadCurve {
    double from = 0, step = 0;  ///< [s]
    std::vector<double> pressure;
};
LoadCurve direct_load(std::span<const Arrival> arrivals, const Window& window, const LoadOptions& options);

/// 2.5 % and 97.5 % of the estimates of `draws` resampled sets. Of droplets: as many as a Poisson number says, drawn with
/// replacement from those that came within a pulse of the window. Of windows: each
/// draw first takes one of `windows`, at random; one window alone leaves the droplets only.
struct Interval {
    double low = 0, high = 0;
};
struct Intervals {
    Interval peak, average, corrected, direct_mean, direct_peak;
};
Intervals bootstrap(std::span<const Arrival> arrivals, std::span<const Window> windows, const LoadOptions& options,
                    int draws);

/// Windows of that edge and time that lie side by side on the sensor, the one in its centre first.
std::vector<Window> tiled(const Sensor& sensor, const Window& window);

/// True when a window is wider than the part of the sensor that any droplet reaches.
bool wider_than_spray(std::span<const Arrival> arrivals, const Window& window);

}  // namespace tw::spray
