#pragma once
#include "scene/read/read.h"

namespace tw {

/// Particle spacing and largest cell: as written, else from the hull; the ratio is always a power of two.
Resolution resolution_of(const ResolutionOptions& o, const Hull* hull, SceneSection& s, double scale);
/// Throws InputError at the size that is to blame: a particle that the smallest of `lengths` cannot hold twice, or a
/// cell larger than all of them.
void check_sizes(const Resolution& r, std::initializer_list<double> lengths, const char* of_what, SceneSection& s);
/// The domain with its sides, from the scene's [domain] or [tank], resolution, motion and hull. `depth`: of the place
/// [m]. `box_factor`: see SceneOverrides.
Domain domain_of(const DomainOptions& o, const std::optional<Box>& tank, const Scene& scene, Sections& s,
                 std::optional<double> depth, double box_factor = 1);

}  // namespace tw
