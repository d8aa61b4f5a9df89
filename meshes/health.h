#pragma once
#include <string>
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// One thing found wrong (or odd) about a hull surface, with its place.
struct Finding {
    enum class Level { note, warning, error } level = Level::note;
    std::string name;     ///< stable key: open_edges, non_manifold_edges, flipped_normals, inverted, several_shells,
                          ///< nested_shells, zero_area, not_finite, self_intersection, far_from_origin,
                          ///< suspicious_size, thin_walls, empty
    std::string message;  ///< what, how many, where, and what to do unless repair_surface repairs it
    Vec3 place = Vec3::Zero();  ///< [m]
    bool mendable = false;      ///< repair_surface makes a usable surface of it
};

/// All findings, and of each error whether repair_surface repairs it; `particle_spacing` > 0 adds the wall-thickness
/// check (thinner than 6 particle layers).
std::vector<Finding> check_surface(const Surface& surface, double particle_spacing = 0);
bool usable(const std::vector<Finding>& findings);  ///< no finding of level error

/// Repairs what is safe (duplicate points, zero-area triangles, small planar holes, flipped and inverted normals) and
/// says what was done, one line each.
struct Repaired {
    Surface surface;
    std::vector<std::string> done;
};
Repaired repair_surface(const Surface& surface);

}  // namespace tw
