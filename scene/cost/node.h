#pragma once
#include <optional>

#include "record/this_machine.h"
#include "scene/scene.h"

namespace tw {

/// A machine that makes a run, or some of the ranks that share it, as far as it is known.
struct Node {
    std::optional<double> memory = machine_memory();  ///< [bytes]; none: not known, and nothing is compared with it
    int ranks = 1;                                    ///< how many of those that share the particles are there
};

/// What a run, or the ranks of it that a node holds, need there but for the raster, which the first rank alone has
/// [bytes]. The first rank is taken to be one of them.
double bytes_on(const Node& node, const Scene& scene, const MethodCost& cost, double raster_bytes);

inline constexpr double longest_run = 30 * 86400.0;  ///< [s]
inline constexpr double most_snapshots = 1e5, most_frames = 1e6;
/// Throws InputError at the key that is to blame when a run cannot be made on the node: more memory than it has, more than
/// `longest_run` of predicted time, too many samples or snapshots. Only the methods in `scene.run.methods` count.
void refuse_oversize(const Scene& scene, const Prediction& prediction, const Node& node = {});

}  // namespace tw
