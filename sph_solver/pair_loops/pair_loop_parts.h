#pragma once
// What a pair loop's loops share wherever they run. Part of pair_loop.h.
#include <type_traits>

#include "sph_solver/equations/pair.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {
namespace TW_ISA {
namespace {

/// Lengths in 2h, and volumes as G V, see Kernel.
struct Frame {
    float length;  ///< per fixed-point unit [1/(2h)]
    float volume;  ///< per m3 [1/m3]
};
inline Frame frame_of(const Kernel& kernel, float unit) { return {unit * kernel.inv_support, kernel.G}; }

/// The particle in a lane; lanes beyond the cluster's size repeat the last one.
inline int in_lane(const Cluster& g, int l) { return g.first + (l < g.size ? l : g.size - 1); }
inline V3<float> velocity(const PackedVelocityDensity& r) { return {r.u, r.v, r.w}; }

/// Which places of a block a loop visits: all live ones, or of these those at the free surface.
struct Live {
    std::uint32_t operator()(const NeighbourBlock& b) const { return b.live; }
};
struct AtSurface {
    const std::uint32_t* surface;
    std::uint32_t operator()(const NeighbourBlock& b) const {
        const std::uint32_t* word = surface + b.first / 32;
        const std::uint64_t both = word[0] | std::uint64_t{word[1]} << 32;
        return static_cast<std::uint32_t>(both >> (b.first % 32)) & b.live;
    }
};

/// Calls `f(part)` for every number of a sum of type Real that is made of such, see Pair loop::sums.
template <class Real, class Sum, class Function>
void each_part(Sum& sum, Function&& f) {
    if constexpr (std::is_same_v<Sum, Real>)
        f(sum);
    else if constexpr (requires { sum.z; })
        f(sum.x), f(sum.y), f(sum.z);
    else
        sum.sums([&](auto&... parts) { (each_part<Real>(parts, f), ...); });
}

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
