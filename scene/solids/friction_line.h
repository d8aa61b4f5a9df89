#pragma once
#include "scene/scene.h"

namespace tw {

/// Friction of the water on a hull in a stream by the line for flat plates [N; in two dimensions per metre of span]:
///   R_F = rho U^2/2 S C_F(Re),  Re = U l / nu,  C_F = 0.075 / (log10 Re - 2)^2  (ITTC 1957)
/// of what a method finds wet: area S [m2; per metre of span m] and length l [m]. 0 where the effect `friction` is off,
/// without a wet hull, or below Re = 1e4.
double friction_by_line(const Scene& scene, double wetted_area, double wetted_length);

}  // namespace tw
