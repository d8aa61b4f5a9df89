#include "sph_solver/fit_solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "meshes/query.h"
#include "sph_solver/bodies/cut_cell.h"
#include "sph_solver/even_packing.h"
#include "sph_solver/lattice.h"

namespace tw {
namespace {

constexpr double moved_over_dp = 4;     ///< particles this near to a solid move
constexpr double clear_over_dp = 0.25;  ///< from the solid, at least

using LatticeCell = std::array<long, 3>;

LatticeCell beside(const LatticeCell& c, int i, int j, int k) { return {c[0] + i, c[1] + j, c[2] + k}; }

/// The particles of one level in one block of water, by cells of its lattice.
class LatticeCells {
public:
    LatticeCells(const Lattice& lattice, const Zone* zone, Fluid& fluid)
        : lattice_(lattice), zone_(zone), fluid_(fluid) {
        for (std::size_t i = 0; i < fluid.places.size(); ++i)
            if (const std::optional<LatticeCell> c = cell_of(fluid.places[i])) particle_[*c] = i;
    }
    /// Calls `act(cell)` for the cells near a solid, in the order of their places.
    template <class Act>
    void each_near(const Box& solid, const Act& act) const {
        LatticeCell low, high;
        for (std::size_t a = 0; a < 3; ++a) {
            const auto b = static_cast<int>(a);
            const auto at = [&](double x) { return std::floor((x - lattice_.corner[b]) / lattice_.cell[b]); };
            const double most = double(lattice_.count[a] - 1);
            low[a] = long(std::clamp(at(solid.min[b]) - 1, 0.0, most + 1));
            high[a] = long(std::clamp(at(solid.max[b]) + 1, -1.0, most));
            if (a == 1 && lattice_.flat) low[a] = high[a] = 0;
        }
        for (long k = low[2]; k <= high[2]; ++k)
            for (long j = low[1]; j <= high[1]; ++j)
                for (long i = low[0]; i <= high[0]; ++i)
                    if (const LatticeCell c{i, j, k}; !zone_ || zone_->outside(middle(c)) < 0) act(c);
    }
    Vec3 middle(const LatticeCell& c) const {
        return lattice_.place(double(c[0]) + 0.5, double(c[1]) + 0.5, double(c[2]) + 0.5);
    }
    const Vec3& edges() const { return lattice_.cell; }
    bool flat() const { return lattice_.flat; }

    /// Fills a cell with a particle at `x`, which may be there already.
    void fill(const LatticeCell& c, const Vec3& x) {
        if (const auto found = particle_.find(c); found != particle_.end()) return move(found->second, x);
        for (int k = -1; k <= 1; ++k)  // as deep as the nearest of those beside it says
            for (int j = flat() ? 0 : -1; j <= (flat() ? 0 : 1); ++j)
                for (int i = -1; i <= 1; ++i)
                    if (const auto near = particle_.find(beside(c, i, j, k)); near != particle_.end()) {
                        const std::size_t of = near->second;
                        fluid_.depth.push_back(fluid_.depth[of] + fluid_.places[of].z() - x.z());
                        fluid_.places.push_back(x);
                        particle_[c] = fluid_.places.size() - 1;
                        return;
                    }
    }
    /// Those to be taken out are given a depth that is none.
    void empty(const LatticeCell& c) {
        const auto found = particle_.find(c);
        if (found == particle_.end()) return;
        fluid_.depth[found->second] = std::numeric_limits<double>::quiet_NaN();
        particle_.erase(found);
    }

private:
    void move(std::size_t i, const Vec3& x) {
        fluid_.depth[i] += fluid_.places[i].z() - x.z();
        fluid_.places[i] = x;
    }
    std::optional<LatticeCell> cell_of(const Vec3& x) const {
        LatticeCell c;
        for (std::size_t a = 0; a < 3; ++a) {
            const auto b = static_cast<int>(a);
            c[a] = static_cast<long>(std::floor((x[b] - lattice_.corner[b]) / lattice_.cell[b]));
            if (c[a] < 0 || c[a] >= lattice_.count[a]) return {};
        }
        return c;
    }
    const Lattice& lattice_;
    const Zone* zone_;
    Fluid& fluid_;
    std::map<LatticeCell, std::size_t> particle_;
};

/// Fills the cells that solids cut as the water outside all of them asks for, and marks the solids that cut any. What
/// is cut by two counts once, and what of a solid's face is inside another one is no face.
void fill_cut_cells(LatticeCells& cells, std::span<const SurfaceQuery> solids, std::span<const BodySetup> bodies,
                    double dp, std::vector<char>& cuts) {
    const Vec3 edges = cells.edges();
    const double reach = cells.flat() ? std::hypot(edges.x(), edges.z()) : edges.norm(), clear = clear_over_dp * dp;
    const auto in_water = [&](const Vec3& x) {
        return std::ranges::all_of(solids, [&](const SurfaceQuery& q) { return q.nearest(x, 2 * reach).distance > 0; });
    };
    std::map<LatticeCell, CutCell> cut;
    std::map<LatticeCell, double> share;
    for (std::size_t b = 0; b < solids.size(); ++b)
        cells.each_near(bodies[b].surface.bounds(), [&](const LatticeCell& c) {
            const Vec3 middle = cells.middle(c);
            if (solids[b].nearest(middle, reach).triangle < 0) return;
            const CutCell water = cut_cell(middle, edges, cells.flat(), in_water);
            if (water.within == 0 || water.within == water.samples) return;
            cut[c] = water, share[c] = water.of(1), cuts[b] = 1;
        });
    for (const auto& [c, water] : cut) {
        const bool filled = share[c] >= 0.5;
        const double left = share[c] - (filled ? 1 : 0);
        if (filled) {
            Vec3 x = water.centroid;
            for (const SurfaceQuery& solid : solids)
                if (const SurfaceQuery::Nearest at = solid.nearest(x, reach); at.distance < clear)
                    x += (clear - at.distance) * at.normal;
            cells.fill(c, x);
        } else {
            cells.empty(c);
        }
        std::vector<LatticeCell> next;
        for (int k = -1; k <= 1; ++k)
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    if (const LatticeCell d = beside(c, i, j, k); c < d && cut.contains(d)) next.push_back(d);
        for (const LatticeCell& d : next) share[d] += left / double(next.size());
    }
}

void take_out(Fluid& fluid) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < fluid.places.size(); ++i)
        if (!std::isnan(fluid.depth[i])) {
            fluid.places[kept] = fluid.places[i];
            fluid.depth[kept++] = fluid.depth[i];
        }
    fluid.places.resize(kept);
    fluid.depth.resize(kept);
}

