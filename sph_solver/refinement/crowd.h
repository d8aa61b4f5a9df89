#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "base/vec3.h"

namespace tw {

/// Points in cells of a size, to ask which is nearest.
class Crowd {
public:
    Crowd(double size, int dimensions) : size_(size), across_(dimensions == 3 ? 1 : 0) {}
    void add(const Vec3& x, std::size_t which) { cells_.emplace(key(cell(x)), Point{x, which}); }
    /// From now on `is_marked` holds within a size of x, and for some way beyond.
    void mark(const Vec3& x) {
        each_round(x, [&](std::uint64_t k) { marked_.insert(k); });
    }
    bool is_marked(const Vec3& x) const { return marked_.contains(key(cell(x))); }
    /// The nearest point within a size of x.
    std::optional<std::size_t> nearest(const Vec3& x) const {
        std::optional<std::size_t> found;
        double least = size_ * size_;
        each_round(x, [&](std::uint64_t k) {
            const auto [first, last] = cells_.equal_range(k);
            for (auto it = first; it != last; ++it) {
                const double d2 = (it->second.x - x).squaredNorm();
                if (d2 < least || (d2 == least && found && it->second.which < *found))
                    least = d2, found = it->second.which;
            }
        });
        return found;
    }

private:
    struct Point {
        Vec3 x;
        std::size_t which;
    };
    using Cell = std::array<std::int64_t, 3>;
    Cell cell(const Vec3& x) const {
        return {std::llround(x.x() / size_), std::llround(x.y() / size_), std::llround(x.z() / size_)};
    }
    static std::uint64_t key(const Cell& c) {
        const auto bits = [](std::int64_t k) { return static_cast<std::uint64_t>(k) & 0x1fffff; };
        return bits(c[0]) << 42 | bits(c[1]) << 21 | bits(c[2]);
    }
    template <class Function>
    void each_round(const Vec3& x, const Function& f) const {
        const Cell at = cell(x);
        for (int i = -1; i <= 1; ++i)
            for (int j = -across_; j <= across_; ++j)
                for (int k = -1; k <= 1; ++k) f(key({at[0] + i, at[1] + j, at[2] + k}));
    }
    double size_;
    int across_;
    std::unordered_multimap<std::uint64_t, Point> cells_;
    std::unordered_set<std::uint64_t> marked_;
};

}  // namespace tw
