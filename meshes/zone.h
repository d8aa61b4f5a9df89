#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "base/vec3.h"
#include "meshes/distance_grid.h"
#include "meshes/moved_solid.h"

namespace tw {

/// Where the water belongs to finer particles: a union of boxes, of the first of them only what is near a surface where
/// there is one. A face at infinity is no edge: there the zone ends at a wall, a symmetry plane or the open sky.
class Zone {
public:
    Zone() = default;
    explicit Zone(std::vector<Box> boxes) : boxes_(std::move(boxes)) {}
    /// Of the first box what is nearer than `width` [m].
    Zone(std::vector<Box> boxes, std::shared_ptr<const DistanceGrid> surface, double width)
        : boxes_(std::move(boxes)), surface_(std::move(surface)), width_(width) {}
    /// Of the first box what is as near to the surface of `start`, which has moved on by `way` since.
    Zone(std::vector<Box> boxes, const Zone& start, const Eigen::Isometry3d& way)
        : boxes_(std::move(boxes)), surface_(start.surface_), width_(start.width_), back_(way.inverse()) {}

    /// Distance from the edge [m], positive outside, negative inside; by the edges where two faces meet up to a half
    /// too near.
    double outside(const Vec3& x) const;
    /// `outside` changes by no more than this times the way between two places: it is linear between the nodes of a grid
    /// along each axis.
    static constexpr double steepest = 1.75;  ///< [-]

    /// What bounds a change of `outside` while the edge moves on: it is at most by + turn |x - pivot()| at a place x.
    struct Shift {
        double by = 0;    ///< [m]
        double turn = 0;  ///< [m per m from the pivot]
    };
    /// The change from `before`'s; none: the two have not the same parts, so it has no bound.
    std::optional<Shift> shift_since(const Zone& before) const;
    /// The middle of the surface that it follows, where that is now.
    Vec3 pivot() const;
    /// How far from the pivot the edge reaches round that surface, at most [m].
    double pivot_radius() const;

    const std::vector<Box>& boxes() const { return boxes_; }
    bool follows_surface() const { return surface_ != nullptr; }
    double width() const { return width_; }  ///< round the surface that it follows [m]
    /// Boxes that hold the zone, closer than `boxes` where it follows a surface: cut along x, for pictures.
    std::vector<Box> sliced() const;

private:
    std::vector<Box> boxes_;
    std::shared_ptr<const DistanceGrid> surface_;
    double width_ = 0;
    Eigen::Isometry3d back_ = Eigen::Isometry3d::Identity();  ///< to where the surface stood at the start
};

}  // namespace tw
