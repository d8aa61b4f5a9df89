// The sweeps of surface tension, once per instruction set; equations in surface_tension.h.
#include "sph_solver/core/pair_loop.h"
#include "sph_solver/effects/passes.h"

namespace tw {
namespace TW_ISA {

void colour_gradient(const ColourData& c, const Group* groups, int count) {
    const PassData& d = *c.water;
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, d.quantum);
        V3<F> sum{F{}, F{}, F{}};
        const auto add = [&](std::int32_t, const float* xyz) {
            const V3<F> r{xyz[0] - a.x, xyz[1] - a.y, xyz[2] - a.z};
            const KernelShape k = shape(r, d.kernel.inv_h);
            const F FV = (d.kernel.five_sigma * xyz[3]) * (k.t * k.t) * k.t;
            sum.x += FV * r.x, sum.y += FV * r.y, sum.z += FV * r.z;
        };
        for_each_neighbour(d.place, g.list, g.list_size, g, d.quantum, add);
        for_each_neighbour(d.wall_place, g.wall_list, g.wall_size, g, d.quantum, add);
        for (int l = 0; l < g.size; ++l) c.normal[g.first + l] = {sum.x[l], sum.y[l], sum.z[l], 0};
    }
}

void surface_curvature(const ColourData& c, const Group* groups, int count) {
    const PassData& d = *c.water;
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        bool any = false;
        for (int l = 0; l < g.size; ++l) any |= c.normal[g.first + l].drho > 0;
        if (!any) {
            for (int l = 0; l < g.size; ++l) c.curvature[g.first + l] = 0;
            continue;
        }
        const Lanes a = load_places(d.place, g, d.quantum);
        V3<F> ni{};
        for (int l = 0; l < lanes; ++l) {
            const MotionRecord& r = c.normal[g.first + (l < g.size ? l : g.size - 1)];
            ni.x[l] = r.u, ni.y[l] = r.v, ni.z[l] = r.w;
        }
        F m[6] = {};
        V3<F> gx{F{}, F{}, F{}}, gy = gx, gz = gx;
        const auto add = [](V3<F>& b, const F& jump, const V3<F>& f) {
            b.x += jump * f.x, b.y += jump * f.y, b.z += jump * f.z;
        };
        for_each_neighbour(d.place, g.list, g.list_size, g, d.quantum, [&](std::int32_t j, const float* xyz) {
            const MotionRecord& nj = c.normal[j];
            if (nj.drho == 0) return;
            const V3<F> r{xyz[0] - a.x, xyz[1] - a.y, xyz[2] - a.z};
            const KernelShape k = shape(r, d.kernel.inv_h);
            const F FV = (d.kernel.five_sigma * xyz[3]) * (k.t * k.t) * k.t;
            const V3<F> f{FV * r.x, FV * r.y, FV * r.z};
            m[0] += f.x * r.x, m[1] += f.x * r.y, m[2] += f.x * r.z;
            m[3] += f.y * r.y, m[4] += f.y * r.z, m[5] += f.z * r.z;
            add(gx, nj.u - ni.x, f), add(gy, nj.v - ni.y, f), add(gz, nj.w - ni.z, f);
        });
        if (d.two_dimensional) m[3] += 1.0f;
        const F div = solve_symmetric(m, gx).x + solve_symmetric(m, gy).y + solve_symmetric(m, gz).z;
        for (int l = 0; l < g.size; ++l) c.curvature[g.first + l] = c.normal[g.first + l].drho > 0 ? -div[l] : 0.0f;
    }
}

}  // namespace TW_ISA
}  // namespace tw
