#pragma once
#include <functional>
#include <span>
#include <vector>

#include "sph_solver/bodies/load.h"
#include "sph_solver/pair_loops/clusters.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// Adds to the sum of each body what its walls do to the water, by what a pair loop has left of each cluster's load:
/// per unit of particle mass [m/s2], [m2/s2]. `arm`: from the point of reference to a cluster's centre [m].
///
/// Within a cluster the loads are summed in single precision, lane by lane. Who makes a cluster with whom depends on
/// the places of the particles alone, not on how they are kept (neighbours/pencils.h).
void add_cluster_loads(std::span<const Cluster> clusters, std::span<const WallLoad> of_clusters,
                       const std::function<Vec3(const Cluster&)>& arm, std::span<PushSum> of_bodies);

}  // namespace tw
