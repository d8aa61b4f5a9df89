// What the ranks that share a level exchange.
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "base/errors.h"
#include "sph_solver/levels/rank_share.h"

namespace tw {

namespace {
template <class T>
void append(Comm::Bytes& to, const T& what) {
    static_assert(std::is_trivially_copyable_v<T>);
    to.resize(to.size() + sizeof(T));
    std::memcpy(to.data() + to.size() - sizeof(T), &what, sizeof(T));
}
}  // namespace

void RankShare::exchange_samples(PointSamples& points) const {
    for (std::vector<float>* values : {&points.p, &points.support, &points.flux})
        ranks().take_from_owners(std::span(*values));
}

void RankShare::exchange_first_sums() {
    struct Sums {
        float gx, gy, gz, support, drho;
    };
    Particles& p = level_.particles;
    const std::size_t carried = p.carried.empty() ? 0 : sizeof(CarriedShare);
    halo_.exchange(
        sizeof(Sums) + carried,
        [&](std::size_t i, std::byte* to) {
            const PackedGradientPressure& g = p.gradient_pressure[i];
            const Sums sums{g.gx, g.gy, g.gz, p.shift_support[i].support, p.rate[i].drho};
            std::memcpy(to, &sums, sizeof(Sums));
            if (carried > 0) std::memcpy(to + sizeof(Sums), &p.carried[i], carried);
        },
        [&](std::size_t i, const std::byte* from) {
            Sums sums;
            std::memcpy(&sums, from, sizeof(Sums));
            PackedGradientPressure& g = p.gradient_pressure[i];
            g.gx = sums.gx, g.gy = sums.gy, g.gz = sums.gz;
            p.shift_support[i].support = sums.support, p.rate[i].drho = sums.drho;
            if (carried > 0) std::memcpy(&p.carried[i], from + sizeof(Sums), carried);
        });
}

/// The places of a pencil go to one rank, so those that are worked out together are those of one process. Places that
/// coincide have the same fields, whatever the order of the ranks makes of theirs.
void RankShare::interpolate_together(FieldsAt& at, const std::function<void(FieldsAt&)>& interpolate_here) const {
    const Comm& all = ranks();
    const std::size_t n = at.places.size();
    if (all.sum(static_cast<std::int64_t>(n)) == 0) return;
    const PencilGrid pencils = level_.grid.scaled(at.apart);
    const auto size = static_cast<std::size_t>(all.size());
    std::vector<std::size_t> asked(n);  // whom
    std::vector<Comm::Bytes> questions(size);
    for (std::size_t k = 0; k < n; ++k) {
        const Vec3& x = at.places[k];
        asked[k] = static_cast<std::size_t>(
            pencils_.owner(level_.grid.of(pencils.centre(pencils.of(level_.fixed_point.wide(x))))));
        append(questions[asked[k]], std::array{x.x(), x.y(), x.z()});
    }
    const std::vector<Comm::Bytes> theirs = all.exchange(questions);
    constexpr std::size_t bytes = sizeof(std::array<double, 3>);
    FieldsAt here{static_cast<const Asking&>(at)};
    for (const Comm::Bytes& of_rank : theirs)
        for (std::size_t from = 0; from < of_rank.size(); from += bytes) {
            std::array<double, 3> x;
            std::memcpy(x.data(), of_rank.data() + from, bytes);
            here.places.emplace_back(x[0], x[1], x[2]);
        }
    interpolate_here(here);

    std::vector<Comm::Parcel> answers, given;
    std::vector<std::size_t> of(size);  // whose answers stand where
    std::size_t next = 0;
    for (std::size_t r = 0; r < size; ++r) {
        if (!theirs[r].empty()) answers.push_back({static_cast<int>(r), {}});
        for (std::size_t k = 0; k < theirs[r].size() / bytes; ++k) append(answers.back().bytes, here.given(next++));
        of[r] = given.size();
        if (const std::size_t count = questions[r].size() / bytes; count > 0)
            given.push_back({static_cast<int>(r), Comm::Bytes(count * sizeof(Given))});
    }
    all.exchange(answers, given);
    std::vector<std::size_t> read(size, 0);
    for (std::size_t k = 0; k < n; ++k) {
        Given g;
        std::memcpy(&g, given[of[asked[k]]].bytes.data() + read[asked[k]], sizeof(Given));
        read[asked[k]] += sizeof(Given);
        at.take(k, g);
    }
}

Particles RankShare::gathered() const {
    if (!ranks().many()) return level_.particles;
    Particles all;
    all.allocate_as(level_.particles);
    struct Pencil {
        std::int32_t pencil, size;
    };
    const std::size_t bytes = level_.particles.moved_bytes();
    Comm::Bytes own;
    for (std::size_t c = 0; c + 1 < level_.near.start.size(); ++c) {
        const Pencil pencil{static_cast<std::int32_t>(c), level_.near.start[c + 1] - level_.near.start[c]};
        if (pencil.size == 0 || pencils_.owner(pencil.pencil) != ranks().rank()) continue;
        std::size_t at = own.size();
        own.resize(at + sizeof(Pencil) + static_cast<std::size_t>(pencil.size) * bytes);
        std::memcpy(own.data() + at, &pencil, sizeof(Pencil));
        at += sizeof(Pencil);
        for (std::int32_t i = level_.near.start[c]; i < level_.near.start[c + 1]; ++i, at += bytes)
            level_.particles.pack(static_cast<std::size_t>(i), own.data() + at);
    }
    const std::vector<Comm::Bytes> of_ranks = ranks().sent_to_first(own);
    if (!ranks().first()) return all;
    std::vector<std::pair<Pencil, const std::byte*>> pencils;
    for (const Comm::Bytes& of_rank : of_ranks)
        for (const std::byte* at = of_rank.data(); at != of_rank.data() + of_rank.size();) {
            Pencil pencil;
            std::memcpy(&pencil, at, sizeof(Pencil));
            pencils.emplace_back(pencil, at + sizeof(Pencil));
            at += sizeof(Pencil) + static_cast<std::size_t>(pencil.size) * bytes;
        }
    std::ranges::sort(pencils, {}, [](const auto& c) { return c.first.pencil; });
    all.resize(static_cast<std::size_t>(total_));
    std::size_t i = 0;
    for (const auto& [pencil, from] : pencils)
        for (std::int32_t k = 0; k < pencil.size; ++k) all.unpack(i++, from + static_cast<std::size_t>(k) * bytes);
    return all;
}

template <class AtPlace>
std::vector<AtPlace> RankShare::of_all_ranks(const std::vector<AtPlace>& own,
                                             const std::vector<std::int32_t>& pencils) const {
    if (!ranks().many()) return own;
    struct Sent {
        std::int32_t pencil, triangle;
        std::uint64_t body;
        std::array<double, 6> place_and_what;
    };
    std::vector<Sent> sent;
    for (std::size_t k = 0; k < own.size(); ++k) {
        const auto& [body, triangle, place, what] = own[k];
        sent.push_back({pencils[k], triangle, body, {place.x(), place.y(), place.z(), what.x(), what.y(), what.z()}});
    }
    std::vector<Sent> all = ranks().gathered(sent);
    std::ranges::stable_sort(all, {}, &Sent::pencil);
    std::vector<AtPlace> impulses;
    for (const Sent& s : all)
        impulses.push_back({static_cast<std::size_t>(s.body), s.triangle, Vec3(s.place_and_what.data()),
                            Vec3(s.place_and_what.data() + 3)});
    return impulses;
}
template std::vector<WallPush> RankShare::of_all_ranks(const std::vector<WallPush>&,
                                                       const std::vector<std::int32_t>&) const;
template std::vector<WallImpulse> RankShare::of_all_ranks(const std::vector<WallImpulse>&,
                                                          const std::vector<std::int32_t>&) const;

void RankShare::fail_together(const Failing& failing) const {
    struct Rank {
        std::int64_t order;
        std::int32_t rank;
    };
    const Rank own{failing.at ? failing.order : std::numeric_limits<std::int64_t>::max(), ranks().rank()};
    const Rank speaks = ranks().combined(
        own, +[](Rank& all, const Rank& other) {
            if (std::pair(other.order, other.rank) < std::pair(all.order, all.rank)) all = other;
        });
    throw RunError(ranks().broadcast_from(
        speaks.rank, failing.at ? level_.text_of_failure(*failing.at, failing.what) : std::string()));
}

void RankShare::fail_through_wall(std::optional<std::size_t> through) const {
    ++level_.ledger.lost;
    fail_together({through, through ? -pencil_of(*through) : 0,
                   "has gone through the hull; often a wall thinner than the kernel's support 2 h, or a spacing too "
                   "coarse for a sharp edge"});
}

}  // namespace tw
