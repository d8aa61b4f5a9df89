#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace tw {

/// How a block of water is divided into cells of about dp, of which each holds a particle: the next whole number of
/// coarsest cells (2^halvings dp) along each edge, each halved `halvings` times. The cells fill the block, so that
/// water has the volume, the depth and the distance from its walls that the scene gives it at every size of
/// particles.
struct Lattice {
    bool flat;                  ///< two dimensions: one cell of span 1 about the plane y = 0, in which particles stand
    Vec3 corner, cell;          ///< low corner of the block, edges of a cell [m]
    std::array<long, 3> count;  ///< cells along each edge

    Lattice(int dimensions, double dp, const Box& block, int halvings = 0) : flat(dimensions == 2), corner(block.min) {
        std::array<long, 3> coarse{};
        for (int a = 0; a < 3; ++a)
            coarse[static_cast<std::size_t>(a)] =
                static_cast<long>(std::llround(block.size()[a] / std::ldexp(dp, halvings)));
        divide(block, coarse, halvings);
    }
    /// With so many of the coarsest cells along each edge.
    Lattice(int dimensions, const Box& block, const std::array<long, 3>& coarse, int halvings)
        : flat(dimensions == 2), corner(block.min) {
        divide(block, coarse, halvings);
    }
    double cells() const { return static_cast<double>(count[0] * count[1] * count[2]); }
    double volume() const { return cell.prod() * cells(); }  ///< [m3; in two dimensions m2]
    /// So many cells from the low corner [m].
    Vec3 place(double i, double j, double k) const { return corner + Vec3(i, flat ? 0.5 : j, k).cwiseProduct(cell); }

private:
    void divide(const Box& block, const std::array<long, 3>& coarse, int halvings) {
        for (int a = 0; a < 3; ++a) {
            count[static_cast<std::size_t>(a)] = coarse[static_cast<std::size_t>(a)] << halvings;
            cell[a] = block.size()[a] / static_cast<double>(std::max(1L, count[static_cast<std::size_t>(a)]));
        }
        if (flat) corner.y() = -0.5, cell.y() = 1, count[1] = 1;
    }
};

/// Of boxes that touch. All particles have one mass, so the cells of each box are given about the volume of dp in each
/// direction: a box whose edges are no whole numbers of dp gets cells that are flatter or taller, of which there are
/// the right number. The counts are those that keep cells of that volume as cubical as may be.
std::vector<Lattice> lattices_of(int dimensions, double dp, std::span<const Box> boxes, int halvings = 0);

/// A face that two of the boxes share and at which their lattices do not fit together: a flat box.
std::vector<Box> unfit_seams(std::span<const Box> boxes, std::span<const Lattice> lattices);

}  // namespace tw
