#include "sph_solver/parallel/decomposition.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "sph_solver/backend/for_particles.h"

namespace tw {

namespace {

class Bisection {
public:
    Bisection(const PencilGrid& grid, std::span<const std::int64_t> work, std::vector<std::int32_t>& owner)
        : grid_(grid), work_(work), owner_(owner) {}

    /// Gives [first, last) to so many ranks from `rank` on.
    void divide(std::span<std::int32_t> pencils, int rank, int ranks) {
        if (ranks == 1) {
            for (const std::int32_t c : pencils) owner_[static_cast<std::size_t>(c)] = rank;
            return;
        }
        sort_along_longer_side(pencils);
        const int left = ranks / 2;
        const std::size_t cut = cut_at(pencils, left, ranks);
        divide(pencils.first(cut), rank, left);
        divide(pencils.subspan(cut), rank + left, ranks - left);
    }

private:
    std::array<int, 3> place(std::int32_t c) const {
        return {c % grid_.nx, c / grid_.nx % grid_.ny, c / grid_.nx / grid_.ny};
    }
    std::int64_t work(std::int32_t c) const { return work_[static_cast<std::size_t>(c)]; }

    void sort_along_longer_side(std::span<std::int32_t> pencils) const {
        std::array<int, 2> low{grid_.nx, grid_.ny}, high{-1, -1};
        for (const std::int32_t c : pencils) {
            if (work(c) == 0) continue;
            for (std::size_t a = 0; a < 2; ++a)
                low[a] = std::min(low[a], place(c)[a]), high[a] = std::max(high[a], place(c)[a]);
        }
        const bool along_y = high[1] - low[1] > high[0] - low[0];
        std::ranges::sort(pencils, {}, [&](std::int32_t c) {
            const auto [x, y, z] = place(c);
            return along_y ? std::array{y, x, z} : std::array{x, y, z};
        });
    }

    /// How many pencils go to the `left` of all the ranks: as near to their share of the work as whole pencils get, and
    /// on each side at least as many pencils with work as ranks, where there are so many.
    std::size_t cut_at(std::span<const std::int32_t> pencils, int left, int ranks) const {
        std::int64_t all = 0, busy = 0;
        for (const std::int32_t c : pencils) all += work(c), busy += work(c) > 0;
        std::int64_t before = 0, busy_before = 0;
        for (std::size_t k = 0; k < pencils.size(); ++k) {
            const std::int64_t with = before + work(pencils[k]);
            const bool beyond = (before + with) * ranks > 2 * all * left;
            const bool rest_needs_it = busy - busy_before <= ranks - left && work(pencils[k]) > 0;
            if ((beyond && busy_before >= left) || rest_needs_it) return k;
            before = with, busy_before += work(pencils[k]) > 0;
        }
        return pencils.size();
    }

    const PencilGrid& grid_;
    std::span<const std::int64_t> work_;
    std::vector<std::int32_t>& owner_;
};

/// An interval of places [fixed-point units].
struct Interval {
    std::int64_t low, high;
};

/// The images of an interval of one axis that the domain's faces `faces` make of what is within `reach` of them, and
/// itself.
std::vector<Interval> with_images(const Interval& of, const Mirrors& mirrors, std::size_t axis, const Interval& faces,
                                  std::int64_t reach) {
    std::vector<Interval> all{of};
    const bool near_low = of.low - faces.low <= reach, near_high = faces.high - of.high <= reach;
    if (mirrors.periodic[axis]) {
        const std::int64_t length = faces.high - faces.low;
        if (near_low) all.push_back({of.low + length, of.high + length});
        if (near_high) all.push_back({of.low - length, of.high - length});
        return all;
    }
    if (mirrors.on[axis][0] && near_low) all.push_back({2 * faces.low - of.high, 2 * faces.low - of.low});
    if (mirrors.on[axis][1] && near_high) all.push_back({2 * faces.high - of.high, 2 * faces.high - of.low});
    return all;
}

}  // namespace

Decomposition::Decomposition(const PencilGrid& grid, const PencilGrid& blocks, std::span<const std::int64_t> work,
                             int ranks)
    : owner_(static_cast<std::size_t>(grid.count())) {
    const auto block = [&](std::size_t pencil) {
        return static_cast<std::size_t>(blocks.of(grid.centre(static_cast<int>(pencil))));
    };
    std::vector<std::int32_t> all(static_cast<std::size_t>(blocks.count())), of_blocks(all.size());
    std::vector<std::int64_t> work_of_blocks(all.size());
    for (std::size_t c = 0; c < owner_.size(); ++c) work_of_blocks[block(c)] += work[c];
    std::iota(all.begin(), all.end(), 0);
    Bisection(blocks, work_of_blocks, of_blocks).divide(all, 0, ranks);
    for (std::size_t c = 0; c < owner_.size(); ++c) owner_[c] = of_blocks[block(c)];
}

void Decomposition::find_holders(const PencilGrid& grid, const Mirrors& mirrors, const WidePlace& low,
                                 const WidePlace& high, std::int64_t reach) {
    const auto count = static_cast<std::size_t>(grid.count());
    std::vector<std::vector<std::int32_t>> of(count);
    for_particles(count, [&](std::size_t c) {
        const auto pencil = static_cast<int>(c);
        const int cx = pencil % grid.nx, cy = pencil / grid.nx % grid.ny, cz = pencil / grid.nx / grid.ny;
        const Interval x{grid.x0 + cx * grid.width, grid.x0 + (cx + 1) * grid.width},
            y{grid.y0 + cy * grid.width, grid.y0 + (cy + 1) * grid.width};
        std::vector<std::int32_t>& ranks = of[c];
        for (const Interval& at_x : with_images(x, mirrors, 0, {low.x, high.x}, reach))
            for (const Interval& at_y : with_images(y, mirrors, 1, {low.y, high.y}, reach))
                for (int oz = std::max(0, cz - 1); oz <= std::min(grid.nz - 1, cz + 1); ++oz)
                    for (int oy = grid.pencil_y(at_y.low - reach); oy <= grid.pencil_y(at_y.high + reach); ++oy)
                        for (int ox = grid.pencil_x(at_x.low - reach); ox <= grid.pencil_x(at_x.high + reach); ++ox) {
                            const double gx = grid.gap_x(ox, at_x.low, at_x.high),
                                         gy = grid.gap_y(oy, at_y.low, at_y.high);
                            if (gx * gx + gy * gy > double(reach) * double(reach)) continue;
                            const std::int32_t r = owner(grid.pencil(ox, oy, oz));
                            if (r != owner(pencil) && std::ranges::find(ranks, r) == ranks.end()) ranks.push_back(r);
                        }
        std::ranges::sort(ranks);
    });
    first_.assign(count + 1, 0);
    holders_.clear();
    for (std::size_t c = 0; c < count; ++c) {
        holders_.insert(holders_.end(), of[c].begin(), of[c].end());
        first_[c + 1] = holders_.size();
    }
}

bool Decomposition::holds(int rank, int pencil) const {
    const auto others = holders(pencil);
    return owner(pencil) == rank || std::ranges::binary_search(others, rank);
}

}  // namespace tw
