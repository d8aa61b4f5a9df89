#include "sph_solver/parallel/halo.h"

namespace tw {

Halo::Halo(const Comm& ranks, const Decomposition& columns, std::span<const Sorted> lists) : ranks_(&ranks) {
    if (!ranks.many()) return;
    std::vector<Partner> all(static_cast<std::size_t>(ranks.size()));
    for (const auto& [start, from] : lists)
        for (std::size_t c = 0; c + 1 < start->size(); ++c) {
            const Range range{from + (*start)[c], from + (*start)[c + 1]};
            if (range.first == range.last) continue;
            const auto column = static_cast<int>(c);
            const auto n = static_cast<std::size_t>(range.last - range.first);
            if (columns.owner(column) != ranks.rank()) {
                if (!columns.holds(ranks.rank(), column)) continue;
                Partner& p = all[static_cast<std::size_t>(columns.owner(column))];
                p.receive.push_back(range), p.received += n;
                continue;
            }
            for (const std::int32_t r : columns.holders(column)) {
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

std::size_t Halo::received() const {
    std::size_t n = 0;
    for (const Partner& p : partners_) n += p.received;
    return n;
}

}  // namespace tw
