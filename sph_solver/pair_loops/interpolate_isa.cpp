// The pair loop that carries fields from one level of particle size to another, once per variant.
#include "sph_solver/pair_loops/interpolate.h"

#include "sph_solver/equations/first_order.h"
#include "sph_solver/pair_loops/pair_loop.h"

namespace tw {
namespace TW_ISA {
namespace {

struct Interpolate {
    const InterpolateData& d;
    const V3<float> slope_2h;
    FirstOrder<Real> fit;
    FirstOrder<Real>::Field u, v, w, drho, rate;
    Real known{};

    Interpolate(const InterpolateData& data, const Own&)
        : d(data), slope_2h(d.water.kernel.support_length * V3<float>{d.gx, d.gy, d.gz}) {}

    void sums(auto&& of) { of(fit, u, v, w, drho, rate, known); }
    void meet(std::int32_t j, const Met& ij) {
        const Real V_W = ij.V_W();
        const PackedVelocityDensity& r_j = d.water.motion[j];
        fit.add(ij.r_ji, V_W);
        u.add(ij.r_ji, V_W, r_j.u);
        v.add(ij.r_ji, V_W, r_j.v);
        w.add(ij.r_ji, V_W, r_j.w);
        drho.add(ij.r_ji, V_W, r_j.drho - dot(slope_2h, ij.r_ji));
        if (d.rate) rate.add(ij.r_ji, V_W, d.rate[j]);
        if (d.known_support) known += d.known_support[j] * V_W;
    }
    void store(const Own& i) {
        fit.solve(d.water.two_dimensional);
        const Real at_u = fit.value(u), at_v = fit.value(v), at_w = fit.value(w), at_drho = fit.value(drho),
                   at_rate = fit.value(rate);
        const Real support = fit.S * d.water.kernel.W_over_G, mean = fit.mean(known);
        i.for_each([&](int own, int l) {
            d.value[own] = {at_u[l], at_v[l], at_w[l], at_drho[l]};
            d.support[own] = support[l];
            if (d.known_support) d.mean_support[own] = mean[l];
            if (d.rate) d.compression[own] = at_rate[l];
        });
    }
};

}  // namespace

template <>
void pass(const InterpolateData& d, const Cluster* clusters, int count) {
    run<Interpolate>(d, clusters, count);
}

}  // namespace TW_ISA
}  // namespace tw
