#pragma once
#include <string>

namespace tw {

/// Height of the highest steady wave of a length on water of a depth [m], within 1 % (Fenton 1990, The Sea 9(A) ch. 1,
/// eq. 32, a fit to the computations of Williams 1981).
double highest_wave(double length, double depth);

/// Ursell's number H L^2 / d^3: how far a long wave is from a sine [-].
double ursell_number(double height, double length, double depth);

/// Where a wave lies among the theories, in words: "linear", "Stokes, second order", "cnoidal" ... A wave is linear
/// where its second harmonic, of k H / 8 (3 - t^2) / t^3 (t = tanh(k d); Stokes 1847), is below 2 % of the
/// first; cnoidal where Ursell's number is above 40 (Hedges 1995, Proc. ICE 112, 111).
std::string wave_regime(double height, double length, double depth);
/// "deep", "intermediate" or "shallow" water: d/L above 1/2, between, below 1/20.
std::string depth_regime(double length, double depth);

}  // namespace tw
