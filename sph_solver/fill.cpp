#include <algorithm>
#include <cmath>

#include "sph_solver/simulation.h"

namespace tw {
namespace {

/// Places of spacing dp in a block, half a spacing off its faces.
std::vector<Vec3> lattice(const SimulationSetup& s, const Box& block) {
    const double dp = s.dp;
    const auto count = [&](int a) { return static_cast<long>(std::llround(block.size()[a] / dp)); };
    const long nx = count(0), ny = s.dimensions == 3 ? count(1) : 1, nz = count(2);
    std::vector<Vec3> places;
    for (long k = 0; k < nz; ++k)
        for (long j = 0; j < ny; ++j)
            for (long i = 0; i < nx; ++i)
                places.emplace_back(block.min.x() + (double(i) + 0.5) * dp,
                                    s.dimensions == 3 ? block.min.y() + (double(j) + 0.5) * dp : 0.0,
                                    block.min.z() + (double(k) + 0.5) * dp);
    return places;
}

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

bool in_block(const Box& block, const Vec3& x, int dimensions) {
    for (int a = 0; a < 3; ++a)
        if ((a != 1 || dimensions == 3) && (x[a] < block.min[a] || x[a] > block.max[a])) return false;
    return true;
}

std::vector<SurfaceQuery> queries_of(const SimulationSetup& s) {
    std::vector<SurfaceQuery> queries;
    for (const BodySetup& body : s.bodies) queries.emplace_back(body.surface);
    return queries;
}

}  // namespace

Fluid fill_with_fluid(const SimulationSetup& s, const std::vector<Box>& blocks) {
    const std::vector<SurfaceQuery> solids = queries_of(s);
    Fluid out;
    for (const Box& block : blocks) add_outside(lattice(s, block), solids, s.dp, block.max.z(), out);
    return out;
}

std::vector<Fluid> fill_levels(const SimulationSetup& setup, const std::vector<Box>& blocks) {
    std::vector<Fluid> levels;
    for (std::size_t k = 0; k <= setup.zones.size(); ++k) {
        SimulationSetup level = setup;
        level.dp = std::ldexp(setup.dp, static_cast<int>(setup.zones.size() - k));
        Fluid& fluid = levels.emplace_back(fill_with_fluid(level, blocks));
        if (k == 0) continue;
        // the parent's place: the lattice of twice the spacing in the same block
        const auto parent = [&](const Vec3& x) {
            for (const Box& block : blocks) {
                if (!in_block(block, x, setup.dimensions)) continue;
                Vec3 of = block.min.array() +
                          2 * level.dp * (((x - block.min) / (2 * level.dp)).array().floor() + 0.5);
                if (setup.dimensions == 2) of.y() = 0;
                return of;
            }
            return x;
        };
        Fluid kept;
        for (std::size_t i = 0; i < fluid.places.size(); ++i)
            if (Refinement::belongs(setup.zones[k - 1], parent(fluid.places[i]), level.dp)) {
                kept.places.push_back(fluid.places[i]);
                kept.depth.push_back(fluid.depth[i]);
            }
        fluid = std::move(kept);
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
    std::vector<Box> taken;  // as far as the blocks' own lattices go
    for (const Box& block : water) {
        surface = std::max(surface, block.max.z());
        Box& box = taken.emplace_back(block);
        for (int a = 0; a < 3; ++a) box.max[a] = box.min[a] + s.dp * double(std::llround(block.size()[a] / s.dp));
    }
    std::vector<Vec3> places = lattice(s, all);
    const double clear = 0.25 * s.dp;  // places are half a spacing inside their box
    std::erase_if(places, [&](const Vec3& x) {
        const auto inside = [&](const Box& box, double margin) {
            for (int a = 0; a < 3; ++a)
                if ((a != 1 || s.dimensions == 3) && (x[a] < box.min[a] - margin || x[a] > box.max[a] + margin))
                    return false;
            return true;
        };
        return !inside(all, -clear) || std::ranges::any_of(taken, [&](const Box& box) { return inside(box, clear); });
    });
    Fluid out;
    add_outside(places, queries_of(s), s.dp, surface, out);
    return out;
}

}  // namespace tw
