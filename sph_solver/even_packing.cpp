#include "sph_solver/even_packing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

#include "sph_solver/equations/kernel.h"

namespace tw {
namespace {

/// Places by cubes of the kernel's support.
class Near {
public:
    Near(std::span<const Vec3> places, double support, bool flat) : support_(support), flat_(flat) {
        for (std::size_t i = 0; i < places.size(); ++i) cubes_[key(cube_of(places[i]))].push_back(i);
    }
    template <class Act>
    void each(const Vec3& x, const Act& act) const {
        const Cube own = cube_of(x);
        const int beside = flat_ ? 0 : 1;
        for (int i = -1; i <= 1; ++i)
            for (int j = -beside; j <= beside; ++j)
                for (int k = -1; k <= 1; ++k) {
                    const auto found = cubes_.find(key({own[0] + i, own[1] + j, own[2] + k}));
                    if (found == cubes_.end()) continue;
                    for (const std::size_t n : found->second) act(n);
                }
    }

private:
    using Cube = std::array<std::int64_t, 3>;
    Cube cube_of(const Vec3& x) const {
        const auto at = [&](double y) { return static_cast<std::int64_t>(std::floor(y / support_)); };
        return {at(x.x()), flat_ ? 0 : at(x.y()), at(x.z())};
    }
    static std::int64_t key(const Cube& c) {
        return (c[0] & 0x1fffff) << 42 | (c[1] & 0x1fffff) << 21 | (c[2] & 0x1fffff);
    }
    double support_;
    bool flat_;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> cubes_;
};

/// Blocks of small cubes, of which each is asked for once however many particles are near it.
class Blocks {
public:
    static constexpr int cubes = 8;  ///< along an edge
    Blocks(std::span<const Vec3> places, std::span<const char> of, const EvenPacking& p)
        : edge_(0.5 * p.dp), flat_(p.dimensions == 2) {
        const auto beside = static_cast<int>(std::ceil((2 * p.h + p.dp) / (cubes * edge_)));
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!of[i]) continue;
            const Block own = block_of(places[i]);
            for (int a = -beside; a <= beside; ++a)
                for (int b = flat_ ? 0 : -beside; b <= (flat_ ? 0 : beside); ++b)
                    for (int c = -beside; c <= beside; ++c) near_.insert({own[0] + a, own[1] + b, own[2] + c});
        }
    }
    bool contains(const Vec3& x) const { return near_.contains(block_of(x)); }
    template <class Act>
    void each_cube(const Act& act) const {
        for (const Block& block : near_)
            for (int i = 0; i < cubes; ++i)
                for (int j = 0; j < (flat_ ? 1 : cubes); ++j)
                    for (int k = 0; k < cubes; ++k)
                        act(Vec3((block[0] * cubes + i + 0.5) * edge_, flat_ ? 0 : (block[1] * cubes + j + 0.5) * edge_,
                                 (block[2] * cubes + k + 0.5) * edge_));
    }
    double edge() const { return edge_; }

private:
    using Block = std::array<int, 3>;
    Block block_of(const Vec3& x) const {
        const auto at = [&](double y) { return static_cast<int>(std::floor(y / (cubes * edge_))); };
        return {at(x.x()), flat_ ? 0 : at(x.y()), at(x.z())};
    }
    double edge_;
    bool flat_;
    std::set<Block> near_;
};

/// What is near the particles asked for: the small cubes that are filled at least in part, with their volumes, which
/// stand for the integral (half a spacing wide; the kernel is so smooth that no narrower ones are needed), and
/// particles.
struct PackedNear {
    std::vector<Vec3> middles, places;
    std::vector<double> volumes;
    std::vector<std::size_t> of;   ///< which of the places were asked for
    std::vector<std::size_t> who;  ///< they are among all

