#pragma once
#include <string>

#include "scene/scene.h"

namespace tw {

/// Every number that both methods use, one per line, in canonical form (shortest digits that give the same double).
/// Not in it: title, paths, comments, [sph] and [fvm] numerics, methods, threads, checkpoints, snapshots, duration and
/// start-up ramp (runs of different length answer the same question).
std::string canonical_text(const Scene& scene);
/// SHA-256 of the canonical text.
std::string scene_hash(const Scene& scene);
/// SHA-256 of the scene and of one method's numerics: what a run goes on from, or is taken for, must have the same.
/// `method`: sph, fvm.
std::string run_hash(const Scene& scene, const std::string& method);

}  // namespace tw
