#pragma once
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// A stretch of a vertical line [m].
struct Stretch {
    double low = 0, high = 0;  ///< [m]
    double length() const { return high - low; }
};

/// What closed surfaces with outward normals take of the vertical line at (x, y), from below upwards; where they meet
/// or overlap they are one. Exact, and no face is met twice or missed at an edge.
class SolidColumn {
public:
    SolidColumn(double x, double y) : x_(x), y_(y) {}
    void add(const Surface& surface);
    std::vector<Stretch> stretches() const;

private:
    struct Face {
        double z;    ///< [m]
        int enters;  ///< 1: upwards a solid begins there; -1: one ends
    };
    double x_, y_;
    std::vector<Face> faces_;
};

}  // namespace tw
