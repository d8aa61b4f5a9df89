#pragma once
#include <complex>
#include <span>

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

}  // namespace tw
