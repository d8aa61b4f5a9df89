#include "sph_solver/domain/scheme.h"

#include "base/errors.h"

namespace tw {

Scheme scheme_of(const std::string& name) {
    if (name == "symplectic_euler") return Scheme::symplectic_euler;
    if (name == "kick_drift_kick") return Scheme::kick_drift_kick;
    if (name == "predictor_corrector") return Scheme::predictor_corrector;
    if (name == "rk4_frozen_diffusion") return Scheme::rk4_frozen_diffusion;
    throw InputError("time-stepping scheme '" + name +
                     "': unknown; expected kick_drift_kick, symplectic_euler, predictor_corrector or "
                     "rk4_frozen_diffusion");
}

}  // namespace tw
