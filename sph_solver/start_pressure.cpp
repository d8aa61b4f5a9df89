#include "sph_solver/start_pressure.h"

#include <algorithm>
#include <cmath>
#include <Eigen/IterativeLinearSolvers>
#include <utility>
#include <vector>

#include "scene/water/water_grid.h"
#include "sph_solver/lattice_multigrid.h"

namespace tw {
namespace {

using Cell = WaterGrid::Cell;
using Face = WaterGrid::Face;

/// Force by mass on water at rest in the tank's axes at the start, in two parts: f = even + turning (x - pivot).
struct ForceAtStart {
    Vec3 even;
    Eigen::Matrix3d turning = Eigen::Matrix3d::Zero();
    Vec3 pivot = Vec3::Zero();

    explicit ForceAtStart(const SimulationSetup& s) : even(s.gravity) {
        if (!s.frame) return;
        const FrameForce f = s.frame->force(0, s.gravity);
        even = f.at_pivot, turning = f.gradient, pivot = f.pivot;
    }
    bool is_weight() const { return even.x() == 0 && even.y() == 0 && even.z() < 0 && turning.isZero(0); }
};

/// The problem for one connected part of the water, by finite volumes, for phi = p / rho - even . x, so that water at
/// rest has the same phi everywhere whatever its cells are:
///
///   sum_faces A ((phi_j - phi_i) / d_ij - turning (x_f - pivot) . n) = 0,   phi = -even . x_f on a free face
class PartOfWater {
public:
    PartOfWater(const WaterGrid& grid, std::int32_t part, const ForceAtStart& force)
        : grid_(grid), force_(force), row_(grid.cells().size(), -1) {
        const std::vector<Cell>& cells = grid.cells();
        for (std::size_t c = 0; c < cells.size(); ++c)
            if (cells[c].part == part) row_[c] = static_cast<std::int32_t>(who_.size()), who_.push_back(c);
        solve();
    }
    int iterations() const { return iterations_; }

    /// p / rho at a place that belongs to a cell, linear along each axis from its middle towards the place [m2/s2].
    double pressure(std::int32_t of_cell, const Vec3& place) const {
        const Cell& c = grid_.cells()[std::size_t(of_cell)];
        const double own = phi(of_cell);
        const Vec3 middle = grid_.middle(c);
        double value = own;
        for (int a = 0; a < 3; ++a) {
            const double off = place[a] - middle[a];
            const std::size_t side = off > 0 ? 1 : 0;
            const std::size_t axis = std::size_t(a);
            if (c.face[axis][side] == Face::wall || off == 0) continue;
            const std::int32_t beside = c.beside[axis][side];
            const Vec3 face = grid_.face(c, a, int(side));
            const double there = beside >= 0 ? phi(beside) : -force_.even.dot(face),
                         far = beside >= 0 ? grid_.middle(grid_.cells()[std::size_t(beside)])[a] : face[a];
            value += (there - own) * off / (far - middle[a]);
        }
        return value + force_.even.dot(place);
    }

private:
    double phi(std::int32_t cell) const { return phi_[row_[std::size_t(cell)]]; }

    /// The matrix is written row by row, each with its columns in ascending order: a list of all entries would take more
    /// memory than the matrix.
    void solve() {
        const auto n = static_cast<std::int32_t>(who_.size());
        LatticeMultigrid::Matrix laplace(n, n);
        laplace.reserve(7 * std::ptrdiff_t{n});
        std::vector<std::pair<std::int32_t, double>> row;
        Eigen::VectorXd given = Eigen::VectorXd::Zero(n);
        double highest = -1e300;
        for (std::int32_t i = 0; i < n; ++i) {
            const Cell& c = grid_.cells()[who_[std::size_t(i)]];
            const Vec3 size = grid_.size(c);
            double diagonal = 0;
            row.clear();
            for (int a = 0; a < 3; ++a)
                for (std::size_t side = 0; side < 2; ++side) {
                    const Face kind = c.face[std::size_t(a)][side];
                    if (kind == Face::wall) continue;
                    const double area = size.prod() / size[a], outwards = side == 0 ? -1 : 1;
                    const Vec3 face = grid_.face(c, a, int(side));
                    double distance = size[a] / 2;
                    if (kind == Face::open) {
                        const std::int32_t beside = c.beside[std::size_t(a)][side];
                        distance += grid_.size(grid_.cells()[std::size_t(beside)])[a] / 2;
                        row.emplace_back(row_[std::size_t(beside)], -area / distance);
                    } else {
                        const double there = -force_.even.dot(face);
                        given[i] += area / distance * there;
                        highest = std::max(highest, there);
                    }
                    diagonal += area / distance;
                    given[i] -= area * outwards * (force_.turning * (face - force_.pivot))[a];
                }
            row.emplace_back(i, diagonal);
            std::ranges::sort(row);
            laplace.startVec(i);
            for (const auto& [column, value] : row) laplace.insertBack(i, column) = value;
        }
        laplace.finalize();
        std::vector<LatticeMultigrid::Place> places;
        for (const std::size_t c : who_) places.push_back(grid_.cells()[c].at);
        Eigen::ConjugateGradient<decltype(laplace), Eigen::Lower | Eigen::Upper, LatticeMultigrid> solver;
        solver.preconditioner().take(laplace, std::move(places));
        solver.compute(laplace);
        solver.setTolerance(1e-7);
        phi_ = solver.solveWithGuess(given, Eigen::VectorXd::Constant(n, highest));
        iterations_ = std::max(1, static_cast<int>(solver.iterations()));
    }

