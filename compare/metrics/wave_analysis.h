#pragma once
#include <complex>
#include <span>
#include <vector>

namespace tw {

/// Incident and reflected part of a wave of number k [1/m] from complex amplitudes at places x along its direction, A =
/// a_i exp(i k x) + a_r exp(-i k x), by least squares (two gauges: Goda & Suzuki 1976; three: Mansard & Funke 1980).
struct WaveParts {
    std::complex<double> incident = 0, reflected = 0;
    double misfit = 0;   ///< root mean square of what is left, over |a_i| [-]; of two gauges 0
    bool apart = false;  ///< the places tell the two parts from one another: none stand multiples of L/2 apart alone
};
WaveParts split_waves(std::span<const double> x, std::span<const std::complex<double>> amplitude, double k);

/// The same where the wave loses height on its way and has a length of its own: a complex number kappa in place of k, A =
/// a_i exp(i kappa x) + a_r exp(-i kappa x), both parts losing height as they run, by Gauss-Newton steps from split_waves;
/// of three gauges exactly, of more by least squares. `incident` and `reflected` in the middle of the gauges. A length
/// that is wrong by a hundredth shifts the phases of gauges 0.6 wave lengths apart by 0.04 rad, which else looks like a
/// part that does not fit.
/// Not `apart` with fewer than three places, or where kappa is more than a tenth away from k.
struct DecayingParts : WaveParts {
    std::complex<double> kappa = 0;  ///< [1/m]; its imaginary part is the loss
};
DecayingParts split_decaying_waves(std::span<const double> x, std::span<const std::complex<double>> amplitude,
                                   double k);

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

/// sum E^4 / sum f E^4 over lines of frequency f [1/s] (Young 1995, Ocean Eng. 22, 669) [s].
double peak_period_of(std::span<const double> f, std::span<const double> energy);
/// Energies of a record that is no whole number of repeat periods, whose lines scatter: means over `reach` [1/s] to both
/// sides [m2].
std::vector<double> smoothed(const WaveSpectrum& spectrum, double reach);

/// Heights between zero up-crossings of the level less its mean, in their order.
std::vector<double> crossing_heights(std::span<const double> levels);

/// Values at equal steps, the first at `from`, by cubics through the samples.
std::vector<double> at_equal_steps(std::span<const double> t, std::span<const double> x, double from, double step,
                                   int count);

}  // namespace tw
