#include "sph_solver/seams.h"

#include <algorithm>
#include <cmath>

namespace tw {
namespace {

constexpr double moved_over_dp = 4;  ///< particles this near to a seam move: the rows that a kernel over it reaches

bool is_near(const Box& seam, const Vec3& x, double distance, bool flat) {
    for (int a = 0; a < 3; ++a)
        if ((a != 1 || !flat) && (x[a] < seam.min[a] - distance || x[a] > seam.max[a] + distance)) return false;
    return true;
}

}  // namespace

void even_out_seams(const EvenPacking& packing, std::span<const Box> water, std::span<const Lattice> lattices,
                    std::span<const SurfaceQuery> solids, const Zone* zone, Fluid& fluid) {
    const std::vector<Box> seams = unfit_seams(water, lattices);
    if (seams.empty()) return;
    const bool flat = packing.dimensions == 2;
    std::vector<char> moves(fluid.places.size(), 0);
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const Vec3& x = fluid.places[i];
        if (zone && !(zone->outside(x) < 0)) continue;
        moves[i] = std::ranges::any_of(
            seams, [&](const Box& seam) { return is_near(seam, x, moved_over_dp * packing.dp, flat); });
    }
    const std::vector<Vec3> before = fluid.places;
    even_out(fluid.places, moves, packing, water_in(water, solids, packing.dimensions));
    for (std::size_t i = 0; i < before.size(); ++i) fluid.depth[i] += before[i].z() - fluid.places[i].z();
}

}  // namespace tw
