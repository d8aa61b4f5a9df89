#include <algorithm>
#include <cmath>

#include "base/disjoint_boxes.h"
#include "sph_solver/lattice.h"
#include "sph_solver/seams.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace {

/// Middles of the cells of those families of two cells along each edge that are `wanted(middle of the family)`.
template <class Wanted>
std::vector<Vec3> places_in(const Lattice& lattice, const Wanted& wanted) {
    std::vector<Vec3> all;
    const auto [nx, ny, nz] = lattice.count;
    for (long k = 0; k < nz; ++k)
        for (long j = 0; j < ny; ++j)
            for (long i = 0; i < nx; i += 2) {
                if (!wanted(lattice.place(double(i + 1), double(j - j % 2 + 1), double(k - k % 2 + 1)))) continue;
                for (long n = i; n < std::min(i + 2, nx); ++n)
                    all.push_back(lattice.place(double(n) + 0.5, double(j) + 0.5, double(k) + 0.5));
            }
    return all;
}
constexpr auto everywhere = [](const Vec3&) { return true; };

/// Keeps what is outside the solids.
void add_outside(const std::vector<Vec3>& places, const std::vector<SurfaceQuery>& solids, double dp, double surface,
                 Fluid& out) {
    std::vector<double> distance(places.size(), 1e30), d(places.size());
    for (const SurfaceQuery& q : solids) {
        q.signed_distances(places, d, 2 * dp);
        for (std::size_t k = 0; k < d.size(); ++k) distance[k] = std::min(distance[k], d[k]);
    }
    for (std::size_t k = 0; k < places.size(); ++k)
        if (distance[k] > 0) {
            out.places.push_back(places[k]);
            out.depth.push_back(surface - places[k].z());
        }
}

std::vector<SurfaceQuery> queries_of(const SimulationSetup& s) {
    std::vector<SurfaceQuery> queries;
    for (const BodySetup& body : s.bodies) queries.emplace_back(body.surface);
    return queries;
}

/// Those families of particles of one spacing, halved so often from the coarsest, that are wanted. Blocks that touch
/// are one water: no place is filled twice, and where their lattices do not fit the particles are evened out.
template <class Wanted>
Fluid fill(const SimulationSetup& s, double dp, int halvings, const std::vector<SurfaceQuery>& solids,
           const std::vector<std::vector<Box>>& waters, const Wanted& wanted, const Zone* zone = nullptr) {
    Fluid fluid;
    double volume = 0, cells = 0;  // all particles of a level have one mass: blocks share the mean
    std::vector<std::vector<Lattice>> lattices;
    for (const std::vector<Box>& water : waters) {
        lattices.push_back(lattices_of(s.dimensions, dp, water, halvings));
        for (std::size_t k = 0; k < water.size(); ++k) {
            const Lattice& lattice = lattices.back()[k];
            add_outside(places_in(lattice, wanted), solids, dp, water[k].max.z(), fluid);
            volume += lattice.volume(), cells += lattice.cells();
        }
    }
    if (cells > 0) fluid.volume = volume / cells;
    for (std::size_t k = 0; k < waters.size(); ++k)
        even_out_seams({s.dimensions, dp, fluid.volume, s.h_over_dp * dp}, waters[k], lattices[k], solids, zone, fluid);
    return fluid;
}

}  // namespace

std::vector<std::vector<Box>> waters_of(const SimulationSetup& s, std::span<const Box> blocks) {
    return disjoint_groups(blocks, s.dimensions, 0.5 * s.dp);
}

Fluid fill_with_fluid(const SimulationSetup& s, const std::vector<Box>& blocks) {
    return fill(s, s.dp, 0, queries_of(s), waters_of(s, blocks), everywhere);
}

std::vector<Fluid> fill_levels(const SimulationSetup& setup, const std::vector<Box>& blocks) {
    const std::vector<SurfaceQuery> solids = queries_of(setup);
    const std::vector<std::vector<Box>> waters = waters_of(setup, blocks);
    std::vector<Fluid> levels;
    for (std::size_t k = 0; k <= setup.zones.size(); ++k) {
        const double dp = std::ldexp(setup.dp, static_cast<int>(setup.zones.size() - k));
        const auto has_daughters = [&](const Vec3& parent) {
            return k == 0 || Refinement::belongs(setup.zones[k - 1], parent, dp);
        };
        const Zone* zone = k == 0 ? nullptr : &setup.zones[k - 1];
        levels.push_back(fill(setup, dp, static_cast<int>(k), solids, waters, has_daughters, zone));
    }
    return levels;
}

Fluid fill_with_air(const SimulationSetup& s, const std::vector<Box>& water) {
    Box all = s.domain;
    if (s.stream) {
        all.min.x() -= s.stream->buffer;
        all.max.x() += s.stream->buffer;
    }
    double surface = -1e30;
    for (const Box& block : water) surface = std::max(surface, block.max.z());
    const Lattice lattice(s.dimensions, s.dp, all);
    std::vector<Vec3> places = places_in(lattice, everywhere);
    const double clear = 0.25 * s.dp;
    std::erase_if(places, [&](const Vec3& x) {
        const auto in_water = [&](const Box& box) {
            for (int a = 0; a < 3; ++a)
                if ((a != 1 || s.dimensions == 3) && (x[a] < box.min[a] - clear || x[a] > box.max[a] + clear))
                    return false;
            return true;
        };
        return std::ranges::any_of(water, in_water);
    });
    Fluid out;
    out.volume = lattice.cell.prod();
    add_outside(places, queries_of(s), s.dp, surface, out);
    return out;
}

}  // namespace tw
