#pragma once
#include "sph_solver/equations/kernel.h"

namespace tw {

/// What the uppermost row of particles at rest has too much of pressure, in weights of a row, rho0 g dp. The sum
/// p_i + p_j of a pair counts what is missing above a surface as water at -p_i, where the line of the pressure would go
/// on to ever lower values. So the uppermost row is at equilibrium with the pressure 1/2 + e_0; the balance of its
/// forces on a lattice, row k below it with the share A_k = sum_j V_j |dW/dz| of the gradient (2 sum_k k A_k = 1), is
///
///   sum_k A_k [(1/2 + e_0) + (k + 1/2)] = 1,   e_0 = 1 / (2 sum_k A_k) - 1
///
/// (0.21 at h/dp = 1.55 in two dimensions). It goes with what the kernel lacks there: e = e_0 (1 - S) / (1 - S_0), S
/// the Shepard sum, S_0 that of the uppermost row. Particles of two sizes differ in it, which at the edge between
/// them would be a force of a tenth of their weight on the rows under a surface.
class SurfaceExcess {
public:
    SurfaceExcess() = default;
    SurfaceExcess(const Kernel& kernel, double dp, int dimensions);
    /// Of a particle of Shepard sum S.
    double of(double support) const { return e_0_ * share((1 - support) / (1 - S_0_)); }
    /// Of a particle of half the spacing, where particles of this spacing near it have the mean support m: e_0 at the
    /// depth of its uppermost row, nothing from its second row on.
    double of_child(double mean_support) const { return e_0_ * share((m_1_ - mean_support) / (m_1_ - m_0_)); }
    double uppermost() const { return e_0_; }

private:
    static double share(double x) { return x < 0 ? 0 : 1 < x ? 1 : x; }

    double e_0_ = 0, S_0_ = 0;
    double m_0_ = 0, m_1_ = 1;  ///< mean support at a quarter and at three quarters of a spacing below the surface
};

}  // namespace tw
