#pragma once
#include "sph_solver/pair_loops/pair_loop.h"

// How far a place is from a cluster's particles, see ClusterReach.
namespace tw {
namespace TW_ISA {
namespace {

/// Lane l's particle.
inline void note_lane(ClusterReach& r, int l, const PackedPlace& p, const Cluster& g) {
    const float x = static_cast<float>(difference(p.x, g.x)), y = static_cast<float>(difference(p.y, g.y)),
                z = static_cast<float>(difference(p.z, g.z));
    r.n[l] = x * x + y * y + z * z;
    r.a[l] = -2 * x, r.b[l] = -2 * y, r.c[l] = -2 * z;
}
inline void note_reaches(ClusterReach& r, const Cluster& g, const Reaches& reaches) {
    r.x = g.x, r.y = g.y, r.z = g.z;
    r.far2 = static_cast<float>(reaches.far * reaches.far) * 1.000002f;
    r.now2 = static_cast<float>(reaches.now * reaches.now) * 1.000002f;
    r.sure2 = static_cast<float>(reaches.sure > 0 ? reaches.sure * reaches.sure : 0);
}

/// Squared distance from the nearest of the cluster's particles of a place (x, y, z) from its centre [fixed-point
/// units^2].
inline Real distance2(const ClusterReach& g, const Real& x, const Real& y, const Real& z) {
    Real least = g.n[0] + g.a[0] * x + g.b[0] * y + g.c[0] * z;
    for (int l = 1; l < lanes; ++l) least = simd::min(least, g.n[l] + g.a[l] * x + g.b[l] * y + g.c[l] * z);
    return least + (x * x + y * y + z * z);
}

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
