#pragma once
#include <span>

#include "spray/load/impact.h"
#include "spray/load/sensor.h"

namespace tw::spray {

/// What a square face feels that may be smaller than a drop. A droplet that covers the face presses on it with what it
/// presses with on its own cross-section, however wide it is:
///
///   p = F / max(pi d^2 / 4, f^2)          with F = 0.84 rho V^2 d^2: 1.07 rho V^2 for d above 1.13 f
///
/// so the largest reading is a matter of one droplet's speed, and not of how much water comes. The droplets on the
/// sensor are taken as spread evenly over it; one touches the face where its centre is within d / 2 of it:
///
///   touches = sum (f^2 + 2 f d + pi d^2 / 4) / extent^2
///
struct FaceHits {
    double touches = 0;  ///< droplets that touch the face, on the average
    double chance = 0;   ///< that at least one does, if they come independently: 1 - exp(-touches)
    double median = 0, high = 0, largest = 0;  ///< pressure of one hit: 50 %, 95 % of the touches, and the largest [Pa]
};
/// `face`: its edge [m].
FaceHits face_hits(std::span<const Arrival> arrivals, double extent, double face, const Liquid& liquid);

/// Pressure of one droplet on a face, see FaceHits [Pa].
double pressure_of_one(double normal_speed, double diameter, double face, const Liquid& liquid);

}  // namespace tw::spray
