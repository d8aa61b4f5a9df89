#include "sph_solver/lattice_multigrid.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tw {
namespace {

constexpr double damping = 0.8, stretch = 1.5;

/// Gives each cell its parent, and of the places those of the parents.
std::vector<std::int32_t> join_cells(std::vector<LatticeMultigrid::Place>& places) {
    for (LatticeMultigrid::Place& place : places)
        for (std::int32_t& along : place) along /= 2;
    std::vector<LatticeMultigrid::Place> parents = places;
    std::ranges::sort(parents);
    parents.erase(std::ranges::unique(parents).begin(), parents.end());
    std::vector<std::int32_t> parent;
    parent.reserve(places.size());
    for (const LatticeMultigrid::Place& place : places)
        parent.push_back(static_cast<std::int32_t>(std::ranges::lower_bound(parents, place) - parents.begin()));
    places = std::move(parents);
    return parent;
}

/// P^T A P, row by row: a list of all entries would take more memory than the matrix.
LatticeMultigrid::Matrix matrix_of_parents(const LatticeMultigrid::Matrix& cells,
                                           const std::vector<std::int32_t>& parent, std::size_t parents) {
    std::vector<std::int32_t> order(parent.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::int32_t i) { return parent[std::size_t(i)]; });
    const auto n = static_cast<std::int32_t>(parents);
    LatticeMultigrid::Matrix sum(n, n);
    std::vector<std::pair<std::int32_t, double>> row;
    auto child = order.begin();
    for (std::int32_t own = 0; own < n; ++own) {
        row.clear();
        for (; child != order.end() && parent[std::size_t(*child)] == own; ++child)
            for (LatticeMultigrid::Matrix::InnerIterator at(cells, *child); at; ++at)
                row.emplace_back(parent[std::size_t(at.col())], at.value());
        std::ranges::sort(row);
        sum.startVec(own);
        for (std::size_t k = 0; k < row.size();) {
            auto [column, value] = row[k];
            for (++k; k < row.size() && row[k].first == column; ++k) value += row[k].second;
            sum.insertBack(own, column) = value;
        }
    }
    sum.finalize();
    return sum;
}

}  // namespace

void LatticeMultigrid::take(const Matrix& finest, std::vector<Place> places) {
    finest_ = &finest;
    lattices_.assign(1, {});
    for (std::size_t k = 0;; ++k) {
        lattices_[k].inverse = damping * matrix(k).diagonal().cwiseInverse();
        const std::size_t cells = places.size();
        std::vector<std::int32_t> parent = join_cells(places);
        if (places.size() == cells) return;
        lattices_.push_back({matrix_of_parents(matrix(k), parent, places.size()), {}, {}});
        lattices_[k].parent = std::move(parent);
    }
}

Eigen::VectorXd LatticeMultigrid::cycle(std::size_t k, const Eigen::VectorXd& r) const {
    const Lattice& lattice = lattices_[k];
    Eigen::VectorXd x = lattice.inverse.cwiseProduct(r);
    if (k + 1 < lattices_.size()) {
        const Eigen::VectorXd left = r - matrix(k) * x;
        Eigen::VectorXd of_parents = Eigen::VectorXd::Zero(lattices_[k + 1].inverse.size());
        for (Eigen::Index i = 0; i < left.size(); ++i) of_parents[lattice.parent[std::size_t(i)]] += left[i];
        const Eigen::VectorXd coarse = cycle(k + 1, of_parents);
        for (Eigen::Index i = 0; i < left.size(); ++i) x[i] += stretch * coarse[lattice.parent[std::size_t(i)]];
    }
    x += lattice.inverse.cwiseProduct(r - matrix(k) * x);
    return x;
}

}  // namespace tw
