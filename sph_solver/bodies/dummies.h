#pragma once
#include <vector>

#include "meshes/query.h"
#include "meshes/surface.h"

namespace tw {

/// A closed solid as dummy particles: the quadrature of the solid's part of every kernel support.
///
/// Cells of the particle lattice that lie wholly inside the surface, to a depth of `depth`, carry the cell's volume;
/// cells that the surface cuts carry the volume of their inner part at its centroid (measured by 6^3 samples). So the
/// volume of any closed surface, sharp keels and chines included, is met without fitting layers to its faces.
struct Dummies {
    std::vector<Vec3> places;     ///< [m]
    std::vector<double> volumes;  ///< [m3]; [m2] in two dimensions
};
/// Where a level of particles asks for dummies.
struct DummyLattice {
    double dp, depth;  ///< [m]
    Box region;
    int dimensions;
};
/// `region`: dummies outside it are left out. In two dimensions the lattice is the plane y = 0.
Dummies make_dummies(const SurfaceQuery& query, const Box& bounds, double dp, double depth, const Box& region,
                     int dimensions);

}  // namespace tw
