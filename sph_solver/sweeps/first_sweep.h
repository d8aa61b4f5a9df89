#pragma once
#include "sph_solver/equations/continuity.h"
#include "sph_solver/equations/renormalisation.h"
#include "sph_solver/equations/shifting.h"
#include "sph_solver/equations/wall_touch.h"
#include "sph_solver/equations/water_touch.h"
#include "sph_solver/sweeps/sweep.h"

namespace tw {
namespace TW_ISA {
namespace {

/// First sweep of a step: -div u (continuity), and with it what the second sweep needs of the
/// neighbourhood: renormalised density gradient, kernel support and the shifting sum.
template <bool walls_move>
struct FirstSweep {
    const FirstSweepData& d;
    const Shifting shifting;
    const WallTouch wall_touch;
    const V3<Real> u_i;
    const Real drho_i;
    Real divergence{}, wall_divergence{}, support{}, difference2{}, touch{};  // the first two are -div u
    V3<Real> shift{};
    ScalarGradient<Real> grad_rho;
    V3<Real> n_i{}, u_slip{};  // of the wall near by
    Real u_n{};

    FirstSweep(const FirstSweepData& data, const Own& i)
        : d(data),
          shifting(d.water.kernel, d.inv_W_dp),
          wall_touch{d.water.kernel.support_length * d.inv_dp, d.inv_void},
          u_i(i.velocities(d.water.motion)),
          drho_i(i.each([&](int own) { return d.water.motion[own].drho; })) {}

    void sums(auto&& of) { of(divergence, wall_divergence, support, difference2, touch, shift, grad_rho); }
    void meet(std::int32_t j, const Met& ij) {
        const VelocityDensityRecord& r_j = d.water.motion[j];
        support += ij.V_W();
        shifting.add(ij, shift);
        const V3<Real> u_ij = u_i - velocity(r_j);
        Shifting::add_difference(ij, u_ij, difference2);
        Continuity::add(ij, u_ij, divergence);
        grad_rho.add(ij, r_j.drho - drho_i);
    }
    void reach_walls(const Own& i) {
        n_i = i.each_vector([&](int own) {
            const WallNormalRecord& n = d.walls.normal[own];
            return V3<float>{n.x, n.y, n.z};
        });
        u_n = dot(u_i, n_i);
        u_slip = slip_velocity(u_n, n_i);
    }
    void meet_beside_wall(const Met& ij) { wall_touch.add(ij, n_i, touch); }
    void meet_wall(std::int32_t j, const Met& ij) {
        support += ij.V_W();
        shifting.add(ij, shift);
        wall_touch.add(ij, n_i, touch);
        if constexpr (walls_move) {
            const WallVelocity& u_j = d.walls.velocity[j];
            Continuity::add(ij, slip_velocity(u_n - dot(V3<float>{u_j.u, u_j.v, u_j.w}, n_i), n_i), wall_divergence);
        } else {
            Continuity::add(ij, u_slip, wall_divergence);
        }
    }
    void store(const Own& i) {
        const Kernel& kernel = d.water.kernel;
        support *= kernel.W_over_G, difference2 *= kernel.W_over_G;
        if (d.other) add_other(i);
        if (i.group.wall_list.size > 0) {
            touch *= kernel.W_over_G;
            if (d.other) i.for_each([&](int own, int l) { touch[l] += 2.0f * d.other[own].support; });
            divergence += wall_touch.compression(wall_divergence, touch);
        }
        if (simd::bits_below(support, d.surface_support)) {
            const Real touched =
                WaterTouch{d.given_back}.compression(divergence, support, simd::root(dot(shift, shift)));
            i.for_each([&](int, int l) {
                if (support[l] < d.surface_support) divergence[l] = touched[l];
            });
        }
        const V3<Real> grad = density_gradient(i);
        Real shift_speed = simd::min(Shifting::b * simd::root(difference2), Real{} + d.fastest_shift);
        // nothing else ties the number of those to their density: they would gather under the zone
        if (d.water.kind)
            i.for_each([&](int own, int l) {
                if (d.water.kind[own] == Kind::carried) shift_speed[l] = d.fastest_shift;
            });
        shift = shift_speed * shift;
        i.for_each([&](int own, int l) {
            GradientPressureRecord& out = d.stress[own];
            out.gx = grad.x[l], out.gy = grad.y[l], out.gz = grad.z[l];
            d.rate[own].drho = (d.water.rho0 + drho_i[l]) * divergence[l];
            d.shift[own] = {shift.x[l], shift.y[l], shift.z[l], support[l]};
        });
    }

private:
    /// The sums over the other phase, made before.
    void add_other(const Own& i) {
        i.for_each([&](int own, int l) {
            const OtherSums& other = d.other[own];
            support[l] += other.support, divergence[l] += other.divergence;
            difference2[l] += other.difference2;
            shift.x[l] += other.x, shift.y[l] += other.y, shift.z[l] += other.z;
        });
    }
    V3<Real> density_gradient(const Own& i) {
        FirstMoment<Real>& m = grad_rho.moment;
        m.scale(d.water.kernel.support_length);
        if (d.carried)
            i.for_each(
                [&](int own, int l) { d.carried[own] = {m.xx[l], m.xy[l], m.xz[l], m.yy[l], m.yz[l], m.zz[l]}; });
        if (d.water.two_dimensional) m.fill_second_axis();
        return m.solve(grad_rho.sum);
    }
};

}  // namespace

template <>
void pass(const FirstSweepData& d, const Group* groups, int count) {
    if (d.walls.velocity)
        run<FirstSweep<true>>(d, groups, count);
    else
        run<FirstSweep<false>>(d, groups, count);
}

}  // namespace TW_ISA
}  // namespace tw
