#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sph_solver/simulation.h"

namespace tw {
namespace {

/// How a block is divided into cells of about dp, of which each holds a particle: the next whole number of coarsest
/// cells along each edge, each halved `halvings` times. The cells fill the block, so that water has the volume, the
/// depth and the distance from its walls that the scene gives it at every size of particles.
struct Lattice {
    Vec3 corner, cell;          ///< low corner of the block, edges of a cell [m]; the span is 1 in two dimensions
    std::array<long, 3> count;  ///< cells along each edge

    Lattice(const SimulationSetup& s, const Box& block, int halvings) : corner(block.min) {
        const double coarsest = std::ldexp(s.dp, halvings);
        for (int a = 0; a < 3; ++a) {
            const bool across = a == 1 && s.dimensions == 2;
            const long coarse = across ? 1 : static_cast<long>(std::llround(block.size()[a] / coarsest));
            count[static_cast<std::size_t>(a)] = across ? 1 : coarse << halvings;
            cell[a] = across ? 1 : block.size()[a] / static_cast<double>(std::max(1L, coarse << halvings));
        }
        if (s.dimensions == 2) corner.y() = -0.5;  // particles stand in the plane y = 0
    }
    double cells() const { return static_cast<double>(count[0] * count[1] * count[2]); }
    double volume() const { return cell.prod() * cells(); }

    /// Middles of the cells of those families of two cells along each edge that are `wanted(middle of the family)`.
    template <class Wanted>
    std::vector<Vec3> places(int dimensions, const Wanted& wanted) const {
        const auto place = [&](double i, double j, double k) -> Vec3 {
            return corner + Vec3(i, dimensions == 3 ? j : 0.5, k).cwiseProduct(cell);
        };
        std::vector<Vec3> all;
        const auto [nx, ny, nz] = count;
        for (long k = 0; k < nz; ++k)
            for (long j = 0; j < ny; ++j)
                for (long i = 0; i < nx; i += 2) {
                    if (!wanted(place(double(i + 1), double(j - j % 2 + 1), double(k - k % 2 + 1)))) continue;
                    for (long n = i; n < std::min(i + 2, nx); ++n)
                        all.push_back(place(double(n) + 0.5, double(j) + 0.5, double(k) + 0.5));
                }
        return all;
    }
};
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

}  // namespace

Fluid fill_with_fluid(const SimulationSetup& s, const std::vector<Box>& blocks) {
    SimulationSetup one_size = s;
    one_size.zones.clear();
    return std::move(fill_levels(one_size, blocks).front());
}

std::vector<Fluid> fill_levels(const SimulationSetup& setup, const std::vector<Box>& blocks) {
    const std::vector<SurfaceQuery> solids = queries_of(setup);
    std::vector<Fluid> levels;
    for (std::size_t k = 0; k <= setup.zones.size(); ++k) {
        SimulationSetup level = setup;
        level.dp = std::ldexp(setup.dp, static_cast<int>(setup.zones.size() - k));
        const auto has_children = [&](const Vec3& parent) {
            return k == 0 || Refinement::belongs(setup.zones[k - 1], parent, level.dp);
        };
        Fluid& fluid = levels.emplace_back();
        double volume = 0, cells = 0;  // all particles of a level have one mass: blocks share the mean
        for (const Box& block : blocks) {
            const Lattice lattice(level, block, static_cast<int>(k));
            add_outside(lattice.places(setup.dimensions, has_children), solids, level.dp, block.max.z(), fluid);
            volume += lattice.volume(), cells += lattice.cells();
        }
        if (cells > 0) fluid.volume = volume / cells;
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
    const Lattice lattice(s, all, 0);
    std::vector<Vec3> places = lattice.places(s.dimensions, everywhere);
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
