#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// A hull with at most `most` triangles and 65536 points: as it is where it has no more, else points in one cell of a
/// lattice become one. Triangles with a corner that is not finite are dropped.
Surface light_surface(const Surface& surface, std::size_t most);

/// Surfaces for the page's script, all of them in one deflated block (RFC 1950), so that what one has in common with the
/// one before is there once. Of each surface first x, then y, then z of its points, as numbers from 0 to `steps` over the
/// box's edges (error at most half a step); behind those of all surfaces the corners of the triangles of each, as point
/// numbers. Every such row of numbers is stored as differences from the number before, modulo 65536, signs in the lowest
/// bit (zigzag), and of these first all low and then all high bytes.
class SurfacePack {
public:
    SurfacePack(const Box& box, unsigned steps) : box_(box), steps_(steps) {}
    /// Throws std::length_error above 65536 points.
    void add(const Surface& surface);
    std::size_t size() const { return points_.size(); }
    const std::vector<std::size_t>& points() const { return points_; }        ///< of each surface
    const std::vector<std::size_t>& triangles() const { return triangles_; }  ///< of each surface
    unsigned steps() const { return steps_; }
    std::string block() const;  ///< in base64

private:
    Box box_;
    unsigned steps_;
    std::string places_, corners_;
    std::vector<std::size_t> points_, triangles_;
};

}  // namespace tw
