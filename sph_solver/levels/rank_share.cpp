// A level whose particles are shared by several ranks. Each owns whole pencils, and holds copies of the pencils round
// them, all in the one order of the pencils: so lists, clusters, and the order of all sums over pairs are those of one
// process, and so are the bits. A copy changes as its original does, but for sums over its neighbours, which the owner
// sends (parallel/halo.h).
#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/backend/for_particles.h"
#include "sph_solver/levels/rank_share.h"
#include "sph_solver/loops/inlet_wave.h"

namespace tw {

namespace {
/// Work that a rank may have beyond the mean before the pencils are divided anew.
constexpr double largest_imbalance = 1.05;
}  // namespace

std::int32_t RankShare::pencil_of(std::size_t i) const {
    if (!ranks().many()) return 0;  // it is asked for where ranks differ
    const auto after =
        std::upper_bound(level_.near.start.begin(), level_.near.start.end(), static_cast<std::int32_t>(i));
    return static_cast<std::int32_t>(after - level_.near.start.begin()) - 1;
}

std::function<bool(int)> RankShare::own_pencils() const {
    if (!ranks().many()) return {};
    return [this](int pencil) { return pencils_.owner(pencil) == ranks().rank(); };
}

/// As if all stood in the first pencil, which is the first rank's.
void RankShare::begin_on_first() {
    if (!ranks().many()) return;
    const std::size_t n = level_.particles.size();
    total_ = ranks().sum(static_cast<std::int64_t>(n));
    pencils_ = {};
    level_.near.start.assign(static_cast<std::size_t>(level_.grid.count()) + 1, static_cast<std::int32_t>(n));
    level_.near.start.front() = 0;
    work_.clear();
    note_let_go(n);
}

void RankShare::refuse_idle(int count) const {
    if (count <= 1) return;
    std::vector<char> busy(static_cast<std::size_t>(level_.grid.count()), 0);
    for (std::size_t i = 0; i < level_.particles.size(); ++i)
        busy[static_cast<std::size_t>(level_.grid.of(
            level_.fixed_point.wide({level_.particles.x[i], level_.particles.y[i], level_.particles.z[i]})))] = 1;
    const std::int64_t pencils = ranks().sum(std::ranges::count(busy, 1));  // the first rank has all particles
    if (pencils < count)
        throw InputError(fmt::format("the {} stands in {} columns of particles, and there are {} ranks: take fewer",
                                     level_.setup.material, pencils, count));
}

/// What is left keeps its order, and its pencils; what has been added behind them is in none.
void RankShare::let_go(const std::vector<int>& gone) {
    const std::size_t n = level_.particles.size();
    std::vector<std::int32_t> kept, before(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        before[i] = static_cast<std::int32_t>(kept.size());
        if (owns(i) && (gone.empty() || !gone[i])) kept.push_back(static_cast<std::int32_t>(i));
    }
    before[n] = static_cast<std::int32_t>(kept.size());
    level_.particles.reorder(kept);
    if (!ranks().many()) return;
    for (std::int32_t& first : level_.near.start) first = before[static_cast<std::size_t>(first)];
    note_let_go(kept.size());
}

void RankShare::note_let_go(std::size_t left) {
    own_.assign(left, 1);
    halo_ = {};
}

std::int64_t RankShare::among_all(std::size_t i) const {
    const auto index = static_cast<std::int64_t>(i);
    return ranks().many() ? std::int64_t{pencil_of(i)} << 32 | index : index;
}

std::optional<std::size_t> RankShare::owned(std::int64_t index) const {
    if (!ranks().many()) return static_cast<std::size_t>(index);
    const auto i = static_cast<std::size_t>(index & 0xffffffff);
    if (i < level_.particles.size() && owns(i) && among_all(i) == index) return i;
    return {};
}

std::vector<Located> RankShare::of_all_ranks(std::vector<Located> own) const {
    if (!ranks().many()) return own;
    for (Located& one : own) one.index = among_all(static_cast<std::size_t>(one.index));
    std::vector<Located> all = ranks().gathered(own);
    std::ranges::sort(all, {}, &Located::index);
    return all;
}

RankShare::Numbers RankShare::number_by_pencil(const std::vector<std::int32_t>& by) const {
    Numbers numbers{{}, static_cast<std::int64_t>(by.size())};
    numbers.own.resize(by.size());
    std::iota(numbers.own.begin(), numbers.own.end(), 0);
    if (!ranks().many()) return numbers;
    std::vector<std::int32_t> own(by.size());
    for (std::size_t k = 0; k < own.size(); ++k) own[k] = pencil_of(static_cast<std::size_t>(by[k]));
    std::vector<std::int32_t> all = ranks().gathered(own);
    std::ranges::sort(all);
    for (std::size_t k = 0; k < own.size(); ++k)
        numbers.own[k] += (std::ranges::lower_bound(all, own[k]) - all.begin()) -
                          (std::ranges::lower_bound(own, own[k]) - own.begin());
    numbers.all = static_cast<std::int64_t>(all.size());
    return numbers;
}

/// What has crossed open boundaries of all ranks' pencils; particles that entered get the ids that they have where one
/// process counts them, pencil by pencil.
std::vector<std::int64_t> RankShare::agree_on_crossings(const Ledger& before,
                                                        const std::vector<std::int32_t>& entered) {
    level_.ledger.out = before.out + ranks().sum(level_.ledger.out - before.out);
    if (!level_.around.stream) return {};
    Numbers numbers = number_by_pencil(entered);
    for (std::int64_t& number : numbers.own) number += before.next_id;
    level_.ledger.in = before.in + numbers.all, level_.ledger.next_id = before.next_id + numbers.all;
    return std::move(numbers.own);
}

/// Adds the work of this rank's particles to that of their pencils: pairs by the lists as they are, or particles where
/// none were made yet.
void RankShare::add_work(std::vector<std::int64_t>& of_pencils) const {
    for (std::size_t c = 0; c < work_.size(); ++c) of_pencils[c] += work_[c];
    for (std::size_t i = 0; i < level_.particles.size() && work_.empty(); ++i)
        ++of_pencils[static_cast<std::size_t>(level_.grid.of(
            level_.fixed_point.wide({level_.particles.x[i], level_.particles.y[i], level_.particles.z[i]})))];
}

/// Divides the pencils where their work, and that of a level which follows, has become uneven.
void RankShare::divide_pencils() {
    if (pencils_of_) {
        pencils_ = pencils_of_->pencils_;
        return;
    }
    std::vector<std::int64_t> of_pencils(static_cast<std::size_t>(level_.grid.count()), 0);
    add_work(of_pencils);
    if (following_) following_->add_work(of_pencils);
    struct Load {
        std::int64_t sum, largest;
    };
    const std::int64_t own = std::accumulate(of_pencils.begin(), of_pencils.end(), std::int64_t{0});
    const Load load = ranks().combined(
        Load{own, own}, +[](Load& all, const Load& other) {
            all.sum += other.sum, all.largest = std::max(all.largest, other.largest);
        });
    if (double(load.largest) * ranks().size() <= largest_imbalance * double(load.sum)) return;
    ranks().add(std::span<std::int64_t>(of_pencils));
    pencils_ = Decomposition(level_.grid, blocks(), of_pencils, ranks().size());
}

/// What is left together when pencils are divided. A coarser level's places are sorted by pencils twice as wide.
PencilGrid RankShare::blocks() const {
    return level_.particles.has(With::coarser) ? level_.grid.scaled(2) : level_.grid;
}

std::vector<std::int32_t> RankShare::cross_and_hold(double reach) {
    Particles& p = level_.particles;
    const bool many = ranks().many();
    if (many) {
        divide_pencils();
        let_go({});
    }
    const Ledger before = level_.ledger;
    const std::size_t n = p.size();
    const auto [gone, entered] = cross_open_boundaries(level_.around, level_.setup.dp, p, level_.ledger);
    if (level_.inlet_has_wave()) {
        const Stream& stream = *level_.around.stream;
        level_.with_wave_of_inlet([&, first = n]<class Wave>(const WaveOfInlet<Wave>& of) {
            for_particles(entered.size(), EnterUnderWave<Wave>{level_.state_view(), p.view().calm_height, of, first,
                                                               stream.wave_at(level_.time), stream.buffer});
        });
    }
    std::vector<std::int32_t> index;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (!gone[i]) index.push_back(static_cast<std::int32_t>(i));
    level_.ledger.out += static_cast<std::int64_t>(p.size() - index.size());
    if (!many) return index;
    const std::vector<std::int64_t> ids = agree_on_crossings(before, entered);
    std::ranges::copy(ids, p.id.end() - static_cast<std::ptrdiff_t>(ids.size()));
    find_holders(reach);
    hold_pencils(index);
    index.resize(p.size());
    std::iota(index.begin(), index.end(), 0);
    return index;
}

/// Those that see points between particles have moved since, see SortedPlaces::stale.
void RankShare::find_holders(double reach) {
    const double furthest = std::max(reach, level_.reach_of_others()) + 0.1 * level_.setup.dp;
    pencils_.find_holders(level_.grid, level_.around.mirrors, level_.fixed_point.wide(level_.around.domain.min),
                          level_.fixed_point.wide(level_.around.domain.max),
                          static_cast<std::int64_t>(furthest * level_.fixed_point.per_metre) + 1);
}

std::vector<char> RankShare::inner_pencils() const {
    std::vector<char> inner(static_cast<std::size_t>(level_.grid.count()));
    for (std::size_t c = 0; c < inner.size(); ++c)
        inner[c] =
            pencils_.owner(static_cast<int>(c)) == ranks().rank() && pencils_.holders(static_cast<int>(c)).empty();
    return inner;
}

/// Sends particles to the ranks that own their pencils, and copies to those that need them; then the level has those of
/// the pencils that it holds, in no order. `staying`: which of the present ones stay in the run.
void RankShare::hold_pencils(const std::vector<std::int32_t>& staying) {
    const std::size_t n = staying.size();
    std::vector<std::int32_t> pencil(n);
    for_particles(n, [&](std::size_t k) {
        const auto i = static_cast<std::size_t>(staying[k]);
        pencil[k] = level_.grid.of(
            level_.fixed_point.wide({level_.particles.x[i], level_.particles.y[i], level_.particles.z[i]}));
    });
    const int self = ranks().rank();
    std::vector<std::int32_t> kept;
    std::vector<Comm::Bytes> to(static_cast<std::size_t>(ranks().size()));
    const std::size_t bytes = level_.particles.moved_bytes();
    for (std::size_t k = 0; k < n; ++k) {
        const std::int32_t c = pencil[k];
        if (pencils_.holds(self, c)) kept.push_back(staying[k]);
        const auto send = [&](int r) {
            if (r == self) return;
            Comm::Bytes& out = to[static_cast<std::size_t>(r)];
            out.resize(out.size() + bytes);
            level_.particles.pack(static_cast<std::size_t>(staying[k]), out.data() + out.size() - bytes);
        };
        send(pencils_.owner(c));
        for (const std::int32_t r : pencils_.holders(c)) send(r);
    }
    level_.particles.reorder(kept);
    for (const Comm::Bytes& got : ranks().exchange(to)) {
        const std::size_t before = level_.particles.size();
        level_.particles.resize(before + got.size() / bytes);
        for (std::size_t k = 0; k < got.size() / bytes; ++k)
            level_.particles.unpack(before + k, got.data() + k * bytes);
    }
    own_.assign(level_.particles.size(), 0);  // until they are sorted
}

/// The particles are sorted: who owns which, and the halo exchange.
void RankShare::note_own() {
    own_.assign(level_.particles.size(), 0);
    std::int64_t mine = 0;
    for (std::size_t c = 0; c + 1 < level_.near.start.size(); ++c) {
        if (pencils_.owner(static_cast<int>(c)) != ranks().rank()) continue;
        std::fill(own_.begin() + level_.near.start[c], own_.begin() + level_.near.start[c + 1], 1);
        mine += level_.near.start[c + 1] - level_.near.start[c];
    }
    total_ = ranks().sum(mine);
    const Halo::Sorted sorted{&level_.near.start, 0};
    halo_ = Halo(ranks(), pencils_, std::span(&sorted, 1));
    level_.walls.set_halo(ranks(), pencils_);
}

/// Clusters are full but for the last of each pencil.
void RankShare::note_work(std::span<const int> of_clusters) {
    const std::size_t pencils = level_.near.start.size() - 1;
    work_.assign(pencils, 0);
    std::size_t k = 0;
    for (std::size_t c = 0; c < pencils; ++c) {
        if (pencils_.owner(static_cast<int>(c)) != ranks().rank()) continue;
        for (std::int32_t i = level_.near.start[c]; i < level_.near.start[c + 1]; i += level_.passes.lanes)
            work_[c] += of_clusters[k++];
    }
}

}  // namespace tw
