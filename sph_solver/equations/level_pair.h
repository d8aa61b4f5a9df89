#pragma once

namespace tw {

/// Two fluids that meet (water and air), with a pressure and a velocity of each pair that are those of a contact
/// between a heavy and a light fluid (Hu & Adams 2006, doi:10.1016/j.jcp.2005.09.001; Rezavand, Zhang & Hu 2020,
/// doi:10.1016/j.jcp.2019.109092), j in the other fluid:
///
///   drho_i/dt += rho_i sum_j 2 (u_i - u*) . grad_i W_ij V_j,     u* = (rho_i u_i + rho_j u_j) / (rho_i + rho_j)
///   du_i/dt   -= 1/rho_i sum_j (2 p* + pi_ij) grad_i W_ij V_j,   p* = (rho_j p_i + rho_i p_j) / (rho_i + rho_j)
///
/// with the fluids' reference densities: 2 (u_i - u*) = of_own (u_i - u_j), 2 p* = of_own p_i + of_other p_j. The two
/// sums are dual: the work of the one is the energy of the other.
struct Contact {
    float of_own, of_other;  ///< [-]
    Contact(float rho_own, float rho_other)
        : of_own(2 * (rho_other / (rho_own + rho_other))), of_other(2 * (rho_own / (rho_other + rho_own))) {}
};

/// Coefficient of the artificial viscosity across the contact: the harmonic mean of both sides'.
inline float harmonic_mean(float a, float b) { return a + b > 0 ? 2 * a * b / (a + b) : 0; }

}  // namespace tw