void even_out_near(const SimulationSetup& s, std::span<const Box> blocks, std::span<const SurfaceQuery* const> unfit,
                   std::span<const SurfaceQuery> solids, const Zone* zone, double dp, Fluid& fluid) {
    const bool flat = s.dimensions == 2;
    std::vector<char> moves(fluid.places.size(), 0);
    std::vector<double> distance(moves.size());
    for (const SurfaceQuery* solid : unfit) {
        solid->signed_distances(fluid.places, distance, moved_over_dp * dp);
        for (std::size_t i = 0; i < moves.size(); ++i)
            if (distance[i] < moved_over_dp * dp && (!zone || zone->outside(fluid.places[i]) < 0)) moves[i] = 1;
    }
    const std::vector<Vec3> before = fluid.places;
    even_out(fluid.places, moves, {s.dimensions, dp, fluid.volume, s.h_over_dp * dp},
             water_in(blocks, solids, s.dimensions));
    for (std::size_t i = 0; i < moves.size(); ++i) {
        if (!moves[i]) continue;
        Vec3& x = fluid.places[i];
        for (const SurfaceQuery& solid : solids)
            if (const SurfaceQuery::Nearest at = solid.nearest(x, dp); at.distance < clear_over_dp * dp)
                x += (clear_over_dp * dp - at.distance) * at.normal;
        if (flat) x.y() = before[i].y();
        fluid.depth[i] += before[i].z() - x.z();
    }
}

}  // namespace

void fit_to_solids(const SimulationSetup& s, std::span<const Box> blocks, std::span<Fluid> levels) {
    if (s.stream || s.bodies.empty()) return;
    std::vector<SurfaceQuery> solids;
    for (const BodySetup& body : s.bodies) solids.emplace_back(body.surface);
    const std::vector<std::vector<Box>> waters = waters_of(s, blocks);
    std::vector<Box> boxes;
    for (const std::vector<Box>& water : waters) boxes.insert(boxes.end(), water.begin(), water.end());
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const double dp = std::ldexp(s.dp, static_cast<int>(s.zones.size() - k));
        const Zone* const zone = k > 0 ? &s.zones[k - 1] : nullptr;
        std::vector<char> unfit(solids.size(), 0);
        for (const std::vector<Box>& water : waters)
            for (const Lattice& lattice : lattices_of(s.dimensions, dp, water, static_cast<int>(k))) {
                LatticeCells cells(lattice, zone, levels[k]);
                fill_cut_cells(cells, solids, s.bodies, dp, unfit);
                take_out(levels[k]);
            }
        std::vector<const SurfaceQuery*> of;
        for (std::size_t b = 0; b < solids.size(); ++b)
            if (unfit[b]) of.push_back(&solids[b]);
        if (!of.empty()) even_out_near(s, boxes, of, solids, zone, dp, levels[k]);
    }
}

}  // namespace tw
