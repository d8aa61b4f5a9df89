#pragma once
#include <cmath>
#include <optional>

#include "scene/scene.h"

namespace tw {

inline constexpr double width_of_place = 8;  ///< of a refined place around what it is named for, in its own spacings

/// The wake of the scene's hull: behind its middle to the outlet, or to `length` behind its stern, half as wide again
/// as the hull and down to its draft, and `width` more [m].
Box wake_of(const Scene& scene, double width, std::optional<double> length = {});

/// Whether the particles of the forcing zones are twice as large as those in the box.
inline bool has_coarse_zones(const Scene& scene) { return scene.sph.zones == "coarse"; }
/// Spacing of the largest particles [m].
inline double largest_particles(const Scene& scene) {
    return std::ldexp(scene.resolution.near_hull, scene.sph.levels - (has_coarse_zones(scene) ? 0 : 1));
}
/// Spacing of the finest particles [m]: near_hull, or what a place of the scene asks for below it.
double finest_spacing(const Scene& scene);
/// How many sizes of particles are finer than near_hull, and how many there are in all.
int sizes_below_near_hull(const Scene& scene);
inline int sizes_of_particles(const Scene& scene) {
    return scene.sph.levels + sizes_below_near_hull(scene) + (has_coarse_zones(scene) ? 1 : 0);
}

}  // namespace tw
