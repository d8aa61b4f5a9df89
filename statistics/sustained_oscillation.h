#pragma once
#include <optional>
#include <span>

namespace tw {

/// An oscillation about a mean that neither dies out nor wanders off.
struct Oscillation {
    double period = 0, amplitude = 0;  ///< means over the cycles [s], [unit of the series]
    int cycles = 0;                    ///< whole ones
};

/// Looked for from the time `from` on, in what is left of the series without its straight trend: four whole cycles or
/// more between crossings of the mean upward (counted where the series has gone a third of its standard deviation to
/// both sides between them), whose periods' standard deviation is at most a quarter of their mean, and whose amplitude,
/// half of highest less lowest, is in the later half of the cycles at least 0.7 of that in the earlier half: an
/// oscillation damped by more than about 0.02 of the critical damping has died out further over four cycles, exp(-2 pi
/// 0.02 2) = 0.78 from half to half of them, and 0.6 over eight.
std::optional<Oscillation> sustained_oscillation(std::span<const double> time, std::span<const double> values,
                                                 double from);

}  // namespace tw
