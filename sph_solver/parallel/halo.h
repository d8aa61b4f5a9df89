#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "sph_solver/parallel/comm.h"
#include "sph_solver/parallel/decomposition.h"

namespace tw {

/// The halo exchange of things that stand sorted by pencil: the owner of a pencil sends them to all who hold a copy of
/// it. Sender and receiver have the same things of a pencil in the same order, so nothing but their values is sent.
///
/// A thing's own state (place, velocity, ...) changes alike wherever it is held. What a copy cannot know are sums over
/// its neighbours, which are not all held beside it: those are exchanged.
class Halo {
public:
    /// Of one process: exchanges nothing.
    Halo() = default;
    /// `starts`: first thing of each pencil, from an index on for each of several lists, one behind the other.
    struct Sorted {
        const std::vector<std::int32_t>* start;
        std::int32_t from;
    };
    Halo(const Comm& ranks, const Decomposition& pencils, std::span<const Sorted> lists);

    /// Exchanges `bytes` of each thing: `pack(i, to)` on the owner, `unpack(i, from)` on those that hold a copy.
    template <class Pack, class Unpack>
    void exchange(std::size_t bytes, const Pack& pack, const Unpack& unpack) const {
        if (partners_.empty()) return;
        std::vector<Comm::Parcel> to, from;
        for (const Partner& p : partners_) {
            to.push_back({p.rank, Comm::Bytes(p.sent * bytes)});
            std::byte* at = to.back().bytes.data();
            each(p.send, [&](std::size_t i) { pack(i, at), at += bytes; });
            from.push_back({p.rank, Comm::Bytes(p.received * bytes)});
        }
        ranks_->exchange(to, from);
        for (std::size_t k = 0; k < partners_.size(); ++k) {
            const std::byte* at = from[k].bytes.data();
            each(partners_[k].receive, [&](std::size_t i) { unpack(i, at), at += bytes; });
        }
    }
    /// Exchanges the elements of arrays.
    template <class... T>
    void exchange(T*... values) const {
        static_assert((std::is_trivially_copyable_v<T> && ...));
        exchange(
            (sizeof(T) + ...),
            [&](std::size_t i, std::byte* to) { ((std::memcpy(to, values + i, sizeof(T)), to += sizeof(T)), ...); },
            [&](std::size_t i, const std::byte* from) {
                ((std::memcpy(values + i, from, sizeof(T)), from += sizeof(T)), ...);
            });
    }
    std::size_t received() const;  ///< things that are copies

    // --- for things that a device has: it packs them and unpacks them itself
    bool has_no_partners() const { return partners_.empty(); }
    /// Which things the messages carry, one message behind the other; and those of the messages that come.
    std::vector<std::int32_t> all_sent() const { return all(&Partner::send); }
    std::vector<std::int32_t> all_received() const { return all(&Partner::receive); }
    /// Sends `out`, which has `bytes` of each of all_sent; gives the same of all_received.
    std::vector<std::byte> exchange_packed(std::size_t bytes, std::span<const std::byte> out) const;

private:
    struct Range {
        std::int32_t first, last;
    };
    struct Partner {
        int rank;
        std::vector<Range> send, receive;
        std::size_t sent = 0, received = 0;
    };
    std::vector<std::int32_t> all(std::vector<Range> Partner::*of) const;
    template <class F>
    static void each(const std::vector<Range>& ranges, const F& f) {
        for (const Range& r : ranges)
            for (std::int32_t i = r.first; i < r.last; ++i) f(static_cast<std::size_t>(i));
    }

    const Comm* ranks_ = nullptr;
    std::vector<Partner> partners_;
};

}  // namespace tw
