#pragma once
#include <optional>

#include "scene/scene.h"

namespace tw {

inline constexpr double width_of_place = 8;  ///< of a refined place around what it is named for, in its own spacings

/// The wake of the scene's hull: behind its middle to the outlet, or to `length` behind its stern, half as wide again as
/// the hull and down to its draft, and `width` more [m].
Box wake_of(const Scene& scene, double width, std::optional<double> length = {});

/// Spacing of the finest particles [m]: near_hull, or what a place of the scene asks for below it.
double finest_spacing(const Scene& scene);
/// How many sizes of particles are finer than near_hull, and how many there are in all.
int sizes_below_near_hull(const Scene& scene);
inline int sizes_of_particles(const Scene& scene) { return scene.sph.levels + sizes_below_near_hull(scene); }

}  // namespace tw
