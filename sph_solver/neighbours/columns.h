#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/backend/pass_data.h"

namespace tw {

/// Positions as integers: quanta from `origin`, dp / 2^18 in the solver, so that differences are exact in every pair.
struct Quanta {
    Vec3 origin = Vec3::Zero();
    double size = 1;       ///< [m]
    double per_metre = 1;  ///< 1 / size
    Quanta() = default;
    Quanta(const Vec3& at, double metres) : origin(at), size(metres), per_metre(1 / metres) {}
    std::int32_t of(double x, int axis) const {
        return static_cast<std::int32_t>(std::lrint((x - origin[axis]) * per_metre));
    }
    /// Half of the range that 32 bits hold [m].
    double reach() const { return size * 2147483000.0; }
};

/// Vertical columns of square cross-section over a box; what lies outside belongs to the nearest column.
struct ColumnGrid {
    std::int32_t x0 = 0, y0 = 0, width = 1;  ///< [quanta]
    int nx = 1, ny = 1;

    /// `area`: the box to cover [m]. Columns are as wide as a cube of simd::lanes particles (in 2-D: a square).
    ColumnGrid() = default;
    ColumnGrid(const Box& area, double dp, int dimensions, const Quanta& quanta);
    int count() const { return nx * ny; }
    int column_x(std::int64_t x) const { return clamp((x - x0) / width, nx); }
    int column_y(std::int64_t y) const { return clamp((y - y0) / width, ny); }
    int of(const PlaceRecord& p) const { return column_y(p.y) * nx + column_x(p.x); }

    /// Distance between a column, or a row of columns, and an interval [quanta]; those at the rim reach to infinity.
    double gap_x(int cx, std::int64_t lo, std::int64_t hi) const { return gap(cx, nx, lo - x0, hi - x0); }
    double gap_y(int cy, std::int64_t lo, std::int64_t hi) const { return gap(cy, ny, lo - y0, hi - y0); }

private:
    double gap(int c, int n, std::int64_t lo, std::int64_t hi) const {
        const std::int64_t begin = std::int64_t{c} * width, end = begin + width;
        if (c > 0 && hi < begin) return double(begin - hi);
        if (c < n - 1 && lo > end) return double(lo - end);
        return 0;
    }
    static int clamp(std::int64_t i, int n) { return i < 0 ? 0 : i >= n ? n - 1 : static_cast<int>(i); }
};

/// Order that sorts places by column, then z, then x, y: a function of the places alone. `start` gets the first index
/// of each column (count + 1 entries).
void sort_by_column(const ColumnGrid& grid, const std::vector<PlaceRecord>& places, std::size_t begin, std::size_t end,
                    std::vector<std::int32_t>& order, std::vector<std::int32_t>& start);

/// Cuts each column of sorted places [first, first + n) into groups of up to simd::lanes.
void make_groups(const std::vector<PlaceRecord>& places, const std::vector<std::int32_t>& start, std::size_t first,
                 std::vector<Group>& groups);

/// Gives every group with walls near its slots for loads, one for each body that it has in reach (see
/// PassData::body_end); returns how many slots there are.
std::int32_t number_wall_loads(std::vector<Group>& groups, const Lists& walls,
                               const std::vector<std::int32_t>& body_end);

/// Sorted places in which neighbours are looked for.
struct Source {
    const PlaceRecord* places;  ///< indexed by column start + offset
    const std::vector<std::int32_t>* start;
    std::int32_t offset;  ///< index of the first place in the pass's index space
};

/// Storage of neighbour lists; groups refer to it.
class NeighbourLists {
public:
    /// For every group, as its `list`, source by source, the indices of all source places within `reaches` [m].
    void build(const ColumnGrid& grid, const Quanta& quanta, const PlaceRecord* targets, std::vector<Group>& groups,
               const std::vector<Source>& sources, const Reaches& reaches, ListRef Group::*list = &Group::list);
    /// Good until the lists are built anew or moved.
    Lists view() const { return {starts_.data()}; }
    std::size_t bytes() const;

private:
    std::vector<std::vector<NeighbourBlock>> chunks_;
    std::vector<NeighbourBlock*> starts_;
};

}  // namespace tw
