#include "sph_solver/release_pressure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "meshes/query.h"
#include "sph_solver/lattice.h"

namespace tw {
namespace {

using CellNumber = std::array<std::int32_t, 3>;

Lattice lattice_of(const SimulationSetup& s, const Box& block) { return {s.dimensions, s.dp, block}; }

/// The particles by their places in one lattice.
class ParticlesByPlace {
public:
    ParticlesByPlace(const Lattice& lattice, const Fluid& fluid) : lattice_(lattice) {
        low_.fill(0), size_.fill(0);
        std::vector<CellNumber> cells;
        CellNumber high{};
        for (const Vec3& x : fluid.places) {
            const CellNumber& c = cells.emplace_back(cell_of(x));
            for (std::size_t a = 0; a < 3; ++a) low_[a] = std::min(low_[a], c[a]), high[a] = std::max(high[a], c[a]);
        }
        for (std::size_t a = 0; a < 3; ++a) size_[a] = high[a] - low_[a] + 1;
        particle_.assign(std::size_t(size_[0]) * std::size_t(size_[1]) * std::size_t(size_[2]), -1);
        for (std::size_t i = 0; i < cells.size(); ++i) particle_[index(cells[i])] = static_cast<std::int32_t>(i);
    }
    /// The particle one spacing from `x` along an axis; -1: there is none.
    std::int32_t beside(const Vec3& x, std::size_t axis, int step) const {
        CellNumber c = cell_of(x);
        c[axis] += step;
        const bool within = c[axis] >= low_[axis] && c[axis] < low_[axis] + size_[axis];
        return within ? particle_[index(c)] : -1;
    }

private:
    CellNumber cell_of(const Vec3& x) const {
        CellNumber c;
        const Vec3 cells = (x - lattice_.corner).cwiseQuotient(lattice_.cell);
        for (int a = 0; a < 3; ++a) c[static_cast<std::size_t>(a)] = static_cast<std::int32_t>(std::floor(cells[a]));
        return c;
    }
    std::size_t index(const CellNumber& c) const {
        std::size_t k = 0;
        for (std::size_t a = 0; a < 3; ++a) k = k * std::size_t(size_[a]) + std::size_t(c[a] - low_[a]);
        return k;
    }
    Lattice lattice_;
    CellNumber low_, size_;
    std::vector<std::int32_t> particle_;
};

bool on_one_lattice(const SimulationSetup& s, std::span<const Box> blocks) {
    const Vec3 cell = lattice_of(s, blocks.front()).cell;
    return std::ranges::all_of(blocks, [&](const Box& b) {
        if ((lattice_of(s, b).cell - cell).norm() > 1e-6 * s.dp) return false;
        for (int a = 0; a < 3; ++a) {
            if (a == 1 && s.dimensions == 2) continue;
            const double apart = (b.min[a] - blocks.front().min[a]) / cell[a];
            if (std::abs(apart - std::round(apart)) > 1e-6) return false;
        }
        return true;
    });
}

/// A side of a particle's cell on which no particle stands.
struct BareFace {
    std::int32_t particle;
    Vec3 away;  ///< to the middle of the next cell
};

/// Those of the faces that are free, the others being at walls.
std::vector<char> free_faces(const SimulationSetup& s, const Fluid& fluid, std::span<const BareFace> faces) {
    std::vector<Vec3> beyond;
    for (const BareFace& f : faces) beyond.push_back(fluid.places[std::size_t(f.particle)] + f.away);
    std::vector<char> is_free(faces.size(), 1);
    for (std::size_t k = 0; k < faces.size(); ++k)
        for (int a = 0; a < 3; ++a) {
            const auto& mirror = s.mirrors.on[std::size_t(a)];
            if ((mirror[0] && beyond[k][a] < s.domain.min[a]) || (mirror[1] && beyond[k][a] > s.domain.max[a]))
                is_free[k] = 0;
        }
    std::vector<double> distance(faces.size());
    for (const BodySetup& body : s.bodies) {
        SurfaceQuery(body.surface).signed_distances(beyond, distance, 2 * s.dp);
        for (std::size_t k = 0; k < faces.size(); ++k)
            if (distance[k] <= 0) is_free[k] = 0;
    }
    return is_free;
}

}  // namespace

int find_release_pressure(const SimulationSetup& s, std::span<const Box> blocks, Fluid& fluid) {
    const double g = -s.gravity.z();
    const auto& periodic = s.mirrors.periodic;
    if (!s.zones.empty() || s.stream || s.frame || !(g > 0) || periodic[0] || periodic[1] || periodic[2] ||
        fluid.places.empty() || !on_one_lattice(s, blocks))
        return 0;

    const Lattice lattice = lattice_of(s, blocks.front());
    const Vec3 cell = lattice.cell;
    const ParticlesByPlace particles(lattice, fluid);
    const auto n = static_cast<std::int32_t>(fluid.places.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n), given = Eigen::VectorXd::Zero(n);
    std::vector<BareFace> faces;
    for (std::int32_t i = 0; i < n; ++i)
        for (int a = 0; a < 3; ++a)
            for (const int step : {-1, 1}) {
                if (a == 1 && s.dimensions == 2) continue;
                const double weight = s.dp * s.dp / (cell[a] * cell[a]);
                const Vec3& x = fluid.places[std::size_t(i)];
                if (const std::int32_t j = particles.beside(x, std::size_t(a), step); j >= 0)
                    entries.emplace_back(i, j, -weight), diagonal[i] += weight;
                else
                    faces.push_back({i, step * cell[a] * Vec3::Unit(a)});
            }
    const std::vector<char> is_free = free_faces(s, fluid, faces);
    bool let_go = false;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const BareFace& f = faces[k];
        const double weight = s.dp * s.dp / f.away.squaredNorm();
        if (is_free[k])  // p = 0 half a cell away
            diagonal[f.particle] += 2 * weight, let_go = let_go || !(f.away.z() > 0);
        else  // the wall bears what stands on it
            given[f.particle] -= weight * f.away.z();
    }
    if (!let_go) return 0;
    for (std::int32_t i = 0; i < n; ++i) entries.emplace_back(i, i, diagonal[i]);

    Eigen::SparseMatrix<double, Eigen::RowMajor> laplace(n, n);
    laplace.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<decltype(laplace), Eigen::Lower | Eigen::Upper> solver(laplace);
    solver.setTolerance(1e-6);
    const Eigen::Map<Eigen::VectorXd> depth(fluid.depth.data(), n);
    const Eigen::VectorXd found = solver.solveWithGuess(given, depth);
    if (solver.info() != Eigen::Success) return 0;
    std::copy(found.begin(), found.end(), fluid.depth.begin());
    return std::max(1, static_cast<int>(solver.iterations()));
}

}  // namespace tw
