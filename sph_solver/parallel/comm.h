#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace tw {

/// The processes ("ranks") that make one run together. All make the same calls in the same order. A process by itself
/// is a Comm of one, whose calls do nothing; a build without MPI knows no other.
///
/// What is combined are whole numbers, maxima and sums of base/exact_sum.h: the same in any order, so the same for any
/// number of ranks.
class Comm {
public:
    /// This process by itself.
    static const Comm& alone();
    /// Those that mpirun or srun has started; by itself where it was started by none of them. MPI is initialised by the
    /// first call, in the main thread. Throws InputError: started as several processes, and built without MPI.
    static const Comm& world();
    static bool built_with_mpi();

    int rank() const { return rank_; }
    int size() const { return size_; }
    int rank_here() const { return rank_here_; }  ///< among those on this machine
    int size_here() const { return size_here_; }  ///< ranks on this machine
    bool first() const { return rank_ == 0; }     ///< the one that writes and speaks
    bool many() const { return size_ > 1; }

    using Bytes = std::vector<std::byte>;

    /// Puts in each place what `into(all, own)` makes of all ranks' values there, in any order.
    template <class T>
    void combine(std::span<T> values, void (*into)(T& all, const T& own)) const {
        static_assert(std::is_trivially_copyable_v<T>);
        if (!many() || values.empty()) return;
        combine_bytes(values.data(), sizeof(T), values.size(), [into](void* all, const void* own) {
            T a, b;  // MPI aligns nothing
            std::memcpy(&a, all, sizeof(T)), std::memcpy(&b, own, sizeof(T));
            into(a, b);
            std::memcpy(all, &a, sizeof(T));
        });
    }
    template <class T>
    T combined(T own, void (*into)(T& all, const T& own)) const {
        combine(std::span<T>(&own, 1), into);
        return own;
    }
    /// Sums by +=, place by place.
    template <class T>
    void add(std::span<T> values) const {
        combine(
            values, +[](T& all, const T& own) { all += own; });
    }
    /// Likewise of several lists of different things, in one message.
    template <class... T>
    requires(sizeof...(T) > 1) void add(std::span<T>... lists) const {
        static_assert((std::is_trivially_copyable_v<T> && ...));
        if (!many()) return;
        Bytes message((lists.size_bytes() + ...));
        std::byte* at = message.data();
        const auto each_list = [&](const auto& of_list) { (of_list(lists), ...); };
        each_list([&](auto list) {
            if (!list.empty()) std::memcpy(at, list.data(), list.size_bytes());
            at += list.size_bytes();
        });
        combine_bytes(message.data(), message.size(), 1, [&](void* all, const void* own) {
            std::size_t from = 0;
            each_list([&]<class U>(std::span<U> list) {
                for (std::size_t k = 0; k < list.size(); ++k, from += sizeof(U)) {
                    U a, b;
                    std::memcpy(&a, static_cast<std::byte*>(all) + from, sizeof(U));
                    std::memcpy(&b, static_cast<const std::byte*>(own) + from, sizeof(U));
                    a += b;
                    std::memcpy(static_cast<std::byte*>(all) + from, &a, sizeof(U));
                }
            });
        });
        at = message.data();
        each_list([&](auto list) {
            if (!list.empty()) std::memcpy(list.data(), at, list.size_bytes());
            at += list.size_bytes();
        });
    }
    template <class T>
    T sum(T own) const {
        add(std::span<T>(&own, 1));
        return own;
    }
    /// Of numbers that one rank each has and that are all bits 0 on the others.
    template <class T>
    void take_from_owners(std::span<T> values) const {
        combine(
            values, +[](T& all, const T& own) {
                if (own != 0 || std::signbit(own)) all = own;  // the sign of a zero, too
            });
    }
    double largest(double own) const {
        return combined(
            own, +[](double& all, const double& other) { all = all < other ? other : all; });
    }

    /// All ranks' lists, in the order of the ranks.
    template <class T>
    std::vector<T> gathered(const std::vector<T>& own) const {
        static_assert(std::is_trivially_copyable_v<T>);
        if (!many()) return own;
        const Bytes all = gathered_bytes({reinterpret_cast<const std::byte*>(own.data()), own.size() * sizeof(T)});
        std::vector<T> values(all.size() / sizeof(T));
        if (!all.empty()) std::memcpy(values.data(), all.data(), all.size());
        return values;
    }
    /// What each rank has sent to the first one; there alone.
    std::vector<Bytes> sent_to_first(const Bytes& own) const;
    /// Sends `to[r]` to each other rank r; gives what each of them has sent.
    std::vector<Bytes> exchange(const std::vector<Bytes>& to) const;
    /// Sends to some ranks, and fills `from[k].bytes` by what those have sent: so much as there is room for.
    struct Parcel {
        int rank;
        Bytes bytes;
    };
    void exchange(std::span<const Parcel> to, std::span<Parcel> from) const;
    /// The text of that rank.
    std::string broadcast_from(int rank, std::string text) const;

    /// Runs what may fail on some ranks only, as a full disk does; then all throw what the first of these has thrown.
    void together(const std::function<void()>& part) const;
    /// Runs it on the first rank, and as `together` says.
    void on_first(const std::function<void()>& part) const {
        together([&] {
            if (first()) part();
        });
    }

    /// The program's end, with this rank's exit status: waits for the others as long as it takes them to get there.
    /// Gives the largest status of all. Where they do not come, because this rank alone has failed, all are ended and
    /// the rank's `failure` is shown.
    int end(int status, const std::string& failure) const;

    /// What this rank has sent since the start.
    struct Traffic {
        std::int64_t collectives = 0, exchanges = 0, messages = 0, bytes = 0;
    };
    const Traffic& traffic() const { return traffic_; }

private:
    Comm() = default;
    static Comm started();
    void combine_bytes(void* values, std::size_t each, std::size_t count,
                       const std::function<void(void*, const void*)>& into) const;
    Bytes gathered_bytes(std::span<const std::byte> own) const;

    int rank_ = 0, size_ = 1, rank_here_ = 0, size_here_ = 1;
    mutable Traffic traffic_;
};

}  // namespace tw
