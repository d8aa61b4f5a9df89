#pragma once
#include <cmath>

#include "spray/droplet.h"

namespace tw::spray {

/// What one droplet does to a rigid dry wall that it meets with the normal speed V (Verma et al. 2020,
/// doi:10.1016/j.compstruct.2020.112096; Eqs. 23 to 25 of Guan, Zha & Wan):
///
///   F = 0.84 rho V^2 d^2               largest force [N]
///   I = 0.56 rho V^0.95 d^2.98         impulse [N s]; V in m/s and d in m
///
/// The study prints the impulse without rho, which makes it 1000 times too small; with it I is 1.04 to 1.21 times the
/// droplet's momentum m V for 1 to 3 mm and 1.35 to 20 m/s.
inline double peak_force(double V, double d, const Liquid& liquid) { return 0.84 * liquid.density * V * V * d * d; }
inline double impulse(double V, double d, const Liquid& liquid) {
    return 0.56 * liquid.density * std::pow(V, 0.95) * std::pow(d, 2.98);
}

/// Reynolds and Weber number of the impact. The laws are meant for Re > 230 and We > 50, where inertia decides.
inline double impact_reynolds(double V, double d, const Liquid& l) { return l.density * V * d / l.viscosity; }
inline double impact_weber(double V, double d, const Liquid& l) { return l.density * V * V * d / l.surface_tension; }
inline bool within_law(double V, double d, const Liquid& l) {
    return impact_reynolds(V, d, l) > 230 && impact_weber(V, d, l) > 50;
}

}  // namespace tw::spray
