#pragma once
// Clusters at walls, and the walls near their particles, which the host finds: plain data for kernels, as in tasks.h.
#include <cstddef>
#include <cstdint>

#include "sph_solver/cuda/sorting.h"
#include "sph_solver/loops/nearest_wall.h"
#include "sph_solver/loops/pressed.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw::cuda {

/// How many bodies each cluster has in reach, each of which gets a slot for its load.
struct CountWallLoads {
    const Cluster* clusters;
    const NeighbourBlock* blocks;
    const std::int32_t* body_end;
    int bodies;
    int *loads, *at_wall;

    void operator()(std::size_t n) const {
        const Cluster& g = clusters[n];
        int count = 0;
        for (std::int32_t k = 0, body = -1; k < g.wall_list.size; ++k) {
            int of = 0;
            while (of + 1 < bodies && blocks[g.wall_list.first + k].first >= body_end[of]) ++of;
            count += of != body;
            body = of;
        }
        loads[n] = count, at_wall[n] = count > 0;
    }
};
/// A cluster at a wall, and its centre [m].
struct ClusterAtWall {
    Cluster cluster;
    double x, y, z;  ///< [m]
};
struct ListClustersAtWalls {
    Pencils pencils;
    const int* pencil;
    const int *first_load, *at_wall, *before;
    double origin[3], unit;  ///< [m]
    Cluster* clusters;
    ClusterAtWall* list;

    void operator()(std::size_t n) const {
        Cluster& g = clusters[n];
        g.wall_load = at_wall[n] ? first_load[n] : -1;
        if (!at_wall[n]) return;
        const WidePlace c = pencils.centre(pencil[n]);
        const auto metres = [&](std::int32_t q, std::int64_t near, double from) {
            return from + unit * static_cast<double>(near + difference(q, static_cast<std::int32_t>(near)));
        };
        list[before[n]] = {g, metres(g.x, c.x, origin[0]), metres(g.y, c.y, origin[1]), metres(g.z, c.z, origin[2])};
    }
};
/// Marks those that bodies may press on.
struct MarkPressed {
    MayBePressed condition;
    int* pressed;

    void operator()(std::size_t i) const { pressed[i] = condition(i); }
};
/// Where a particle is that may be near a wall.
struct NearWall {
    double x, y, z;      ///< [m]
    float u, v, w;       ///< [m/s]
    std::int32_t index;  ///< -1: none
    Kind kind;
};
struct TakeNearWalls {
    StateView p;
    const Kind* kind;
    const ClusterAtWall* list;
    NearWall* to;

    void operator()(std::size_t k) const {
        const Cluster& g = list[k / lanes_of_cluster].cluster;
        const int l = static_cast<int>(k % lanes_of_cluster);
        NearWall& near = to[k];
        near.index = l < g.size ? g.first + l : -1;
        if (near.index < 0) return;
        const auto i = static_cast<std::size_t>(near.index);
        near.x = p.x[i], near.y = p.y[i], near.z = p.z[i];
        near.u = p.u[i], near.v = p.v[i], near.w = p.w[i];
        near.kind = kind[i];
    }
};
struct NoWalls {
    FieldsView p;

    void operator()(std::size_t i) const { NearestWall().note(p, i); }
};
/// What the host has found of them.
struct WallFound {
    std::int32_t index;
    NearestWall wall;
};
struct PutWalls {
    const WallFound* found;
    FieldsView p;

    void operator()(std::size_t k) const {
        const WallFound& f = found[k];
        if (f.index >= 0) f.wall.note(p, static_cast<std::size_t>(f.index));
    }
};

}  // namespace tw::cuda
