#pragma once
#include <vector>

#include "scene/scene_section.h"

namespace tw {

/// The places of the scene's [[refine]] sections, after its domain is made. Throws InputError at the key that is wrong.
std::vector<RefinedPlace> read_refined(std::vector<SceneSection>& sections, const Scene& scene);

/// The wake of the scene's hull for particles of `size` [m]: behind its middle to the outlet, half as wide again as the
/// hull and down to its draft, and eight spacings more.
Box wake_of(const Scene& scene, double size);

/// Spacing of the finest particles [m]: near_hull, or what a place of the scene asks for below it.
double finest_spacing(const Scene& scene);
/// How many sizes of particles are finer than near_hull, and how many there are in all.
int sizes_below_near_hull(const Scene& scene);
inline int sizes_of_particles(const Scene& scene) { return scene.sph.levels + sizes_below_near_hull(scene); }

}  // namespace tw
