// The sweep that carries fields from one level of particle size to another, once per instruction set.
#include "sph_solver/backend/pair_loop.h"
#include "sph_solver/equations/first_order.h"
#include "sph_solver/levels/interpolate.h"

namespace tw {
namespace TW_ISA {

void interpolate(const InterpolateData& d, const Group* groups, int count) {
    const Frame frame = frame_of(d.kernel, d.quantum);
    const float to_m = d.kernel.support_length;
    const V3<float> slope = to_m * V3<float>{d.gx, d.gy, d.gz};
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x = own_places(d.at, g, frame);
        FirstOrder<Real> fit;
        typename FirstOrder<Real>::Field u, v, w, drho, rate;
        Real known{};
        for_each_neighbour(d.place, d.list, g.list, g, frame, x, [&](std::int32_t j, const Met& ij) {
            const Real V_W = ij.V_W();
            const VelocityDensityRecord& r_j = d.motion[j];
            fit.add(ij.r_ji, V_W);
            u.add(ij.r_ji, V_W, r_j.u);
            v.add(ij.r_ji, V_W, r_j.v);
            w.add(ij.r_ji, V_W, r_j.w);
            drho.add(ij.r_ji, V_W, r_j.drho - dot(slope, ij.r_ji));
            if (d.rate) rate.add(ij.r_ji, V_W, d.rate[j]);
            if (d.known_support) known += d.known_support[j] * V_W;
        });
        fit.solve(d.two_dimensional);
        const Real at_u = fit.value(u), at_v = fit.value(v), at_w = fit.value(w), at_drho = fit.value(drho),
                   at_rate = fit.value(rate);
        const Real support = fit.S * d.kernel.W_over_G, mean = fit.mean(known);
        for (int l = 0; l < g.size; ++l) {
            d.value[g.first + l] = {at_u[l], at_v[l], at_w[l], at_drho[l]};
            d.support[g.first + l] = support[l];
            if (d.known_support) d.mean_support[g.first + l] = mean[l];
            if (d.rate) d.compression[g.first + l] = at_rate[l];
        }
    }
}

}  // namespace TW_ISA
}  // namespace tw