    const WaterGrid& grid_;
    const ForceAtStart& force_;
    std::vector<std::size_t> who_;   ///< cells
    std::vector<std::int32_t> row_;  ///< of each cell; -1: of another part
    Eigen::VectorXd phi_;
    int iterations_ = 0;
};

bool is_within(const Box& box, const Vec3& x, double more, int dimensions) {
    for (int a = 0; a < 3; ++a)
        if ((a != 1 || dimensions == 3) && (x[a] < box.min[a] - more || x[a] > box.max[a] + more)) return false;
    return true;
}

/// A lone block between walls all round: what is in it is at rest below its top, whatever solids there are.
bool stands_between_walls(const SimulationSetup& s, const Box& block, double clear) {
    for (int a = 0; a < 3; ++a) {
        if (a == 1 && s.dimensions == 2) continue;
        const auto& walls = s.mirrors.on[std::size_t(a)];
        if (!walls[0] || block.min[a] - s.domain.min[a] > clear) return false;
        if (a != 2 && (!walls[1] || s.domain.max[a] - block.max[a] > clear)) return false;
    }
    return true;
}

}  // namespace

int find_start_pressure(const SimulationSetup& s, std::span<const Box> blocks, std::span<Fluid> fluids) {
    const double g = -s.gravity.z();
    const auto& periodic = s.mirrors.periodic;
    const ForceAtStart force(s);
    if (s.stream || !(g > 0) || s.at_rest || periodic[0] || periodic[1] || periodic[2]) return 0;

    const double clear = 0.5 * s.dp, weight = force.even.z() / -g;
    std::vector<SurfaceQuery> solids;
    for (const BodySetup& body : s.bodies) solids.emplace_back(body.surface);
    const WaterBounds bounds{s.dimensions, s.domain, s.mirrors.on, solids, clear};
    std::size_t particles = 0;
    for (const Fluid& fluid : fluids) particles += fluid.places.size();
    int iterations = 0;
    for (const std::vector<Box>& group : waters_of(s, blocks)) {
        if (group.size() == 1 && force.is_weight() && weight == 1 && stands_between_walls(s, group.front(), clear))
            continue;
        const WaterGrid grid(group, bounds, s.dp, std::max(1e5, 4.0 * double(particles)));
        std::vector<std::optional<PartOfWater>> solved(grid.parts().size());
        for (std::size_t p = 0; p < solved.size(); ++p) {
            const WaterGrid::Part& part = grid.parts()[p];
            if (!part.is_free || (part.at_rest() && force.is_weight())) continue;
            solved[p].emplace(grid, static_cast<std::int32_t>(p), force);
            iterations += solved[p]->iterations();
        }
        for (Fluid& fluid : fluids)
            for (std::size_t i = 0; i < fluid.places.size(); ++i) {
                const Vec3& x = fluid.places[i];
                if (std::ranges::none_of(group, [&](const Box& b) { return is_within(b, x, clear, s.dimensions); }))
                    continue;
                const std::int32_t cell = grid.cell_near(x);
                if (cell < 0) continue;
                const auto p = static_cast<std::size_t>(grid.cells()[std::size_t(cell)].part);
                fluid.depth[i] =
                    solved[p] ? solved[p]->pressure(cell, x) / g : weight * (grid.parts()[p].level - x.z());
            }
    }
    return iterations;
}

}  // namespace tw
