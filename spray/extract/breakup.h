#pragma once
#include <random>
#include <vector>

#include "spray/air/air.h"
#include "spray/droplet.h"

namespace tw::spray {

/// How a lump that is too large for the wind on it falls apart.
struct BreakupOptions {
    /// We = rho_a |v - u|^2 d / sigma above which a drop breaks [-]: 12 for water (Pilch & Erdman 1987,
    /// doi:10.1016/0301-9322(87)90063-2).
    double critical_weber = 12;
    /// Exponent q of Rosin & Rammler's volume distribution [-]; 2 (wide) to 4 (narrow).
    double spread = 3;
    /// Smallest fragment over the largest [-]; Rosin & Rammler's law alone would make infinitely many.
    double smallest = 0.1;
};

/// Largest diameter that survives a slip speed in that air [m].
double largest_stable_diameter(double slip, const AirState& air, const Liquid& liquid, double critical_weber);

/// Diameters of fragments that together have exactly `volume` [m3]. Their volume below d follows
///
///   F(d) = 1 - exp(-(d / X)^q)      (Rosin & Rammler 1933)
///
/// cut to [smallest * d_max, d_max], with X such that F(d_max) = 0.999. One diameter where the volume's own sphere is
/// no larger than d_max.
std::vector<double> fragments(double volume, double d_max, const BreakupOptions& options, std::mt19937_64& random);

/// Throws InputError naming the option that cannot be.
void check_breakup(const BreakupOptions& options);

}  // namespace tw::spray
