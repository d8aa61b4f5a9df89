// The sweeps of surface tension, once per instruction set; equations in surface_tension.h.
#include "sph_solver/backend/pair_loop.h"
#include "sph_solver/effects/passes.h"

namespace tw {
namespace TW_ISA {

void colour_gradient(const ColourData& c, const Group* groups, int count) {
    const PassData& d = *c.water;
    const Frame frame = frame_of(d.kernel, d.quantum);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const Lanes a = load_places(d.place, g, frame);
        V3<F> sum{F{}, F{}, F{}};
        const auto add = [&](std::int32_t, const Met& ij) {
            const V3<F> f = ij.gradient();
            sum.x += f.x, sum.y += f.y, sum.z += f.z;
        };
        for_each_neighbour(d.place, d.list, g.list, g, frame, a, add);
        for_each_neighbour(d.wall_place, d.wall_list, g.wall_list, g, frame, a, add);
        for (int l = 0; l < g.size; ++l) c.normal[g.first + l] = {sum.x[l], sum.y[l], sum.z[l], 0};
    }
}

void surface_curvature(const ColourData& c, const Group* groups, int count) {
    const PassData& d = *c.water;
    const Frame frame = frame_of(d.kernel, d.quantum);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        bool any = false;
        for (int l = 0; l < g.size; ++l) any |= c.normal[g.first + l].drho > 0;
        if (!any) {
            for (int l = 0; l < g.size; ++l) c.curvature[g.first + l] = 0;
            continue;
        }
        const Lanes a = load_places(d.place, g, frame);
        V3<F> ni{};
        for (int l = 0; l < lanes; ++l) {
            const VelocityDensityRecord& r = c.normal[g.first + (l < g.size ? l : g.size - 1)];
            ni.x[l] = r.u, ni.y[l] = r.v, ni.z[l] = r.w;
        }
        VectorGradient gradient;
        for_each_neighbour(d.place, d.list, g.list, g, frame, a, [&](std::int32_t j, const Met& ij) {
            const VelocityDensityRecord& nj = c.normal[j];
            if (nj.drho == 0) return;
            gradient.add(ij, V3<F>{nj.u - ni.x, nj.v - ni.y, nj.w - ni.z});
        });
        gradient.solve(d.kernel.support_length, d.two_dimensional);
        const F div = gradient.u.x + gradient.v.y + gradient.w.z;
        for (int l = 0; l < g.size; ++l) c.curvature[g.first + l] = c.normal[g.first + l].drho > 0 ? -div[l] : 0.0f;
    }
}

}  // namespace TW_ISA
}  // namespace tw
