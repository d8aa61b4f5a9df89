#pragma once
#include "sph_solver/equations/artificial_viscosity.h"
#include "sph_solver/equations/density_diffusion.h"
#include "sph_solver/equations/edge_release.h"
#include "sph_solver/equations/packing.h"
#include "sph_solver/equations/pressure_gradient.h"
#include "sph_solver/equations/shifting.h"
#include "sph_solver/pair_loops/pair_loop.h"

namespace tw {
namespace TW_ISA {
namespace {

TW_ALONE void shift_along_surface(const V3<Real>& N, const Own& own, PackedShiftSupport* shift) {
    const Real N2 = dot(N, N);
    own.for_each([&](int i, int l) {
        PackedShiftSupport& r = shift[i];
        V3<float> s{r.x, r.y, r.z};
        keep_along_surface({N.x[l], N.y[l], N.z[l]}, N2[l], s);
        r.x = s.x, r.y = s.y, r.z = s.z;
    });
}

/// The sums of the second pair loop (right_hand_side.h): what the particles bring, and how the sums become rates.
struct SecondSums {
    const SecondPairLoopData& d;
    const DensityDiffusion density_diffusion;
    const ArtificialViscosity<Math> artificial_viscosity;
    const V3<Real> u_i, grad_i;
    const Real drho_i;
    Real p_i;
    /// Of the volume that the neighbours see, not of this density: so the forces of a pair cancel to rounding.
    const Real inv_rho;
    Real diffusion{};
    V3<Real> water{}, towards_surface{}, a_wall{};
    EdgeRelease<Real> edge_release{};

    SecondSums(const SecondPairLoopData& data, const Own& i)
        : d(data),
          density_diffusion{0.5f * d.water.kernel.support_length},
          artificial_viscosity{d.viscosity},
          u_i(i.velocities(d.water.motion)),
          grad_i(i.each_vector([&](int own) {
              const PackedGradientPressure& s = d.water.stress[own];
              return V3<float>{s.gx, s.gy, s.gz};
          })),
          drho_i(i.each([&](int own) { return d.water.motion[own].drho; })),
          p_i(i.each([&](int own) { return d.water.stress[own].p; })),
          inv_rho(d.water.inv_mass * i.each([&](int own) { return d.water.place[own].volume; })) {
        control_tension(d.tension_control_from, d.shift, i, p_i);
    }

    ListRef list(const Cluster& g) const { return list_for_rates(d.water, g); }
    void sums(auto&& of) { of(diffusion, water, towards_surface); }
    /// What the dummies of one body give.
    struct OfBody {
        V3<Real> force{};
        Real along{};  ///< -sum_d grad_i W_id V_d . w_i
        void sums(auto&& of) { of(force, along); }
    };
    /// Some of the particles are before an edge, or beyond one and lack support.
    void reach_walls(const Own& i) {
        if (d.leaving == nullptr) return;
        i.for_each([&](int own, int l) {
            const PackedLeaving& way = d.leaving[own];
            const float speed2 = way.u * way.u + way.v * way.v + way.w * way.w;
            if (speed2 == 0) return;
            const bool past = way.passes <= d.since_walls;
            if (past && (d.water.surface[own / 32] >> (own % 32) & 1) == 0) return;
            const float share = released_share(d.water.stress[own].p, d.water.rho0, speed2) / speed2;
            edge_release.w.x[l] = way.u, edge_release.w.y[l] = way.v, edge_release.w.z[l] = way.w;
            edge_release.share[l] = past ? share : -share * void_beyond(d.shift[own].support);
        });
    }

protected:
    void follow_packing(const Own& i, Real& drho) const {
        const Real surface2 = dot(towards_surface, towards_surface);
        i.for_each([&](int own, int l) {
            if (d.walls.normal[own].distance < d.packing_reach)
                drho[l] += d.packing * Packing::excess(d.shift[own].support, surface2[l]);
        });
    }
    void store_rates(const Own& i, const V3<Real>& a, const Real& drho) const {
        i.for_each([&](int own, int l) { d.rate[own] = {a.x[l], a.y[l], a.z[l], drho[l]}; });
    }
};

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
