#pragma once
#include <numbers>

namespace tw {

/// Wendland C2 kernel, support 2h, in two or three dimensions (Wendland 1995, doi:10.1007/BF02123482). With s = r / 2h:
///
///   W           = sigma (1 - s)^4 (4 s + 1),   sigma = 21/(16 pi h^3) | 7/(4 pi h^2)
///   grad_i W_ij = G (1 - s)^3 r_ji / 2h,       G = 10 sigma / h,   so W = h/10 G (1 - s)^4 (4 s + 1)
///
/// The pair loops count lengths in 2h and carry G V_j with each neighbour: no scaling in the loop, no division by r
/// (coincident particles are harmless).
struct Kernel {
    float support_length = 0;  ///< 2h [m]
    float inv_support = 0;     ///< 1 / 2h [1/m]
    float tenth_h = 0;         ///< h/10 [m]
    float gradient = 0;        ///< G [1/m^(dim+1)]

    Kernel() = default;
    Kernel(double h, int dimensions) {
        const double pi = std::numbers::pi;
        sigma_ = dimensions == 3 ? 21 / (16 * pi * h * h * h) : 7 / (4 * pi * h * h);
        support_length = static_cast<float>(2 * h);
        inv_support = static_cast<float>(1 / (2 * h));
        tenth_h = static_cast<float>(h / 10);
        gradient = static_cast<float>(10 * sigma_ / h);
    }
    double support() const { return support_length; }
    double W(double r) const {
        const double s = r * inv_support, t = s < 1 ? 1 - s : 0;
        return sigma_ * t * t * t * t * (4 * s + 1);
    }
    /// grad_i W_ij = F r_ji [1/m^(dim+2)].
    double F(double r) const {
        const double s = r * inv_support, t = s < 1 ? 1 - s : 0;
        return double(gradient) * t * t * t * inv_support;
    }

private:
    double sigma_ = 0;
};

}  // namespace tw
