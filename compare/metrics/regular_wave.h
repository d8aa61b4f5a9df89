#pragma once
#include <complex>
#include <span>

#include "compare/compare.h"

namespace tw {

/// Of records with a regular wave (number wave_period), from its height gauges, over the last whole periods that all
/// records cover, from mean_from on:
///   wave_height:GAUGE, wave_crest:GAUGE, wave_trough:GAUGE   mean over the periods, of each of which a mean and three
///                        harmonics are fitted, with its 95 % interval from how far the periods differ [m]; the theory's
///                        values stand beside as references
///   heave_response:BODY, pitch_response:BODY   first harmonic of a body's motion over half of the wave's height and over
///                        the wave's slope pi H / L, mean over the periods with its 95 % interval [-]
///   wave_reflection      |a_r| / |a_i| of the first harmonics at two gauges or more [%], see split_waves
/// They are judged by ladders. Call it after add_probes.
void add_regular_wave(Comparison& comparison);

/// Incident and reflected part of a wave of number k [1/m] from complex amplitudes at places x along its direction, A =
/// a_i exp(i k x) + a_r exp(-i k x), by least squares (two gauges: Goda & Suzuki 1976; three: Mansard & Funke 1980).
struct WaveParts {
    std::complex<double> incident = 0, reflected = 0;
    double misfit = 0;   ///< root mean square of what is left, over |a_i| [-]; of two gauges 0
    bool apart = false;  ///< the places tell the two parts from one another: none stand multiples of L/2 apart alone
};
WaveParts split_waves(std::span<const double> x, std::span<const std::complex<double>> amplitude, double k);

/// A exp(-i omega t) + mean, fitted to samples by least squares over their whole time.
std::complex<double> first_harmonic(std::span<const double> t, std::span<const double> values, double omega);

}  // namespace tw
