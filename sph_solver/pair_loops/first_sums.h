#pragma once
#include "sph_solver/equations/continuity.h"
#include "sph_solver/equations/renormalisation.h"
#include "sph_solver/equations/shifting.h"
#include "sph_solver/equations/wall_completeness.h"
#include "sph_solver/equations/water_completeness.h"
#include "sph_solver/pair_loops/pair_loop.h"

namespace tw {
namespace TW_ISA {
namespace {

/// The sums of the first pair loop (right_hand_side.h): what the particles bring, and how the sums become results: the
/// rate of compression -div u (continuity), renormalised density gradient, Shepard sum and shifting.
struct FirstSums {
    const FirstPairLoopData& d;
    const Shifting shifting;
    const WallCompleteness wall_completeness;
    const V3<Real> u_i;
    const Real drho_i;
    Real compression{}, wall_compression{};  ///< -div u, and the walls' part of it [1/s]
    Real support{}, difference2{}, touch{};
    V3<Real> shift{};
    ScalarGradient<Real> grad_rho;
    V3<Real> n_i{}, u_slip{};  ///< of the wall near by
    Real u_n{};

    FirstSums(const FirstPairLoopData& data, const Own& i)
        : d(data),
          shifting(d.water.kernel, d.inv_W_dp),
          wall_completeness{d.water.kernel.support_length * d.inv_dp, d.inv_void},
          u_i(i.velocities(d.water.motion)),
          drho_i(i.each([&](int own) { return d.water.motion[own].drho; })) {}

    void sums(auto&& of) { of(compression, wall_compression, support, difference2, touch, shift, grad_rho); }
    void reach_walls(const Own& i) {
        n_i = i.each_vector([&](int own) {
            const PackedWallNormal& n = d.walls.normal[own];
            return V3<float>{n.x, n.y, n.z};
        });
        u_n = dot(u_i, n_i);
        u_slip = slip_velocity(u_n, n_i);
    }

protected:
    /// u_i - u_wall at dummy j.
    template <bool walls_move>
    V3<Real> slip(std::int32_t j) const {
        if constexpr (walls_move) {
            const WallVelocity& u_j = d.walls.velocity[j];
            return slip_velocity(u_n - dot(V3<float>{u_j.u, u_j.v, u_j.w}, n_i), n_i);
        } else {
            return u_slip;
        }
    }
    void scale() {
        const Kernel& kernel = d.water.kernel;
        support *= kernel.W_over_G, difference2 *= kernel.W_over_G;
    }
    /// The sums over another fluid's particles, made before.
    void add_other_fluid(const Own& i) {
        i.for_each([&](int own, int l) {
            const OtherSums& other = d.other[own];
            support[l] += other.support, compression[l] += other.compression;
            difference2[l] += other.difference2;
            shift.x[l] += other.x, shift.y[l] += other.y, shift.z[l] += other.z;
        });
    }
    void add_walls(const Own& i) {
        touch *= d.water.kernel.W_over_G;
        if (d.other) i.for_each([&](int own, int l) { touch[l] += 2.0f * d.other[own].support; });
        compression += wall_completeness.compression(wall_compression, touch);
    }
    bool some_lack_support() const { return simd::bits_below(support, d.surface_support); }
    void let_voids_close(const Own& i) {
        const Real touched =
            WaterCompleteness{d.given_back}.compression(compression, support, simd::root(dot(shift, shift)));
        i.for_each([&](int, int l) {
            if (support[l] < d.surface_support) compression[l] = touched[l];
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
    /// min(b v_i, c0 / 10) [m/s].
    Real shift_speed(const Own& i) const {
        Real speed = simd::min(Shifting::b * simd::root(difference2), Real{} + d.fastest_shift);
        // nothing else ties the number of those to their density: they would gather under the zone
        if (d.water.kind)
            i.for_each([&](int own, int l) {
                if (d.water.kind[own] == Kind::slave) speed[l] = d.fastest_shift;
            });
        return speed;
    }
    void store_results(const Own& i, const V3<Real>& grad) const {
        i.for_each([&](int own, int l) {
            PackedGradientPressure& out = d.stress[own];
            out.gx = grad.x[l], out.gy = grad.y[l], out.gz = grad.z[l];
            d.rate[own].drho = (d.water.rho0 + drho_i[l]) * compression[l];
            d.shift[own] = {shift.x[l], shift.y[l], shift.z[l], support[l]};
        });
    }
};

}  // namespace
}  // namespace TW_ISA
}  // namespace tw
