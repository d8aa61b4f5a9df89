// The pair loops across the contact of two fluids, once per variant.
#include "sph_solver/pair_loops/level_pair_views.h"

#include "sph_solver/equations/artificial_viscosity.h"
#include "sph_solver/equations/continuity.h"
#include "sph_solver/equations/level_pair.h"
#include "sph_solver/equations/pressure_gradient.h"
#include "sph_solver/equations/shifting.h"
#include "sph_solver/pair_loops/pair_loop.h"

namespace tw {
namespace TW_ISA {
namespace {

struct MeetOther {
    const MeetOtherData& d;
    const Shifting shifting;
    const Contact contact;
    const V3<Real> u_i;
    Real compression{}, support{}, difference2{};  // the first is -div u
    V3<Real> shift{};

    MeetOther(const MeetOtherData& data, const Own& i)
        : d(data),
          shifting(d.water.kernel, d.inv_W_dp),
          contact(d.water.rho0, d.other.rho0),
          u_i(i.velocities(d.water.motion)) {}

    void sums(auto&& of) { of(compression, support, difference2, shift); }
    void meet(std::int32_t j, const Met& ij) {
        support += ij.V_W();
        shifting.add(ij, shift);
        const V3<Real> u_ij = u_i - velocity(d.other.motion[j]);
        Shifting::add_difference(ij, u_ij, difference2);
        Continuity::add(ij, u_ij, compression);
    }
    void store(const Own& i) {
        support *= d.water.kernel.W_over_G, difference2 *= d.water.kernel.W_over_G;
        compression *= contact.of_own;
        i.for_each([&](int own, int l) {
            d.sums[own] = {shift.x[l], shift.y[l], shift.z[l], support[l], compression[l], difference2[l]};
        });
    }
};

struct PressOther {
    const PressOtherData& d;
    const Contact contact;
    const ArtificialViscosity<Math> artificial_viscosity;
    const V3<Real> u_i;
    const Real inv_rho;
    Real p_own;
    V3<Real> force{};

    PressOther(const PressOtherData& data, const Own& i)
        : d(data),
          contact(d.water.rho0, d.other.rho0),
          artificial_viscosity{d.viscosity},
          u_i(i.velocities(d.water.motion)),
          inv_rho(i.each([&](int own) { return d.water.place[own].volume; }) * d.water.inv_mass) {
        const Real p_i = i.each([&](int own) { return d.water.stress[own].p; });
        Real controlled = p_i;
        control_tension(d.tension_control_from, d.shift, i, controlled);
        p_own = contact.of_own * p_i + (controlled - p_i);
    }
    void sums(auto&& of) { of(force); }
    void meet(std::int32_t j, const Met& ij) {
        const V3<Real> u_ij = u_i - velocity(d.other.motion[j]);
        PressureGradient::add(
            ij, p_own + contact.of_other * d.other.stress[j].p + artificial_viscosity.pressure(ij, u_ij), force);
    }
    void store(const Own& i) const {
        i.for_each([&](int own, int l) {
            PackedRate& rate = d.rate[own];
            rate.ax += force.x[l] * inv_rho[l];
            rate.ay += force.y[l] * inv_rho[l];
            rate.az += force.z[l] * inv_rho[l];
        });
    }
};

}  // namespace

template <>
void pass(const MeetOtherData& d, const Cluster* clusters, int count) {
    run<MeetOther>(d, clusters, count);
}
template <>
void pass(const PressOtherData& d, const Cluster* clusters, int count) {
    run<PressOther>(d, clusters, count);
}

}  // namespace TW_ISA
}  // namespace tw
