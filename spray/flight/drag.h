#pragma once
#include <cmath>

#include "spray/air/air.h"
#include "spray/droplet.h"

namespace tw::spray {

/// Which drag coefficient of a sphere holds.
enum class DragLaw {
    /// Schiller & Naumann (1933; Eq. 21 of Guan, Zha & Wan):
    ///
    ///   Cd = 24 / Re (1 + 0.15 Re^0.687)   Re <= 1000
    ///   Cd = 0.44                          above; it jumps there, from 0.4383
    ///
    /// Against measured raindrops (Gunn & Kinzer 1949) the terminal speed is within 6 % for 0.2 to 3 mm and 21 % too
    /// high at 5 mm, because large drops flatten.
    schiller_naumann,
    /// Putnam (1961), the law of OpenFOAM's sphereDrag:
    ///
    ///   Cd = 24 / Re (1 + Re^(2/3) / 6)   Re <= 1000
    ///   Cd = 0.424                        above, without a jump
    ///
    /// From 2.5 % above Schiller and Naumann's at Re = 10 to 3.6 % below it at Re > 1000.
    putnam
};
inline constexpr double Re_of_the_jump = 1000;
/// Cd Re / 24 at Re <= 1000 [-]: how much more than Stokes's law.
inline double above_stokes(double Re, DragLaw law) {
    return law == DragLaw::putnam ? 1 + std::pow(Re, 2.0 / 3) / 6 : 1 + 0.15 * std::pow(Re, 0.687);
}
/// Cd at Re > 1000 [-].
inline double blunt_drag(DragLaw law) { return law == DragLaw::putnam ? 0.424 : 0.44; }
inline double drag_coefficient(double Re, DragLaw law = DragLaw::schiller_naumann) {
    return Re > Re_of_the_jump ? blunt_drag(law) : 24 / Re * above_stokes(Re, law);
}
/// Reynolds number of a sphere of diameter d at that speed through the air [-].
inline double sphere_reynolds(double speed, double d, const AirState& air) {
    return air.density * speed * d / air.viscosity;
}

/// What acts on a droplet.
struct Forces {
    DragLaw drag = DragLaw::schiller_naumann;
    Vec3 gravity{0, 0, -9.81};  ///< [m/s2]
    bool buoyancy = false;      ///< weight of the displaced air: 0.12 % of the droplet's own
};

/// Acceleration of a droplet of diameter d and velocity v in air of velocity u [m/s2]:
///
///   dv/dt = -(3/4) rho_a / rho_w Cd(Re) / d |v - u| (v - u) + g (1 - rho_a / rho_w if buoyant)
///   Re    = rho_a |v - u| d / mu_a
///
/// Eq. 22 of Guan, Zha & Wan, which leaves gravity out. No history or added-mass terms: they are of the order of
/// rho_a / rho_w. `above`: which side of the drag's jump holds, so that a step of the integrator sees a smooth law.
inline Vec3 acceleration(const Vec3& v, double d, const AirState& air, double rho_w, const Forces& forces, bool above) {
    const Vec3 slip = v - air.velocity;
    const double speed = slip.norm(), Re = sphere_reynolds(speed, d, air);
    const Vec3 weight = forces.buoyancy ? Vec3((1 - air.density / rho_w) * forces.gravity) : forces.gravity;
    // Cd |v - u| tends to a finite limit for |v - u| -> 0, so it is written without a quotient there.
    const double cd_speed = above ? blunt_drag(forces.drag) * speed
                                  : 24 * air.viscosity / (air.density * d) * above_stokes(Re, forces.drag);
    return weight - 0.75 * air.density / rho_w * cd_speed / d * slip;
}

}  // namespace tw::spray
