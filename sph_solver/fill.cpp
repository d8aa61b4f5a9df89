#include <algorithm>
#include <cmath>

#include "sph_solver/simulation.h"

namespace tw {
namespace {

/// Places of spacing dp in a block, half a spacing off its faces, of those cells of twice the spacing that are
/// `wanted(middle of the cell)`.
template <class Wanted>
std::vector<Vec3> lattice(const SimulationSetup& s, const Box& block, const Wanted& wanted) {
    const double dp = s.dp;
    const auto count = [&](int a) { return static_cast<long>(std::llround(block.size()[a] / dp)); };
    const long nx = count(0), ny = s.dimensions == 3 ? count(1) : 1, nz = count(2);
    const auto place = [&](double i, double j, double k) {
        return Vec3(block.min.x() + i * dp, s.dimensions == 3 ? block.min.y() + j * dp : 0.0, block.min.z() + k * dp);
    };
    std::vector<Vec3> places;
    for (long k = 0; k < nz; ++k)
        for (long j = 0; j < ny; ++j)
            for (long i = 0; i < nx; i += 2) {
                if (!wanted(place(double(i + 1), double(j - j % 2 + 1), double(k - k % 2 + 1)))) continue;
                for (long n = i; n < std::min(i + 2, nx); ++n)
                    places.push_back(place(double(n) + 0.5, double(j) + 0.5, double(k) + 0.5));
            }
    return places;
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

}  // namespace

Fluid fill_with_fluid(const SimulationSetup& s, const std::vector<Box>& blocks) {
    const std::vector<SurfaceQuery> solids = queries_of(s);
    Fluid out;
    for (const Box& block : blocks) add_outside(lattice(s, block, everywhere), solids, s.dp, block.max.z(), out);
    return out;
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
        for (const Box& block : blocks)
            add_outside(lattice(level, block, has_children), solids, level.dp, block.max.z(), fluid);
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
    std::vector<Vec3> places = lattice(s, all, everywhere);
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
