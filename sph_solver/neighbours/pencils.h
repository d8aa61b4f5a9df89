#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/neighbours/pencil_grid.h"
#include "sph_solver/pair_loops/packed.h"
#include "sph_solver/pair_loops/passes.h"

namespace tw {

/// Positions as integers: fixed-point units from `origin`, dp / 2^18 in the solver, so that differences are exact in
/// every pair.
///
/// The passes see 32 bits of them, which wrap every 2^32 fixed-point units (16384 dp): the difference of two places is
/// exact as long as they are within 8192 dp of each other, whatever the length of the domain. Who may be neighbours is
/// known from the pencils.
///
/// Levels of different spacing have the same origin and fixed-point units that are powers of two of one another, so
/// that a place goes from one level to the next by a shift.
struct FixedPoint {
    Vec3 origin = Vec3::Zero();
    double size = 1;       ///< [m]
    double per_metre = 1;  ///< 1 / size [1/m]
    FixedPoint() = default;
    FixedPoint(const Vec3& at, double metres) : origin(at), size(metres), per_metre(1 / metres) {}
    std::int64_t wide(double x, int axis) const { return std::llrint((x - origin[axis]) * per_metre); }
    WidePlace wide(const Vec3& x) const { return {wide(x.x(), 0), wide(x.y(), 1), wide(x.z(), 2)}; }
    std::int32_t of(double x, int axis) const { return static_cast<std::int32_t>(wide(x, axis)); }
    /// The place [m] of a coordinate that is known to lie within 8000 dp of `near`.
    double metres(std::int32_t q, int axis, double near) const {
        const std::int64_t from = wide(near, axis);
        return origin[axis] + size * static_cast<double>(from + difference(q, static_cast<std::int32_t>(from)));
    }
};

/// Such pencils over a box.
struct PencilGrid : Pencils {
    PencilGrid() = default;
    /// `area`: the box to cover [m]. Pencils are as wide as a cube of `lanes` particles (in 2-D: a square). Throws
    /// InputError where there would be more than 10^9 of them.
    PencilGrid(const Box& area, double dp, int dimensions, const FixedPoint& fixed_point, int lanes);
    /// The same box in pencils `factor` times as wide.
    PencilGrid scaled(double factor) const;
};

/// Order that sorts places by pencil, then z, then x, y: a function of the places alone. `start` gets the first index
/// of each pencil (count + 1 entries).
void sort_by_pencil(const PencilGrid& grid, const std::vector<WidePlace>& places, std::vector<std::int32_t>& order,
                    std::vector<std::int32_t>& start);

/// Sorted places in which neighbours are looked for.
struct Source {
    const PencilGrid* grid;     ///< that they are sorted by
    const PackedPlace* places;  ///< indexed by pencil start + offset
    const std::vector<std::int32_t>* start;
    std::int32_t offset;  ///< index of the first place in the pass's index space
};

/// Sorts those of a pencil that have the same place by `id`: then the order does not depend on what it was before.
void order_coincident(const std::vector<WidePlace>& places, const std::vector<std::int32_t>& start,
                      const std::function<std::int64_t(std::int32_t)>& id, std::vector<std::int32_t>& order);

/// Cuts each pencil of sorted places into clusters of up to `lanes`. `wanted`: which pencils; empty: all.
void make_clusters(const Source& places, int lanes, std::vector<Cluster>& clusters,
                   const std::function<bool(int pencil)>& wanted = {});

/// Gives every cluster with walls near its slots for loads, one for each body that it has in reach (see
/// WallView::body_end); returns how many slots there are.
std::int32_t number_wall_loads(std::vector<Cluster>& clusters, const Lists& walls,
                               const std::vector<std::int32_t>& body_end);

/// Storage of neighbour lists; clusters refer to it.
class NeighbourLists {
public:
    /// For every cluster, as its `list`, source by source, the indices of all source places within `reaches` [m]. The
    /// clusters are those of `targets`.
    void build(const Passes& passes, const FixedPoint& fixed_point, const Source& targets,
               std::vector<Cluster>& clusters, const std::vector<Source>& sources, const Reaches& reaches,
               ListRef Cluster::*list = &Cluster::list);
    /// Good until the lists are built anew or moved.
    Lists view() const { return {starts_.data()}; }
    const std::vector<std::vector<NeighbourBlock>>& chunks() const { return chunks_; }
    std::size_t bytes() const;

private:
    std::vector<std::vector<NeighbourBlock>> chunks_;
    std::vector<NeighbourBlock*> starts_;
};

}  // namespace tw
