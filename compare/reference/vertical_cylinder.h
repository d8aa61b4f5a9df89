#pragma once
#include <optional>

#include "record/run_record.h"

namespace tw {

/// First-order force of a regular wave on a circular cylinder that stands from the floor to above the surface, exact in
/// linear theory in open water (MacCamy & Fuchs 1954, Beach Erosion Board, memorandum 69):
///
///   F = 4 rho g A / k^2 tanh(k d) Re( exp(-i omega t) / H1'(k a) ),   eta = A cos(k x - omega t), axis at x = 0
///
/// H1' = J1' + i Y1': the first Hankel function's derivative. Before the crest by arg H1', 90 degrees for slender ones.
struct CylinderForce {
    double amplitude = 0;  ///< [N]
    double lead = 0;       ///< over the crest at the axis [rad]
};
struct WaveAtCylinder {
    double amplitude = 0, k = 0;                       ///< A [m], [1/m]
    double depth = 0, density = 1000, gravity = 9.81;  ///< [m], [kg/m3], [m/s2]
};
CylinderForce mac_camy_fuchs(const WaveAtCylinder& wave, double radius);

/// An upright circular cylinder among a record's solids at rest, alone there.
struct UprightCylinder {
    double x = 0, y = 0, radius = 0;  ///< its axis [m]; of a circle of the polygon's area [m]
    double low = 0, high = 0;         ///< its ends [m]
};
std::optional<UprightCylinder> upright_cylinder(const RunRecord& record);

}  // namespace tw
