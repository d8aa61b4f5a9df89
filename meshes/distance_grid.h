#pragma once
#include <array>
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// Signed distance from a closed surface [m], positive outside, at the nodes of a grid over a box; linear between them,
/// and beyond the box that of its nearest place. For questions about many places that need no more than a fraction of
/// the grid's spacing.
class DistanceGrid {
public:
    /// `spacing`: of the nodes [m]; it is made a little smaller where the box is no multiple of it. Distances end at
    /// `reach` [m].
    DistanceGrid(const Surface& closed, const Box& box, double spacing, double reach);
    double at(const Vec3& x) const;
    /// From now on each place is as near as the nearest one that lies before it along the axis: the neighbourhood of
    /// the surface goes on through that face of the box.
    void draw_out(int axis, bool towards_high);

    /// Bounds of what is nearer than `distance` [m] within `part`, to a cell of the grid; without volume where nothing
    /// is. A face of `part` at infinity stays there.
    Box nearer_than(double distance, const Box& part) const;

    const Box& box() const { return box_; }

private:
    std::size_t node(int i, int j, int k) const {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(count_[0]) +
               static_cast<std::size_t>(i);
    }
    Vec3 place(std::size_t node) const;

    Box box_;
    Vec3 spacing_;
    std::array<int, 3> count_;  ///< nodes, at least two each way
    std::vector<float> distance_;
};

}  // namespace tw
