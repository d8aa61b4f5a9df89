#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sph_solver/bodies/samples.h"
#include "sph_solver/levels/fields_at.h"
#include "sph_solver/levels/particle_system.h"
#include "sph_solver/loops/edge_labels.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/parallel/decomposition.h"
#include "sph_solver/parallel/halo.h"

namespace tw {

/// What of a level's particles this rank holds, and what it exchanges with the others: each owns whole pencils, and
/// holds copies of the pencils round them. Of one process all of it is a matter of course: it owns all, and exchanges
/// nothing.
class RankShare {
public:
    /// `level` must outlive this, with the particles that a run begins with.
    explicit RankShare(ParticleSystem& level) : level_(level) { begin_on_first(); }
    RankShare(const RankShare&) = delete;

    const Comm& ranks() const { return level_.ranks(); }
    bool owns(std::size_t i) const { return own_.empty() || own_[i] != 0; }
    const char* own() const { return own_.empty() ? nullptr : own_.data(); }  ///< of each particle; null: all are
    std::size_t copies() const { return halo_.received(); }
    const Halo& halo() const { return halo_; }
    std::int64_t total() const { return total_; }  ///< particles of all ranks; of several ranks only
    void take_out(std::int64_t count) { total_ -= count; }
    std::int32_t pencil_of(std::size_t i) const;   ///< in which it stood when it was sorted last; of several ranks only
    std::function<bool(int)> own_pencils() const;  ///< empty: all are
    /// Throws InputError where so many ranks are more than the pencils with particles; before the first step.
    void refuse_idle(int count) const;
    /// From now on the pencils go to the ranks as those of another level of the same pencils do, which has its lists
    /// made first.
    void share_pencils_with(RankShare& leading) { leading.following_ = this, pencils_of_ = &leading; }

    // --- which particles it holds
    /// The first rank holds all particles, until lists are made; the others none.
    void begin_on_first();
    /// Lets particles go, and copies of others' particles; lists are due then. Empty: only the copies.
    void let_go(const std::vector<int>& gone);
    /// Somebody else has done that: so many are left, and near.start is as they stand.
    void note_let_go(std::size_t left);
    /// Those behind the sorted ones, which have been added since, are its own.
    void own_added() {
        if (ranks().many()) own_.resize(level_.particles.size(), 1);
    }
    /// Lets particles cross the faces of the domain, and go to the ranks that own their pencils: the indices of those
    /// that the level has then, in no order. `reach`: how far lists will look [m].
    std::vector<std::int32_t> cross_and_hold(double reach);
    bool is_on_first() const { return ranks().many() && work_.empty(); }  ///< as it begins, see begin_on_first
    // The parts of that for particles that are elsewhere:
    void divide_pencils();
    /// The numbers of those that entered in the place of `entered`; empty where they are right already.
    std::vector<std::int64_t> agree_on_crossings(const Ledger& before, const std::vector<std::int32_t>& entered);
    void find_holders(double reach);
    /// A mark for each pencil: of this rank's, and no copies of it are held elsewhere.
    std::vector<char> inner_pencils() const;
    /// Of the pencils with copies and of those of others.
    void hold_pencils(const std::vector<std::int32_t>& staying);
    void note_own();
    /// Pairs that the pair loops visit, of each cluster of the own pencils.
    void note_work(std::span<const int> of_clusters);

    // --- what ranks exchange
    void exchange_first_sums();
    /// All particles of all ranks, in the order in which one process holds them; on the first rank, elsewhere none.
    Particles gathered() const;
    /// Each point is worked out by one rank, and nothing on the others.
    void exchange_samples(PointSamples& points) const;
    /// Fields at places: `here` works out those of which this rank owns the pencils.
    void interpolate_together(FieldsAt& at, const std::function<void(FieldsAt&)>& here) const;
    /// Of several ranks all of it, with indices in the order in which one process holds all; else `own`.
    std::vector<Located> of_all_ranks(std::vector<Located> own) const;
    std::int64_t among_all(std::size_t i) const;  ///< that index of one that this process owns
    /// The one that has it; nothing: another process owns it.
    std::optional<std::size_t> owned(std::int64_t among_all) const;
    /// Puts what all ranks have of impulses in the order of their pencils.
    template <class AtPlace>
    std::vector<AtPlace> of_all_ranks(const std::vector<AtPlace>& own, const std::vector<std::int32_t>& pencils) const;
    /// The numbers 0, 1, ... of things of all ranks, each by a particle, in the order of these; `by` names those of the
    /// own things in ascending order.
    struct Numbers {
        std::vector<std::int64_t> own;
        std::int64_t all;
    };
    Numbers number_by_pencil(const std::vector<std::int32_t>& by) const;
    /// Ends the run on all ranks, which all call it, with the text of the one whose particle is first in order.
    struct Failing {
        std::optional<std::size_t> at;  ///< a particle that this rank holds; none: it has none that fails
        std::int64_t order;             ///< among those of all ranks
        std::string what;
    };
    [[noreturn]] void fail_together(const Failing& failing) const;
    [[noreturn]] void fail_through_wall(std::optional<std::size_t> particle) const;

private:
    PencilGrid blocks() const;
    void add_work(std::vector<std::int64_t>& of_pencils) const;

    ParticleSystem& level_;
    Decomposition pencils_;
    RankShare *pencils_of_ = nullptr, *following_ = nullptr;  ///< see share_pencils_with
    Halo halo_;
    std::vector<char> own_;           ///< of each particle; empty: all are
    std::int64_t total_ = 0;          ///< particles of all ranks
    std::vector<std::int64_t> work_;  ///< of each of its pencils, by the lists made last; empty: none were made
};

}  // namespace tw
