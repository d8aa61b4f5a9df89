#pragma once
#include <string>

#include "scene/read/read.h"

namespace tw {

// What can only be checked once several sections are known. Each throws InputError at the key that is to blame.

/// Surface findings of a hull; repairs it first where the scene says so.
void check_health(HullOptions& o, double particle_spacing, SceneSection& s);
/// Two dimensions: the hull becomes its section with the plane y = 0, one metre of it, and the draft that of the
/// section.
void take_section(HullOptions& o, SceneSection& s);
/// A half model is solved at y > 0 and reported twice. Sides that differ by more than rounding, but by less than the
/// particles can tell (a tenth of their spacing, at the scale that the scene was written for), are made alike.
void make_halves_alike(Hull& hull, const Resolution& resolution, SceneSection& s);
/// In the water, and clear of the domain's sides. `key`: what gave the surface, "file" or "shape".
void check_hull_place(const Scene& scene, Sections& s, const std::string& key);
/// Water blocks, obstacles and probes lie inside the domain; in two dimensions they get its thickness.
void check_places(Scene& scene, Sections& s);
/// Bodies that move start inside the domain, clear of its walls, of obstacles and of each other, with numerics that can
/// move them. What is odd about them becomes a finding.
void check_bodies(Scene& scene, Sections& s);
/// Refuses what is not solved in a tank that moves; after the effects are known.
void check_tank_motion(const Scene& scene, Sections& s);
/// A hull is free in a stream only, with numerics that can move it; what is odd about it becomes a finding.
void check_free_hull(Scene& scene, Sections& s);
/// Refuses what elastic bodies cannot be solved with; after the effects are known.
void check_elastic(const Scene& scene, Sections& s);
/// A gate is a plane in three dimensions, and takes particles of one size in water alone; after the effects are known.
void check_gate(const Scene& scene, const SceneSection& sph);
/// The run would be stopped as soon as the water moves faster than its sound.
void check_sound_speed(const Scene& scene);

}  // namespace tw
