#pragma once
// Finding neighbours among sorted places: plain data for kernels, as in tasks.h.
#include <cstddef>
#include <cstdint>

#include "sph_solver/cuda/sorting.h"
#include "sph_solver/neighbours/pencil_grid.h"
#include "sph_solver/pair_loops/clusters.h"

namespace tw::cuda {

/// Sorted places in which neighbours are looked for.
struct DeviceSource {
    const PackedPlace* places;
    const int* start;  ///< first place of each pencil (times `stride`)
    int stride;
    std::int32_t offset;  ///< index of the first place in the pair loops' index space

    int first_of(int pencil) const { return start[std::int64_t{pencil} * stride]; }
};

/// Clusters that have some.
struct HasNeighbours {
    bool operator()(const Cluster& g) const { return g.list.size > 0; }
};

/// How many pairs the pair loops visit for a cluster, with the particles themselves.
struct WorkOfClusters {
    const Cluster* clusters;
    const NeighbourBlock *blocks, *wall_blocks;
    int* work;

    void operator()(std::size_t n) const {
        const Cluster& g = clusters[n];
        int live = 0;
        for (std::int32_t k = 0; k < g.list.size; ++k) live += __builtin_popcount(blocks[g.list.first + k].live);
        for (std::int32_t k = 0; k < g.wall_list.size; ++k)
            live += __builtin_popcount(wall_blocks[g.wall_list.first + k].live);
        work[n] = g.size * (1 + live);
    }
};

/// Who is within reach of each cluster's particles, block by block as Search in neighbours/pencils.cpp finds them. A
/// first run counts the blocks, a second one writes them.
struct SearchNeighbours {
    Pencils pencils;            ///< of the sources
    Pencils of_clusters;        ///< the same, or others over the same box
    const PackedPlace* places;  ///< of the clusters
    const int* pencil;          ///< of each cluster
    Cluster* clusters;
    const DeviceSource* sources;
    int source_count;
    double reach;     ///< [fixed-point units], with what the sources may have moved
    Reaches reaches;  ///< [fixed-point units]
    bool write;       ///< the second run
    int* count;       ///< of blocks; in the second run the first of each cluster's
    NeighbourBlock* blocks;
    ListRef Cluster::*list;

    /// `ask(first, end, count, top)`: who of so many places is near, and not above a height, as Passes::reached says.
    template <class Ask, class Once>
    void operator()(std::size_t n, const Ask& ask, const Once& once) const {
        const Cluster g = clusters[n];
        const WidePlace centre = of_clusters.centre(pencil[n]);
        const ClusterBox box = box_of(places, g, centre);
        const std::int64_t cluster_z = centre.z + difference(g.z, static_cast<std::int32_t>(centre.z));
        const int first = write ? count[n] : 0;
        int found = 0;
        for (int s = 0; s < source_count; ++s) search(sources[s], box, cluster_z, ask, once, first, found);
        once([&] {
            if (write)
                clusters[n].*list = {0, first, found};
            else
                count[n] = found;
        });
    }

private:
    template <class Ask, class Once>
    void search(const DeviceSource& source, const ClusterBox& box, std::int64_t cluster_z, const Ask& ask,
                const Once& once, int first, int& found) const {
        const auto r = whole_above(reach);
        const PackedPlace* const all_end = source.places + source.first_of(pencils.count());
        const int x0 = pencils.pencil_x(box.lo[0] - r), x1 = pencils.pencil_x(box.hi[0] + r),
                  y0 = pencils.pencil_y(box.lo[1] - r), y1 = pencils.pencil_y(box.hi[1] + r),
                  z1 = pencils.slab(box.hi[2] + r);
        for (int cz = pencils.slab(box.lo[2] - r); cz <= z1; ++cz) {
            const std::int64_t middle = pencils.middle_of_slab(cz);
            const auto height = [&](const PackedPlace& p) {
                return std::int64_t{difference(p.z, static_cast<std::int32_t>(middle))} + middle;
            };
            for (int cy = y0; cy <= y1; ++cy) {
                const double gap_y = pencils.gap_y(cy, box.lo[1], box.hi[1]);
                for (int cx = x0; cx <= x1; ++cx) {
                    const double gap_x = pencils.gap_x(cx, box.lo[0], box.hi[0]);
                    const double left2 = reach * reach - gap_x * gap_x - gap_y * gap_y;
                    if (left2 < 0) continue;
                    const std::int64_t up = whole_above(std::sqrt(left2)), top = box.hi[2] + up;
                    const int c = pencils.pencil(cx, cy, cz);
                    const PackedPlace* p = source.places + source.first_of(c);
                    const PackedPlace* const end = source.places + source.first_of(c + 1);
                    for (std::int64_t left = end - p; left > 0;) {  // the first that is not below
                        const std::int64_t half = left / 2;
                        if (height(p[half]) < box.lo[2] - up)
                            p += half + 1, left -= half + 1;
                        else
                            left = half;
                    }
                    for (; p < end && height(*p) < top + 1; p += 32) {
                        const int n = end - p < 32 ? static_cast<int>(end - p) : 32;
                        const Reached near = ask(p, all_end, n, top - cluster_z);
                        if (near.far == 0) continue;
                        if (write)
                            once([&] {
                                blocks[first + found] = {source.offset + static_cast<std::int32_t>(p - source.places),
                                                         near.now, near.far & ~near.sure};
                            });
                        ++found;
                    }
                }
            }
        }
    }
    static std::int64_t whole_above(double x) {
        const auto whole = static_cast<std::int64_t>(x);
        return static_cast<double>(whole) < x ? whole + 1 : whole;
    }
};

}  // namespace tw::cuda
