#pragma once
#include <optional>

namespace tw {

/// A flat plate that planes on a weightless stream of finite depth, in two dimensions: exact for an ideal fluid.
///
/// Depth H and speed U far upstream, plate at the angle alpha whose trailing edge stands z_te above the undisturbed
/// surface, endless forward; a jet of thickness delta leaves forward along it. Free streamlines: the hodograph
/// omega = ln(U / (dw/dz)) = -ln q + i theta on the upper half of a t plane, with the bottom on (-inf, 0), the
/// downstream surface on (0, 1), the plate on (1, J) with the stagnation point at s, the upstream surface beyond J:
///
///   theta = 0 on the bottom, -alpha on (1, s), pi - alpha on (s, J);  q = U on both surfaces
///   dw/dt = -(U H / pi) (t - s) / (t (t - J)),   delta / H = (J - s) / J
///   z_te  = int_0^1 |sin theta| |dw/dt| dt / U - delta          (rise of the downstream surface up to the edge)
///   N     = rho U^2 delta (1 + cos alpha) / sin alpha           (force normal to the plate, by momentum)
///
/// Milne-Thomson, Theoretical Hydrodynamics, chapters XI and XII, for the method; the integrals are elliptic here, see
/// planing_plate.cpp. Without air, viscosity and surface tension.
struct PlaningPlate {
    double z_te = 0;   ///< of the trailing edge, over H [-]
    double delta = 0;  ///< thickness of the jet, over H [-]
    double force = 0;  ///< normal to the plate, over rho U^2 H [-], per metre of span
};
/// `alpha`: from 0 to pi/2 [rad]; `J` > 1: the parameter of the family.
PlaningPlate planing_plate(double alpha, double J);
/// The plate whose trailing edge stands at z_te [H]; of two (an edge above the surface can draw a thick or a thin jet) the
/// one with the thicker jet. Nothing where no J between 1 + 1e-6 and 1e9 gives it.
std::optional<PlaningPlate> planing_plate_at(double alpha, double z_te);

}  // namespace tw
