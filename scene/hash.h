#pragma once
#include <string>

#include "scene/scene.h"

namespace tw {

/// Every number that both methods use, one per line, in canonical form (shortest digits that give the same double): the
/// keys that the table calls `Hashed::scene`, and what follows from them; and the names of bodies, obstacles, probes and
/// gauges, those of the record's tables and columns. Not in it: title, paths, comments, [sph] and [fvm] numerics, how a run
/// begins, methods, threads, device, checkpoints, snapshots and duration (runs of different length answer the same question).
std::string canonical_text(const Scene& scene);
/// SHA-256 of the canonical text.
std::string scene_hash(const Scene& scene);
/// SHA-256 of the scene, of one method's numerics and of how a run begins (ramp, release). A run is resumed, and a finished run is reused, only if it
/// matches. `method`: sph, fvm.
std::string run_hash(const Scene& scene, const std::string& method);
/// The run hash without the resolution: no spacing, near_hull or scale, and nothing that follows from them (refinement,
/// faces moved to multiples of the sizes, voxels of default size). Runs of one scene at several sizes share it.
std::string family_hash(const Scene& scene, const std::string& method);

}  // namespace tw
