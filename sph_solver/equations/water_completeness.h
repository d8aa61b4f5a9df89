#pragma once
#include <cmath>

#include "sph_solver/equations/pair.h"

namespace tw {

/// Whether water touches water where a free surface cuts its kernel: the kernel's support S_i with what a plane surface
/// takes of it given back,
///
///   Q_i = S_i + a |s_i|,   s_i the sum of shifting (shifting.h)
///
/// a such that Q_i = 1 in the first row of a square lattice below a plane surface, 0.59 dp with h = 1.55 dp. Q is then
/// 1.03 in the second row, 0.93 in a sheet of two rows, and 0.80 to 0.85 inside a lattice 10 % too wide.
struct WaterCompleteness {
    float a;  ///< [m], of_plane_surface
    static constexpr float full = 0.9f, width = 0.1f;

    /// Water compresses only water that it touches: what comes nearer through a void closes the void first. Of d = -div
    /// u at a particle of the free surface, whose density is not let below rho0 and so forgets how far the particles
    /// stand apart, therefore
    ///
    ///   d >= 0:  d clamp((Q_i - 0.8) / 0.1, 0, 1),   d < 0:  d
    ///
    /// Without it a void that was torn counts as compression when it closes, so it cannot, and shallow water swells
    /// (docs/decisions/065). `s` is |s_i| [1/m].
    template <class Real>
    Real compression(const Real& d, const Real& support, const Real& s) const {
        const Real void_share = positive_part(full - (support + a * s)) / width;
        return d + positive_part(d) * (positive_part(1.0f - void_share) - 1.0f);
    }

    /// a [m]: the support of the rows above a plane surface over the length of their part of s_i, in the first row
    /// below.
    static double of_plane_surface(const Kernel& kernel, double dp, int dimensions) {
        const int rows = static_cast<int>(kernel.support() / dp), across = dimensions == 3 ? rows : 0;
        double support = 0, s = 0;
        for (int k = 1; k <= rows; ++k)
            for (int i = -rows; i <= rows; ++i)
                for (int j = -across; j <= across; ++j) {
                    const double r = dp * std::sqrt(double(i * i + j * j + k * k));
                    support += kernel.W(r);
                    s += kernel.F(r) * k * dp * (1 + 0.2 * std::pow(kernel.W(r) / kernel.W(dp), 4));
                }
        return support / s;
    }
};

}  // namespace tw
