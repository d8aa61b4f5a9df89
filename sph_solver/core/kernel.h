#pragma once
#include <numbers>

namespace tw {

/// Wendland C2 kernel, support 2h, in two or three dimensions (Wendland 1995, doi:10.1007/BF02123482):
///
///   W(q)    = sigma (1 - q/2)^4 (2 q + 1),   q = r / h,   sigma = 21/(16 pi h^3) | 7/(4 pi h^2)
///   grad_i W_ij = F r_ji,   F = 5 sigma / h^2 (1 - q/2)^3,   r_ji = x_j - x_i
///
/// F has no division by r, so coincident particles are harmless.
struct Kernel {
    float inv_h = 0;       ///< [1/m]
    float sigma = 0;       ///< [1/m^dim]
    float five_sigma = 0;  ///< 5 sigma / h^2

    Kernel() = default;
    Kernel(double h, int dimensions) {
        const double pi = std::numbers::pi;
        const double s = dimensions == 3 ? 21 / (16 * pi * h * h * h) : 7 / (4 * pi * h * h);
        inv_h = static_cast<float>(1 / h);
        sigma = static_cast<float>(s);
        five_sigma = static_cast<float>(5 * s / (h * h));
    }
    double support() const { return 2.0 / inv_h; }
    double W(double r) const {
        const double q = r * inv_h, t = q < 2 ? 1 - q / 2 : 0;
        return sigma * t * t * t * t * (2 * q + 1);
    }
    double F(double r) const {
        const double q = r * inv_h, t = q < 2 ? 1 - q / 2 : 0;
        return five_sigma * t * t * t;
    }
};

}  // namespace tw
