#pragma once
#include <memory>

namespace tw {

class Effect;

/// Acoustic damper (Sun, Pilloton, Antuono, Colagrossi 2023, doi:10.1016/j.jcp.2023.112056): damps sound and leaves
/// shear alone,
///
///   du/dt += alpha2 c0 h / rho  grad(rho0 div u),
///
/// which is the pressure p_v = -alpha2 rho0 c0 h div u = alpha2 c0 h drho/dt beside the state equation's. The rate of
/// the density is known before the forces are, so it costs no pair loop. Impulses stay, peaks of impact pressure fall.
struct AcousticDamping {
    double alpha2 = 0.3;  ///< [-]
};
std::unique_ptr<Effect> make_effect(const AcousticDamping& options);

}  // namespace tw
