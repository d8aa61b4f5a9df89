#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "meshes/surface.h"
#include "record/wet_wall.h"

namespace tw {

/// A solid's faces of the mesh with what the flow does on them, as the function objects `hullSurface` and `bodySurfaces`
/// wrote them.
struct HullPatch {
    struct Face {
        Vec3 centre = Vec3::Zero();  ///< [m]
        Vec3 area = Vec3::Zero();    ///< pointing out of the flow, into the hull [m2]
        double pressure = 0;         ///< [Pa], 0 in the open air
        double water = 0;            ///< volume fraction at the wall [-]
        Vec3 shear =
            Vec3::Zero();  ///< wallShearStress: kinematic stress of the wall on the fluid, as OpenFOAM signs it [m2/s2]
    };
    std::vector<Face> faces;
    Surface surface;  ///< faces cut into triangles, normals out of the hull
    std::vector<int> face_of_triangle;
};

/// Reads NAME.vtp (openfoam.com) or NAME.vtk (openfoam.org) below `folder`; nothing when neither is there or whole.
std::optional<HullPatch> read_hull_patch(const std::filesystem::path& folder, const std::string& name = "hull");

/// A face is wet from a water fraction of 0.5 on; the gap is the share of air in the cell at it.
WetWall wet_wall(const HullPatch& patch);

/// How well the mesh shows the hull: the largest distance from a corner of its surface that lies at y >= `y_min` and
/// below `z_max` to the patch [m]. A keel or transom edge that snapping has cut off shows here, and in the force.
double mesh_error(const HullPatch& patch, const Surface& hull, double y_min, double z_max);

/// What the water does to the solved part of the hull (a half model's other half is not added here).
struct WaterLoad {
    Vec3 pressure = Vec3::Zero();  ///< force by pressure on wet faces (water fraction > 0.05) [N]
    Vec3 viscous =
        Vec3::Zero();  ///< friction of water on wetted faces (> 0.5), as if no air were smeared under them [N]
    Vec3 viscous_mixture = Vec3::Zero();  ///< friction without that correction, wet faces [N]
    Vec3 air = Vec3::Zero();              ///< pressure and friction on the other faces [N]
    Vec3 moment = Vec3::Zero();           ///< of `pressure` and `viscous` about the reference [N m]
    double wetted_area = 0;               ///< of faces with water fraction > 0.5 [m2]
    double wetted_length = 0;             ///< longest line of those along x, see record/wetted_line.h [m]
    double ventilation = 0;               ///< 1 - mean water fraction over wet faces that look down [-]

    /// Adds the forces and the moment of another solid; what describes one hull stays the first one's.
    WaterLoad& operator+=(const WaterLoad& other);
};
/// `density` of water [kg/m3]; `density_air` weighs the mixture's friction.
WaterLoad water_load(const HullPatch& patch, double density, double density_air, const Vec3& reference);

}  // namespace tw
