#pragma once
#include <vector>

namespace tw {

/// A steady periodic wave by the Fourier method (Rienecker & Fenton, J. Fluid Mech. 104 (1981) 119; quantities as in
/// Fenton, Comput. Geosci. 14 (1988) 357), in units in which gravity and wave number k are 1, seen from the crest:
///
///   psi(x, z) = -c (z + d) + sum_j B_j sinh(j (z + d)) / cosh(j d) cos(j x),    psi = -q and p = 0 at z = eta(x)
///
/// Still water is z = 0, the crest at x = 0. c is its speed over water whose mean velocity below the troughs (Eulerian)
/// is zero; a current is added to it.
struct SteadyWave {
    double depth = 0, height = 0;  ///< k d, k H
    std::vector<double> B;         ///< B_1 ... B_n
    std::vector<double> E;         ///< eta(x) = sum_j E_j cos(j x)
    double crest = 0, trough = 0;  ///< eta(0), eta(pi)
    double speed = 0;              ///< c sqrt(k/g)
    double flux = 0;               ///< carried by the waves, c d - q, of k^(3/2)/g^(1/2): Stokes' transport
    double bernoulli = 0;          ///< 1/2 (u^2 + w^2) + z at the surface
};

/// Solved by Newton's steps for eta at n + 1 points from crest to trough, B, c, q and Bernoulli's constant, from small
/// heights on. Terms are added until the last ones no longer matter (12 to 96). Solutions are found up to 95 % of the
/// highest wave (steepness.h) for k d from 0.1, waves of 60 depths; k d beyond 25 is as good as infinite. Throws
/// std::domain_error where none is found.
SteadyWave steady_wave(double k_depth, double k_height);

}  // namespace tw