    PackedNear(std::span<const Vec3> all, std::span<const char> asked, const EvenPacking& p,
               const FilledShare& filled) {
        const Blocks blocks(all, asked, p);
        const double edge = blocks.edge(), volume = p.dimensions == 2 ? edge * edge : edge * edge * edge;
        blocks.each_cube([&](const Vec3& middle) {
            if (const double share = filled(middle, edge); share > 0)
                middles.push_back(middle), volumes.push_back(share * volume);
        });
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!blocks.contains(all[i])) continue;
            if (asked[i]) of.push_back(places.size()), who.push_back(i);
            places.push_back(all[i]);
        }
    }
};

}  // namespace

FilledShare water_in(std::span<const Box> boxes, std::span<const SurfaceQuery> solids, int dimensions) {
    return [=](const Vec3& middle, double edge) {
        double sum = 0;
        for (const Box& box : boxes) {
            double share = 1;
            for (int a = 0; a < 3; ++a) {
                if (a == 1 && dimensions == 2) continue;
                const double common =
                    std::min(box.max[a], middle[a] + edge / 2) - std::max(box.min[a], middle[a] - edge / 2);
                share *= std::max(0.0, common / edge);
            }
            sum += share;
        }
        sum = std::min(1.0, sum);
        for (const SurfaceQuery& solid : solids)
            if (sum > 0) sum *= std::clamp(0.5 + solid.nearest(middle, edge).distance / edge, 0.0, 1.0);
        return sum;
    };
}

int even_out(std::vector<Vec3>& places, std::span<const char> moves, const EvenPacking& p, const FilledShare& filled) {
    constexpr int most = 50;
    constexpr double still = 5e-4, longest = 0.1;  // spacings a time
    const bool flat = p.dimensions == 2;
    const Kernel kernel(p.h, p.dimensions);
    PackedNear near(places, moves, p, filled);
    const Near parts(near.middles, 2 * p.h, flat);
    const auto gradient = [&](const Vec3& r) -> Vec3 { return -kernel.F(r.norm()) * r; };
    std::vector<Vec3> step(near.of.size());
    int times = 0;
    for (double furthest = 1; times < most && furthest > still; ++times) {
        const Near others(near.places, 2 * p.h, flat);
#pragma omp parallel for schedule(static)
        for (std::size_t n = 0; n < step.size(); ++n) {
            const Vec3& x = near.places[near.of[n]];
            Vec3 push = Vec3::Zero();
            others.each(x, [&](std::size_t j) { push += p.volume * gradient(x - near.places[j]); });
            parts.each(x, [&](std::size_t j) { push -= near.volumes[j] * gradient(x - near.middles[j]); });
            step[n] = -0.5 * p.h * p.h * push;
            if (flat) step[n].y() = 0;
            if (const double far = step[n].norm(); far > longest * p.dp) step[n] *= longest * p.dp / far;
        }
        furthest = 0;
        for (std::size_t n = 0; n < step.size(); ++n)
            near.places[near.of[n]] += step[n], furthest = std::max(furthest, step[n].norm() / p.dp);
    }
    for (std::size_t n = 0; n < near.of.size(); ++n) places[near.who[n]] = near.places[near.of[n]];
    return times;
}

Unevenness unevenness(std::span<const Vec3> places, std::span<const char> of, const EvenPacking& p,
                      const FilledShare& filled) {
    const Kernel kernel(p.h, p.dimensions);
    const PackedNear near(places, of, p, filled);
    const Near others(near.places, 2 * p.h, p.dimensions == 2), parts(near.middles, 2 * p.h, p.dimensions == 2);
    Unevenness u;
    for (const std::size_t i : near.of) {
        const Vec3& x = near.places[i];
        double off = 0;
        others.each(x, [&](std::size_t j) { off += p.volume * kernel.W((x - near.places[j]).norm()); });
        parts.each(x, [&](std::size_t j) { off -= near.volumes[j] * kernel.W((x - near.middles[j]).norm()); });
        u.mean += std::abs(off) / double(near.of.size()), u.most = std::max(u.most, std::abs(off));
    }
    return u;
}

}  // namespace tw
