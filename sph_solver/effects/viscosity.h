#pragma once
#include <memory>
#include <optional>

#include "sph_solver/effects/eddy_viscosity.h"
#include "sph_solver/effects/effect.h"

namespace tw {

/// Physical viscosity (Morris, Fox & Zhu 1997, doi:10.1006/jcph.1997.5776, with grad W = F r):
///
///   du_i/dt += 1/rho_i sum_j (mu_i + mu_j) F_ij (u_j - u_i) V_j
///
/// The solids do not rub (slip) or hold the water (no slip): then a wall's dummy moves against the water round it,
/// u_d = 2 u_w - sum_f u_f V W / sum_f V W (Adami, Hu & Adams 2012, doi:10.1016/j.jcp.2012.05.005), so that the
/// velocity is the wall's u_w on the surface between (zero unless it slides). Slip walls and symmetry planes on the
/// domain's faces stay what they are.
struct Viscosity {
    double kinematic = 1e-6;  ///< nu [m2/s]
    bool no_slip = true;
    std::optional<EddyViscosity> turbulence;
};
std::unique_ptr<Effect> make_viscosity(const Viscosity& options);

/// What the artificial viscosity alpha h c0 amounts to as a kinematic one [m2/s]: alpha h c0 / (2 (d + 2)).
inline double numerical_viscosity(double alpha, double h, double c0, int dimensions) {
    return alpha * h * c0 / (2 * (dimensions + 2));
}

}  // namespace tw
