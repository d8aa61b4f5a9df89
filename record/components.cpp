#include "record/components.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "base/errors.h"

namespace tw {
namespace {

/// Sets that are joined; the way to the root is halved at every look.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        i = root(i), j = root(j);
        parent_[std::max(i, j)] = std::min(i, j);
    }

private:
    std::vector<std::size_t> parent_;
};

/// Elements whose sizes share an octave, in cells as wide as their longest link. An element looks for partners of its
/// own octave and of all coarser ones.
struct Octave {
    double width = 0;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells;
};

std::uint64_t key(const Vec3& place, double width, const Eigen::Vector3i& shift = Eigen::Vector3i::Zero()) {
    std::uint64_t k = 0;
    for (int c = 0; c < 3; ++c) {
        const auto index = static_cast<std::int64_t>(std::floor(place[c] / width)) + shift[c];
        k = (k << 21) | (static_cast<std::uint64_t>(index) & 0x1fffff);
    }
    return k;
}

}  // namespace

std::vector<int> components(std::span<const WaterElement> elements, double link) {
    if (!(link > 0) || !std::isfinite(link))
        throw InputError(fmt::format("link = {:g}: expected above 0, in spacings", link));
    for (const WaterElement& e : elements)
        if (!(e.size > 0) || !std::isfinite(e.size) || !e.place.allFinite() || !std::isfinite(e.volume))
            throw InputError("a particle or cell of the run is not finite, or has no size");

    std::vector<Octave> octaves;
    std::vector<int> octave_of(elements.size());
    std::unordered_map<int, std::size_t> known;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const int e = std::ilogb(elements[i].size);
        const auto [at, fresh] = known.try_emplace(e, octaves.size());
        if (fresh) octaves.emplace_back();
        Octave& o = octaves[at->second];
        o.width = std::max(o.width, link * elements[i].size);
        octave_of[i] = static_cast<int>(at->second);
    }
    for (std::size_t i = 0; i < elements.size(); ++i) {
        Octave& o = octaves[static_cast<std::size_t>(octave_of[i])];
        o.cells[key(elements[i].place, o.width)].push_back(static_cast<std::uint32_t>(i));
    }

    DisjointSets sets(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const WaterElement& a = elements[i];
        for (const Octave& o : octaves) {
            if (o.width < octaves[static_cast<std::size_t>(octave_of[i])].width) continue;
            for (int n = 0; n < 27; ++n) {
                const auto cell = o.cells.find(key(a.place, o.width, {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1}));
                if (cell == o.cells.end()) continue;
                for (const std::uint32_t j : cell->second) {
                    const double reach = link * 0.5 * (a.size + elements[j].size);
                    if ((a.place - elements[j].place).squaredNorm() <= reach * reach) sets.join(i, j);
                }
            }
        }
    }

    std::unordered_map<std::size_t, double> volume;
    for (std::size_t i = 0; i < elements.size(); ++i) volume[sets.root(i)] += elements[i].volume;
    std::vector<std::pair<std::size_t, double>> order(volume.begin(), volume.end());
    std::ranges::sort(order, [](const auto& a, const auto& b) {
        return a.second != b.second ? a.second > b.second : a.first < b.first;
    });
    std::unordered_map<std::size_t, int> number;
    for (std::size_t k = 0; k < order.size(); ++k) number[order[k].first] = static_cast<int>(k);
    std::vector<int> result(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) result[i] = number.at(sets.root(i));
    return result;
}

}  // namespace tw
