#pragma once
#include <cmath>

namespace tw {

/// Pressure from density. Linear: p = c0^2 (rho - rho0). Tait: p = c0^2 rho0 / gamma ((rho / rho0)^gamma - 1)
/// (Monaghan 1994). Negative pressures are allowed; see `surface_support` of SolverSetup for the free surface.
struct StateEquation {
    enum class Form { linear, tait } form = Form::linear;
    double c0 = 0;  ///< [m/s]
    double gamma = 7;

    float pressure(double rho0, float drho) const {
        if (form == Form::linear) return static_cast<float>(c0 * c0) * drho;
        return static_cast<float>(c0 * c0 * rho0 / gamma * std::expm1(gamma * std::log1p(double(drho) / rho0)));
    }
    /// Density deviation of water at rest under pressure p.
    float deviation(double rho0, double p) const {
        if (form == Form::linear) return static_cast<float>(p / (c0 * c0));
        return static_cast<float>(rho0 * std::expm1(std::log1p(gamma * p / (c0 * c0 * rho0)) / gamma));
    }
};

}  // namespace tw
