#pragma once
#include "base/numbers.h"

namespace tw {

/// Wendland C2 kernel, support 2h, in two or three dimensions (Wendland 1995, doi:10.1007/BF02123482). With s = r / 2h
/// and the closeness t = 1 - s (0 beyond the support):
///
///   W           = sigma t^4 (4 s + 1),   sigma = 21/(16 pi h^3) | 7/(4 pi h^2)
///   grad_i W_ij = G t^3 r_ji / 2h,       G = 10 sigma / h,   so W = h/10 G t^3 shape,   shape = t (5 - 4 t)
///
/// Another kernel of support 2h is another struct with these members.
struct WendlandC2 {
    static double sigma(double h, int dimensions) {
        return dimensions == 3 ? 21 / (16 * pi * h * h * h) : 7 / (4 * pi * h * h);
    }
    static double G(double h, int dimensions) { return 10 * sigma(h, dimensions) / h; }
    static double W_over_G(double h) { return h / 10; }

    /// grad_i W_ij / (G r_ji / 2h), a function of the closeness.
    template <class Real>
    static Real gradient(const Real& t) {
        return (t * t) * t;
    }
    /// W / (W_over_G G gradient).
    template <class Real>
    static Real shape(const Real& t) {
        return t * (5.0f - 4.0f * t);
    }
};

/// A kernel's numbers for one smoothing length. The pair loops count lengths in 2h and carry G V_j with each neighbour:
/// no scaling in the loop, no division by r (coincident particles are harmless).
template <class Form>
struct SmoothingKernel {
    float support_length = 0;  ///< 2h [m]
    float inv_support = 0;     ///< 1 / 2h [1/m]
    float W_over_G = 0;        ///< [m]
    float G = 0;               ///< [1/m^(dim+1)]

    SmoothingKernel() = default;
    SmoothingKernel(double h, int dimensions) {
        support_length = static_cast<float>(2 * h);
        inv_support = static_cast<float>(1 / (2 * h));
        W_over_G = static_cast<float>(Form::W_over_G(h));
        G = static_cast<float>(Form::G(h, dimensions));
        scale_ = Form::G(h, dimensions) * Form::W_over_G(h);
    }
    double support() const { return support_length; }
    double W(double r) const {
        const double t = closeness(r);
        return scale_ * Form::gradient(t) * Form::shape(t);
    }
    /// grad_i W_ij = F r_ji [1/m^(dim+2)].
    double F(double r) const { return double(G) * Form::gradient(closeness(r)) * inv_support; }

private:
    double closeness(double r) const {
        const double s = r * inv_support;
        return s < 1 ? 1 - s : 0;
    }
    double scale_ = 0;  ///< of W
};
/// The kernel in use.
using Kernel = SmoothingKernel<WendlandC2>;

}  // namespace tw
