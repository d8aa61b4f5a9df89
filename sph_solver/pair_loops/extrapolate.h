#pragma once
#include "sph_solver/equations/renormalisation.h"
#include "sph_solver/equations/wall_pressure.h"
#include "sph_solver/pair_loops/pair_loop.h"

namespace tw {
namespace TW_ISA {
namespace {

/// g - a of the points [m/s2]: one for all of them where they are at rest.
template <class G>
V3<G> g_minus_a(const ExtrapolateData& d, const Own& i);
template <>
inline V3<float> g_minus_a(const ExtrapolateData& d, const Own&) {
    return {d.gx, d.gy, d.gz};
}
template <>
inline V3<Real> g_minus_a(const ExtrapolateData& d, const Own& i) {
    return i.each_vector([&](int own) {
        const WallAcceleration& a = d.acceleration[own];
        return V3<float>{d.gx - a.x, d.gy - a.y, d.gz - a.z};
    });
}

/// Pressure at points from the water round them, see wall_pressure.h.
template <class G>
struct Extrapolate {
    const ExtrapolateData& d;
    const V3<G> g_minus_a_2h;
    Real support{}, p{};
    FirstMoment<Real> flux;

    Extrapolate(const ExtrapolateData& data, const Own& i)
        : d(data), g_minus_a_2h(d.water.kernel.support_length * g_minus_a<G>(d, i)) {}

    void sums(auto&& of) { of(support, p, flux); }
    void meet(std::int32_t f, const Met& ij) {
        const Real V_W = ij.V_W();
        support += V_W;
        const float p_f = d.water.stress[f].p, rho_f = d.water.rho0 + d.water.motion[f].drho;
        const Real share = V_W * WallPressure::carried(ij, p_f, rho_f, g_minus_a_2h);
        p += share;
        if (d.flux) {
            const CarriedShare& m = d.carried[f];
            flux.xx += share * m.xx, flux.xy += share * m.xy, flux.xz += share * m.xz;
            flux.yy += share * m.yy, flux.yz += share * m.yz, flux.zz += share * m.zz;
        }
    }
    void store(const Own& i) {
        const float W_over_G = d.water.kernel.W_over_G;
        support *= W_over_G;
        p *= W_over_G;
        const Real inv = support > WallPressure::least_support ? 1.0f / support : Real{};
        i.for_each([&](int own, int l) {
            d.p[own] = p[l] * inv[l];
            if (d.support) d.support[own] = support[l];
            if (!d.flux) return;
            const float of_point[6] = {flux.xx[l], flux.xy[l], flux.xz[l], flux.yy[l], flux.yz[l], flux.zz[l]};
            for (int k = 0; k < 6; ++k) d.flux[6 * own + k] = W_over_G * of_point[k];
        });
    }
};

}  // namespace

template <>
void pass(const ExtrapolateData& d, const Cluster* clusters, int count) {
    if (d.acceleration)
        run<Extrapolate<Real>>(d, clusters, count);
    else
        run<Extrapolate<float>>(d, clusters, count);
}

}  // namespace TW_ISA
}  // namespace tw
