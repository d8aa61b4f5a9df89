#pragma once
// The right-hand side: what is summed in an evaluation of the rates, term by term in the order of the sums, for
// processor and GPU alike. Formulas and sources: equations/, one header a term, and docs/theory.md. What the sums begin
// with and how they become results: first_sums.h, second_sums.h. `run` (pair_loop.h) calls the functions below in the
// order of this file.
//
//   1  FirstPairLoop    at (x, u):     -div u, grad rho, Shepard sum, shifting     of another fluid: level_pair_isa.cpp
//      each particle                rho += dt rho (-div u),  p = p(rho)         loops/after_first_pair_loop.h
//      effects change p             in the order of effects/registry.h          effects/: change_pressure
//   2  Extrapolate   at dummies:    pressure of the walls                       extrapolate.h
//   3  SecondPairLoop   at (x, rho):   a = du/dt, D = drho/dt by diffusion         of another fluid: level_pair_isa.cpp
//      effects add to a             each by a pair loop of its own              effects/: add_rates
//
// Level::first_pair_loop and Level::second_pair_loop (levels/level.cpp) do these one after the other.
#include "sph_solver/pair_loops/first_sums.h"
#include "sph_solver/pair_loops/second_sums.h"

namespace tw {
namespace TW_ISA {
namespace {

/// First pair loop. The velocities are those that the last pressure has produced. In this order the sums that
/// neighbours add to by several operations stay in registers (tools/check_pair_loops.py).
template <bool walls_move>
struct FirstPairLoop : FirstSums {
    using FirstSums::FirstSums;

    void meet(std::int32_t j, const Met& ij) {  // a particle in the water, or the image of one
        const PackedVelocityDensity& r_j = d.water.motion[j];
        const V3<Real> u_ij = u_i - velocity(r_j);
        Continuity::add(ij, u_ij, compression);           // continuity
        support += ij.V_W();                              // Shepard sum
        Shifting::add_difference(ij, u_ij, difference2);  // shifting: how fast
        shifting.add(ij, shift);                          // where to
        grad_rho.add(ij, r_j.drho - drho_i);              // density diffusion: its gradient
    }
    void meet_beside_wall(const Met& ij) {
        wall_completeness.add(ij, n_i, touch);
    }                                                // the same ones, of clusters near a wall
    void meet_wall(std::int32_t j, const Met& ij) {  // a dummy
        support += ij.V_W();
        shifting.add(ij, shift);
        wall_completeness.add(ij, n_i, touch);
        Continuity::add(ij, slip<walls_move>(j), wall_compression);
    }
    void store(const Own& i) {
        scale();
        if (d.other) add_other_fluid(i);
        if (i.cluster.wall_list.size > 0) add_walls(i);  // a wall compresses only water that it touches
        if (some_lack_support()) let_voids_close(i);   // at the surface water compresses only such water
        const V3<Real> grad = density_gradient(i);
        shift = shift_speed(i) * shift;
        store_results(i, grad);  // and rho (-div u)
    }
};

/// Second pair loop. Walls press, and do not rub (slip).
struct SecondPairLoop : SecondSums {
    using SecondSums::SecondSums;

    void meet(std::int32_t j, const Met& ij) {  // a particle in the water, or the image of one
        const PackedVelocityDensity& r_j = d.water.motion[j];
        const PackedGradientPressure& s_j = d.water.stress[j];
        density_diffusion.add(ij, r_j.drho - drho_i, grad_i + V3<float>{s_j.gx, s_j.gy, s_j.gz}, diffusion);
        PressureGradient::add(ij, p_i + s_j.p + artificial_viscosity.pressure(ij, u_i - velocity(r_j)), water);
    }
    void meet_at_surface(const Met& ij) { towards_surface += ij.V_gradW(); }  // those of them at the free surface
    void meet_wall(std::int32_t j, const Met& ij, OfBody& of) const {         // a dummy, body by body
        PressureGradient::add(ij, p_i + d.walls.p[j], of.force);
        of.along -= ij.FV * dot(ij.r_ji, edge_release.w);
    }
    V3<Real> push(const OfBody& of) {  // by a body, which gets the opposite
        V3<Real> a = inv_rho * of.force;
        edge_release.apply(a, 2.0f * inv_rho * p_i * of.along);
        a_wall += a;
        return a;
    }
    void store(const Own& i) const {
        Real drho = d.diffusion * diffusion;
        if (d.packing > 0 && i.cluster.wall_list.size > 0) follow_packing(i, drho);  // crowded water beside a solid
        const V3<Real> a{water.x * inv_rho + a_wall.x + d.gx,                      // water + walls + gravity
                         water.y * inv_rho + a_wall.y + d.gy,                      //
                         water.z * inv_rho + a_wall.z + d.gz};
        store_rates(i, a, drho);
        shift_along_surface(towards_surface, i, d.shift);
    }
};

}  // namespace

template <>
void pass(const FirstPairLoopData& d, const Cluster* clusters, int count) {
    if (d.walls.velocity)
        run<FirstPairLoop<true>>(d, clusters, count);
    else
        run<FirstPairLoop<false>>(d, clusters, count);
}
template <>
void pass(const SecondPairLoopData& d, const Cluster* clusters, int count) {
    run<SecondPairLoop>(d, clusters, count);
}

}  // namespace TW_ISA
}  // namespace tw
