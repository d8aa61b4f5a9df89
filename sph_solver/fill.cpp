#include <algorithm>
#include <cmath>

#include "sph_solver/solver.h"

namespace tw {

Fluid fill_with_fluid(const SolverSetup& s, const std::vector<Box>& blocks) {
    const double dp = s.dp;
    std::vector<SurfaceQuery> queries;
    for (const Surface& surface : s.solids) queries.emplace_back(surface);
    Fluid out;
    for (const Box& block : blocks) {
        const auto count = [&](int a) { return static_cast<long>(std::llround(block.size()[a] / dp)); };
        const long nx = count(0), ny = s.dimensions == 3 ? count(1) : 1, nz = count(2);
        std::vector<Vec3> lattice;
        for (long k = 0; k < nz; ++k)
            for (long j = 0; j < ny; ++j)
                for (long i = 0; i < nx; ++i)
                    lattice.emplace_back(block.min.x() + (double(i) + 0.5) * dp,
                                         s.dimensions == 3 ? block.min.y() + (double(j) + 0.5) * dp : 0.0,
                                         block.min.z() + (double(k) + 0.5) * dp);
        std::vector<double> distance(lattice.size(), 1e30), d(lattice.size());
        for (const SurfaceQuery& q : queries) {
            q.signed_distances(lattice, d, 2 * dp);
            for (std::size_t k = 0; k < d.size(); ++k) distance[k] = std::min(distance[k], d[k]);
        }
        for (std::size_t k = 0; k < lattice.size(); ++k)
            if (distance[k] > 0) {
                out.places.push_back(lattice[k]);
                out.depth.push_back(block.max.z() - lattice[k].z());
            }
    }
    return out;
}

}  // namespace tw
