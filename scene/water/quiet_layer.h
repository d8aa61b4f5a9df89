#pragma once
#include <string>

#include "scene/scene.h"

namespace tw {

/// Where the particles of slow water under a quiet surface take over its weight (effect dynamic_pressure; the equations
/// stand in sph_solver/equations/rest_pressure.h).
struct QuietLayer {
    double surface = 0, top = 0,
           bottom = 0;  ///< of the still water, and the band in which the pressure is handed over [m]
};

/// Why a scene has no room or no place for it, and what to do; empty: it has. It wants a tank at rest with one level of
/// still water, particles of one size, and rigid solids that stand clear of its walls and deeper than the band, which
/// is as far down as half of the water over them, at most an eighth of the depth, at least eight smoothing lengths.
std::string no_quiet_layer(const Scene& scene);
/// Of a scene that has one.
QuietLayer quiet_layer(const Scene& scene);

/// How fast a body goes through the water, and what it meets there.
struct SlowBody {
    double speed = 0, size = 0;  ///< U [m/s]; D: diameter of the circle or sphere of its volume [m]
    double reynolds = 0;         ///< U D / nu [-]
    double dynamic = 0;          ///< rho U^2 + rho nu U / D [Pa]
    double hydrostatic = 0;      ///< where it is at the start [Pa]
};
/// Of a prescribed body its largest speed; of a free one that at which it would sink or rise, from the drag of a
/// cylinder or sphere:
///
///   |rho_b - rho| V g = 4 pi mu U + rho D U^2/2  per metre (two dimensions),  3 pi mu D U + 0.4 pi/8 rho D^2 U^2 (three)
///
/// to a factor of two: the first term is Oseen's and Faxen's within a logarithm.
SlowBody slow_body(const Scene& scene, const MovingBody& body);

/// Drag of a body of that size, as above: viscous U + inertial U^2, of two dimensions per metre.
struct BodyDrag {
    double viscous = 0;   ///< [N s/m]
    double inertial = 0;  ///< [N s2/m2]
};
BodyDrag drag_of(const Scene& scene, const MovingBody& body);

/// The Reynolds numbers at which a body's drag was found right (docs/results/viscous_flow.md).
inline constexpr double slow_up_to = 200;
/// The slowest body of a scene, if there is one whose flow is viscous and whose water is deep: Re below `slow_up_to` and
/// hydrostatic pressure above ten times the dynamic one.
const MovingBody* slowest_in_deep_water(const Scene& scene);
/// By how much the particles' drag of such a body is too large where they carry the whole pressure, roughly: 0.3 % for
/// every time that the hydrostatic pressure contains the dynamic one, up to twice the drag. Measured on a cylinder drawn
/// through a channel, ten spacings across (docs/decisions/065-water-at-the-start.md).
double excess_of_drag(const SlowBody& body);
/// Notes on the bodies, and on a hull in a stream, whose drag the particles will not have right. The effects have to be planned.
void warn_of_slow_bodies(Scene& scene);

}  // namespace tw
