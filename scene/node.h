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

/// What a run, or the ranks of it that a node holds, need there but for the raster, which the first rank alone has [bytes].
double bytes_on(const Node& node, const Scene& scene, const MethodCost& cost, double raster_bytes);

/// refuse_oversize (scene.h) for another node than this machine with one process.
void refuse_oversize(const Scene& scene, const Prediction& prediction, const Node& node);

}  // namespace tw
