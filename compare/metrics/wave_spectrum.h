#pragma once
#include <span>
#include <vector>

namespace tw {

/// A record of waves over a time T: variance and amplitudes of the lines n/T, and how well they tell a sea state of which
/// this record is one sample.
struct WaveSpectrum {
    double variance = 0;            ///< [m2]
    std::vector<double> f, energy;  ///< of the lines [1/s], [m2]
    double degrees = 0;             ///< of freedom of the variance, 2 (sum E)^2 / sum E^2 [-]
    double low = 0, high = 0;       ///< 95 % of the significant height of the sea state over that of the record [-]
};
/// Sets degrees, low and high from energies of lines that do not scatter.
void set_certainty(WaveSpectrum& spectrum, std::span<const double> energy);
/// Of `levels` at equal steps over the time T [s], lines from `lowest` to `highest` [1/s].
WaveSpectrum spectrum_of(std::span<const double> levels, double T, double lowest, double highest);

/// Heights between zero up-crossings of the level less its mean, in their order.
std::vector<double> crossing_heights(std::span<const double> levels);

/// Values at equal steps, the first at `from`, by cubics through the samples.
std::vector<double> at_equal_steps(std::span<const double> t, std::span<const double> x, double from, double step,
                                   int count);

}  // namespace tw
