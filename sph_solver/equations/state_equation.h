#pragma once
#include <algorithm>
#include <cmath>

#ifdef TW_THREADS
#include "sph_solver/equations/power_less_one.h"
#endif

namespace tw {

/// Pressure from density, gauge (p = 0 at rho0). Negative pressures are allowed; see `surface_support` of LevelSetup
/// for the free surface, effects/cavitation.h for a limit.
///
/// linear:   p = c0^2 (rho - rho0)
/// tait:     p = c0^2 rho0 / gamma ((rho / rho0)^gamma - 1)   (Monaghan 1994, doi:10.1006/jcph.1994.1034)
/// mie_grueneisen, with k = rho/rho0 - 1 (cubic shock velocity; Steinberg 1987), without the heat term (gamma0 + a k)
/// E, which is of third order in k for water that starts cold:
///   p = rho0 c0^2 k (1 + (1 - gamma0/2) k - a/2 k^2) / (1 - (S1 - 1) k - S2 k^2/(k + 1) - S3 k^3/(k + 1)^2)^2,  k > 0
///   p = rho0 c0^2 k,                                                                                          k <= 0
/// The landing-gear study prints the denominator without its square and S1 = 2.16; Steinberg's form has the square and
/// S1 = 2.56. c0 = 1480 m/s is real water's; a smaller c0 softens it as with the other forms.
struct StateEquation {
    enum class Form { linear, tait, mie_grueneisen } form = Form::linear;
    double c0 = 0;  ///< [m/s]
    double gamma = 7;                                                    ///< Tait's exponent [-]
    double S1 = 2.56, S2 = -1.985, S3 = 0.2268, gamma0 = 0.5, a = 2.67;  ///< Mie-Grueneisen, water [-]

    float pressure(double rho0, float drho) const {
        switch (form) {
            case Form::linear: return static_cast<float>(c0 * c0) * drho;
            case Form::tait:
                return static_cast<float>(c0 * c0 * rho0 / gamma * power_less_one(double(drho) / rho0, gamma));
            case Form::mie_grueneisen: return static_cast<float>(grueneisen(rho0, double(drho) / rho0));
        }
        return 0;
    }
#ifndef TW_THREADS
    /// Density deviation of water at rest under pressure p.
    float deviation(double rho0, double p) const {
        switch (form) {
            case Form::linear: return static_cast<float>(p / (c0 * c0));
            case Form::tait:
                return static_cast<float>(rho0 * std::expm1(std::log1p(gamma * p / (c0 * c0 * rho0)) / gamma));
            case Form::mie_grueneisen: {
                double k = p / (c0 * c0 * rho0);  // Newton with the linear slope: converges for water's small k
                for (int i = 0; i < 50; ++i) k -= (grueneisen(rho0, k) - p) / (c0 * c0 * rho0);
                return static_cast<float>(rho0 * k);
            }
        }
        return 0;
    }
    /// Density deviation of an even lattice of particles of mass m at rest under the pressure p of incompressible water,
    /// whose gradient its weight balances. Its pair sums leave out that a volume m/rho is smaller than its cell m/rho0:
    ///
    ///   -1/rho_i sum_j (p_i + p_j) grad_i W_ij m/rho_j  ->  -rho0 grad(p / rho^2)
    ///
    /// so it rests where p(rho) (rho0/rho)^2 is the pressure of incompressible water; by p (1 + 2 k), k = p/(rho0 c0^2), to
    /// the first order. With the density of `deviation` the water below sags, and in a stream the rise of pressure from
    /// the inlet on slows it down, by 7 mm of head in 1.3 m of water at c0 = 40 m/s.
    float deviation_of_lattice(double rho0, double p) const {
        float drho = deviation(rho0, p);
        for (int i = 0; i < 30; ++i) {  // a handful, unless p is near the most that a lattice bears
            const double ratio = std::min(1 + double(drho) / rho0, 1.5);  // a quarter of rho0 c0^2
            const float next = deviation(rho0, p * ratio * ratio);
            if (next == drho) break;
            drho = next;
        }
        return drho;
    }
#endif

private:
    /// (1 + x)^n - 1.
    static double power_less_one(double x, double n) {
#ifdef TW_THREADS
        return tw::power_less_one(x, n);
#else
        return std::expm1(n * std::log1p(x));
#endif
    }
    double grueneisen(double rho0, double k) const {
        const double linear = rho0 * c0 * c0 * k;
        if (k <= 0) return linear;
        const double below = 1 - (S1 - 1) * k - S2 * k * k / (k + 1) - S3 * k * k * k / ((k + 1) * (k + 1));
        return linear * (1 + (1 - gamma0 / 2) * k - a / 2 * k * k) / (below * below);
    }
};

}  // namespace tw
