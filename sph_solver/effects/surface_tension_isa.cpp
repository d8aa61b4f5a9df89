// The sweeps of surface tension, once per instruction set; equations in equations/surface_tension.h.
#include "sph_solver/backend/pair_loop.h"
#include "sph_solver/effects/passes.h"
#include "sph_solver/equations/surface_tension.h"

namespace tw {
namespace TW_ISA {

void colour_gradient(const ColourData& c, const Group* groups, int count) {
    const PassData& d = *c.water;
    const Frame frame = frame_of(d.kernel, d.quantum);
    for (int n = 0; n < count; ++n) {
        const Group& g = groups[n];
        const V3<Real> x_i = own_places(d.place, g, frame);
        V3<Real> gradC{};
        const auto add = [&](std::int32_t, const Met& ij) { ColourGradient::add(ij, gradC); };
        for_each_neighbour(d.place, d.list, g.list, g, frame, x_i, add);
        for_each_neighbour(d.wall_place, d.wall_list, g.wall_list, g, frame, x_i, add);
        for (int l = 0; l < g.size; ++l) c.normal[g.first + l] = {gradC.x[l], gradC.y[l], gradC.z[l], 0};
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
        const V3<Real> x_i = own_places(d.place, g, frame), n_i = own_velocities(c.normal, g);
        VectorGradient<Real> grad_n;
        for_each_neighbour(d.place, d.list, g.list, g, frame, x_i, [&](std::int32_t j, const Met& ij) {
            if (c.normal[j].drho == 0) return;
            grad_n.add(ij, velocity(c.normal[j]) - n_i);
        });
        grad_n.solve(d.kernel.support_length, d.two_dimensional);
        const Real kappa = curvature(grad_n);
        for (int l = 0; l < g.size; ++l) c.curvature[g.first + l] = c.normal[g.first + l].drho > 0 ? kappa[l] : 0.0f;
    }
}

}  // namespace TW_ISA
}  // namespace tw
