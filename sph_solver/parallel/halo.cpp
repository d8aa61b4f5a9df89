#include "sph_solver/parallel/halo.h"

namespace tw {

Halo::Halo(const Comm& ranks, const Decomposition& pencils, std::span<const Sorted> lists) : ranks_(&ranks) {
    if (!ranks.many()) return;
    std::vector<Partner> all(static_cast<std::size_t>(ranks.size()));
    for (const auto& [start, from] : lists)
        for (std::size_t c = 0; c + 1 < start->size(); ++c) {
            const Range range{from + (*start)[c], from + (*start)[c + 1]};
            if (range.first == range.last) continue;
            const auto pencil = static_cast<int>(c);
            const auto n = static_cast<std::size_t>(range.last - range.first);
            if (pencils.owner(pencil) != ranks.rank()) {
                if (!pencils.holds(ranks.rank(), pencil)) continue;
                Partner& p = all[static_cast<std::size_t>(pencils.owner(pencil))];
                p.receive.push_back(range), p.received += n;
                continue;
            }
            for (const std::int32_t r : pencils.holders(pencil)) {
                Partner& p = all[static_cast<std::size_t>(r)];
                p.send.push_back(range), p.sent += n;
            }
        }
    for (std::size_t r = 0; r < all.size(); ++r) {
        if (all[r].sent + all[r].received == 0) continue;
        all[r].rank = static_cast<int>(r);
        partners_.push_back(std::move(all[r]));
    }
}

std::vector<std::int32_t> Halo::all(std::vector<Range> Partner::*of) const {
    std::vector<std::int32_t> things;
    for (const Partner& p : partners_)
        each(p.*of, [&](std::size_t i) { things.push_back(static_cast<std::int32_t>(i)); });
    return things;
}

std::vector<std::byte> Halo::exchange_packed(std::size_t bytes, std::span<const std::byte> out) const {
    std::vector<Comm::Parcel> to, from;
    for (const Partner& p : partners_) {
        const std::span<const std::byte> own = out.first(p.sent * bytes);
        out = out.subspan(own.size());
        to.push_back({p.rank, Comm::Bytes(own.begin(), own.end())});
        from.push_back({p.rank, Comm::Bytes(p.received * bytes)});
    }
    ranks_->exchange(to, from);
    std::vector<std::byte> in;
    for (const Comm::Parcel& p : from) in.insert(in.end(), p.bytes.begin(), p.bytes.end());
    return in;
}

std::size_t Halo::received() const {
    std::size_t n = 0;
    for (const Partner& p : partners_) n += p.received;
    return n;
}

}  // namespace tw
