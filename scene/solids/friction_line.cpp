#include "scene/solids/friction_line.h"

#include "scene/effects/flow_numbers.h"

namespace tw {

double friction_by_line(const Scene& scene, double wetted_area, double wetted_length) {
    if (!scene.effect_on("friction") || !(wetted_area > 0) || !(wetted_length > 0)) return 0;
    const double U = scene.motion.speed, reynolds = U * wetted_length / scene.water.kinematic_viscosity;
    return 0.5 * scene.water.density * U * U * wetted_area * ittc57(reynolds);
}

}  // namespace tw
