#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/neighbours/wide_place.h"
#include "sph_solver/sweeps/passes.h"
#include "sph_solver/sweeps/records.h"

namespace tw {

/// Positions as integers: quanta from `origin`, dp / 2^18 in the solver, so that differences are exact in every pair.
///
/// The passes see 32 bits of them, which wrap every 2^32 quanta (16384 dp): the difference of two places is exact as
/// long as they are within 8192 dp of each other, whatever the length of the domain. Who may be neighbours is known
/// from the columns.
///
/// Levels of different spacing have the same origin and quanta that are powers of two of one another, so that a place
/// goes from one level to the next by a shift.
struct Quanta {
    Vec3 origin = Vec3::Zero();
    double size = 1;       ///< [m]
    double per_metre = 1;  ///< 1 / size
    Quanta() = default;
    Quanta(const Vec3& at, double metres) : origin(at), size(metres), per_metre(1 / metres) {}
    std::int64_t wide(double x, int axis) const { return std::llrint((x - origin[axis]) * per_metre); }
    WidePlace wide(const Vec3& x) const { return {wide(x.x(), 0), wide(x.y(), 1), wide(x.z(), 2)}; }
    std::int32_t of(double x, int axis) const { return static_cast<std::int32_t>(wide(x, axis)); }
    /// The place [m] of a coordinate that is known to lie within 8000 dp of `near`.
    double metres(std::int32_t q, int axis, double near) const {
        const std::int64_t from = wide(near, axis);
        return origin[axis] + size * static_cast<double>(from + difference(q, static_cast<std::int32_t>(from)));
    }
};

/// Upright columns of square cross-section over a box, cut into slabs where the box is taller than 4096 dp; what lies
/// outside belongs to the nearest column. Within a column places are compared by their 32 bits, from its centre.
struct ColumnGrid {
    std::int64_t x0 = 0, y0 = 0, z0 = 0, width = 1, height = 1;  ///< [quanta]
    int nx = 1, ny = 1, nz = 1;

    ColumnGrid() = default;
    /// `area`: the box to cover [m]. Columns are as wide as a cube of `lanes` particles (in 2-D: a square).
    ColumnGrid(const Box& area, double dp, int dimensions, const Quanta& quanta, int lanes);
    int count() const { return nx * ny * nz; }
    int column_x(std::int64_t x) const { return clamp((x - x0) / width, nx); }
    int column_y(std::int64_t y) const { return clamp((y - y0) / width, ny); }
    int slab(std::int64_t z) const { return clamp((z - z0) / height, nz); }
    int column(int cx, int cy, int cz) const { return (cz * ny + cy) * nx + cx; }
    int of(const WidePlace& p) const { return column(column_x(p.x), column_y(p.y), slab(p.z)); }
    /// The same box in columns `factor` times as wide.
    ColumnGrid scaled(double factor) const;
    WidePlace centre(int column) const {
        return {x0 + (column % nx) * width + width / 2, y0 + (column / nx % ny) * width + width / 2,
                middle_of_slab(column / nx / ny)};
    }
    std::int64_t middle_of_slab(int cz) const { return z0 + cz * height + height / 2; }

    /// Distance between a column, or a row of columns, and an interval [quanta]; those at the rim reach to infinity.
    double gap_x(int cx, std::int64_t lo, std::int64_t hi) const { return gap(cx, nx, lo - x0, hi - x0); }
    double gap_y(int cy, std::int64_t lo, std::int64_t hi) const { return gap(cy, ny, lo - y0, hi - y0); }

private:
    double gap(int c, int n, std::int64_t lo, std::int64_t hi) const {
        const std::int64_t begin = c * width, end = begin + width;
        if (c > 0 && hi < begin) return double(begin - hi);
        if (c < n - 1 && lo > end) return double(lo - end);
        return 0;
    }
    static int clamp(std::int64_t i, int n) { return i < 0 ? 0 : i >= n ? n - 1 : static_cast<int>(i); }
};

/// Order that sorts places by column, then z, then x, y: a function of the places alone. `start` gets the first index
/// of each column (count + 1 entries).
void sort_by_column(const ColumnGrid& grid, const std::vector<WidePlace>& places, std::vector<std::int32_t>& order,
                    std::vector<std::int32_t>& start);

/// Sorted places in which neighbours are looked for.
struct Source {
    const ColumnGrid* grid;     ///< that they are sorted by
    const PlaceRecord* places;  ///< indexed by column start + offset
    const std::vector<std::int32_t>* start;
    std::int32_t offset;  ///< index of the first place in the pass's index space
};

/// Sorts those of a column that have the same place by `id`: then the order does not depend on what it was before.
void order_coincident(const std::vector<WidePlace>& places, const std::vector<std::int32_t>& start,
                      const std::function<std::int64_t(std::int32_t)>& id, std::vector<std::int32_t>& order);

/// Cuts each column of sorted places into groups of up to `lanes`. `wanted`: which columns; empty: all.
void make_groups(const Source& places, int lanes, std::vector<Group>& groups,
                 const std::function<bool(int column)>& wanted = {});

/// Gives every group with walls near its slots for loads, one for each body that it has in reach (see
/// WallView::body_end); returns how many slots there are.
std::int32_t number_wall_loads(std::vector<Group>& groups, const Lists& walls,
                               const std::vector<std::int32_t>& body_end);

/// Storage of neighbour lists; groups refer to it.
class NeighbourLists {
public:
    /// For every group, as its `list`, source by source, the indices of all source places within `reaches` [m]. The
    /// groups are those of `targets`.
    void build(const Passes& passes, const Quanta& quanta, const Source& targets, std::vector<Group>& groups,
               const std::vector<Source>& sources, const Reaches& reaches, ListRef Group::*list = &Group::list);
    /// Good until the lists are built anew or moved.
    Lists view() const { return {starts_.data()}; }
    const std::vector<std::vector<NeighbourBlock>>& chunks() const { return chunks_; }
    std::size_t bytes() const;

private:
    std::vector<std::vector<NeighbourBlock>> chunks_;
    std::vector<NeighbourBlock*> starts_;
};

}  // namespace tw
