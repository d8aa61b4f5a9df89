#pragma once
#include "structure/mesh.h"

namespace tw::structure {

/// A simplified tyre: tread, side walls and an inner tyre, on a rigid rim. The main dimensions are those of the small
/// tyre of a published drop test (outer diameter 250 mm, rim 95 mm, width 80 mm); the thicknesses and the shape of the
/// section (an arc of an ellipse, tangent to the outer diameter and width) are not published and assumed here.
struct Tyre {
    double outer_diameter = 0.250, rim_diameter = 0.095, width = 0.080;               ///< [m]
    double tread_thickness = 0.010, side_thickness = 0.006, inner_thickness = 0.002;  ///< of rubber; inner tyre [m]
    double bead_angle = 2.44;   ///< along the ellipse, from the crown to where the wall meets the rim [rad]
    double tread_angle = 0.87;  ///< along the ellipse, from the crown to where the tread ends [rad]
    int around = 48, across = 20,
        through_rubber = 2;  ///< hexahedra round the axle, from bead to bead, through the wall
};

/// Its mesh, the axle along y through the origin. Materials: 0 inner tyre, 1 side walls, 2 tread. Node set: rim, the
/// beads. Surfaces: inside, where the air presses, and outside. Throws InputError for dimensions that no tyre has.
SolidMesh tyre_mesh(const Tyre& tyre);

/// Only `cells` of the cells around, from the angle `from` about the axle on, both within the plane of x and z [rad],
/// against the sense from x to z. Further node sets: begin and end, the cut sections.
SolidMesh tyre_sector(const Tyre& tyre, int cells, double from);

}  // namespace tw::structure
