#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec3.h"

namespace tw {

/// How a block of water is divided into cells of about dp, of which each holds a particle: the next whole number of
/// coarsest cells (2^halvings dp) along each edge, each halved `halvings` times. The cells fill the block, so that water
/// has the volume, the depth and the distance from its walls that the scene gives it at every size of particles.
struct Lattice {
    bool flat;                  ///< two dimensions: one cell of span 1 about the plane y = 0, in which particles stand
    Vec3 corner, cell;          ///< low corner of the block, edges of a cell [m]
    std::array<long, 3> count;  ///< cells along each edge

    Lattice(int dimensions, double dp, const Box& block, int halvings = 0) : flat(dimensions == 2), corner(block.min) {
        for (int a = 0; a < 3; ++a) {
            const auto coarse = static_cast<long>(std::llround(block.size()[a] / std::ldexp(dp, halvings)));
            count[static_cast<std::size_t>(a)] = coarse << halvings;
            cell[a] = block.size()[a] / static_cast<double>(std::max(1L, coarse << halvings));
        }
        if (flat) corner.y() = -0.5, cell.y() = 1, count[1] = 1;
    }
    double cells() const { return static_cast<double>(count[0] * count[1] * count[2]); }
    double volume() const { return cell.prod() * cells(); }  ///< [m3; in two dimensions m2]
    /// So many cells from the low corner [m].
    Vec3 place(double i, double j, double k) const { return corner + Vec3(i, flat ? 0.5 : j, k).cwiseProduct(cell); }
};

}  // namespace tw
