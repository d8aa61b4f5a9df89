#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/levels/particle_system.h"

namespace tw {

/// Points in the order and the clusters in which the pair loops visit them, beside a level's particles.
struct SortedPlaces {
    PencilGrid grid;
    std::vector<std::int32_t> order, start;  ///< order[k]: which point stands at k; first point of each pencil
    std::vector<PackedPlace> places;
    std::vector<Cluster> clusters;
    NeighbourLists lists;

    /// `apart`: distance between points [spacings of the level]. `wanted`: which pencils of them; empty: all.
    SortedPlaces(const std::vector<Vec3>& points, double apart, const ParticleSystem& level,
                 const std::function<bool(int)>& wanted = {})
        : grid(level.grid.scaled(apart)) {
        std::vector<WidePlace> raw(points.size());
        for_particles(raw.size(), [&](std::size_t k) { raw[k] = level.fixed_point.wide(points[k]); });
        sort_by_pencil(grid, raw, order, start);
        places.resize(raw.size());
        for_particles(raw.size(),
                      [&](std::size_t k) { places[k] = raw[static_cast<std::size_t>(order[k])].packed(0); });
        make_clusters(sorted(), level.passes.lanes, clusters, wanted);
    }
    SortedPlaces(const SortedPlaces&) = delete;

    Source sorted() const { return {&grid, places.data(), &start, 0}; }

    /// Of a kernel, among a level's sources.
    void find_neighbours(const Kernel& kernel, const ParticleSystem& level, const std::vector<Source>& sources) {
        lists.build(level.passes, level.fixed_point, sorted(), clusters, sources, level.reaches_of_points(kernel));
    }
};

}  // namespace tw
