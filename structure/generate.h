#pragma once
#include <functional>

#include "structure/mesh.h"

namespace tw::structure {

/// A rectangular plate in z = 0 from the origin, a by b [m], cells_x by cells_y, normal +z. Node sets: x_min, x_max,
/// y_min, y_max, edges (all four).
ShellMesh plate_mesh(double a, double b, int cells_x, int cells_y);

/// A block of cells[0] x cells[1] x cells[2] hexahedra over the unit cube, each node moved to `place(node)` [m]; the
/// map keeps orientation. Node sets and surfaces: x_min, x_max, y_min, y_max, z_min, z_max of the cube. With `closed_x`
/// the faces x_min and x_max are one and the same (a ring), and have neither set nor surface.
SolidMesh block_mesh(std::array<int, 3> cells, const std::function<Vec3(const Vec3&)>& place, bool closed_x = false);

/// One mesh of several: nodes closer than `tolerance` [m] become one, sets and surfaces of the same name are united.
SolidMesh joined(const std::vector<SolidMesh>& parts, double tolerance);

}  // namespace tw::structure
