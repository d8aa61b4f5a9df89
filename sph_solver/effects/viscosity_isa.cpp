// The pair loops of viscosity and subgrid turbulence, once per variant.
#include "sph_solver/effects/viscosity.h"
#include "sph_solver/equations/smagorinsky.h"
#include "sph_solver/equations/viscosity.h"
#include "sph_solver/equations/wall_pressure.h"
#include "sph_solver/pair_loops/pair_loop.h"

namespace tw {
namespace TW_ISA {
namespace {

struct WaterVelocity {
    const WaterVelocityData& d;
    V3<Real> u{};
    Real support{};

    WaterVelocity(const WaterVelocityData& data, const Own&) : d(data) {}
    void sums(auto&& of) { of(u, support); }
    void meet(std::int32_t f, const Met& ij) {
        const Real V_W = ij.V_W();
        support += V_W;
        u += V_W * velocity(d.water.motion[f]);
    }
    void store(const Own& i) {
        const float W_over_G = d.water.kernel.W_over_G;
        support *= W_over_G;
        const Real inv = support > WallPressure::least_support ? W_over_G / support : Real{};
        i.for_each([&](int own, int l) {
            d.velocity[own] = {u.x[l] * inv[l], u.y[l] * inv[l], u.z[l] * inv[l], support[l]};
        });
    }
};

struct Friction {
    const ViscousForceData& d;
    const V3<Real> u_i;
    const Real mu_i, inv_rho;
    V3<Real> inner{}, a_wall{};

    Friction(const ViscousForceData& data, const Own& i)
        : d(data),
          u_i(i.velocities(d.water.motion)),
          mu_i(i.each([&](int own) { return d.mu[own]; })),
          inv_rho(i.each([&](int own) { return d.water.place[own].volume; }) *
                  (d.water.inv_mass * d.water.kernel.inv_support)) {}

    void sums(auto&& of) { of(inner); }
    ListRef list(const Cluster& g) const { return list_for_rates(d.water, g); }
    void meet(std::int32_t j, const Met& ij) {
        ViscousForce::add(ij, mu_i + d.mu[j], velocity(d.water.motion[j]) - u_i, inner);
    }
    void meet_wall(std::int32_t j, const Met& ij, V3<Real>& force) const {
        if (d.wall_velocity[j].drho > WallPressure::least_support)
            ViscousForce::add(ij, 2.0f * mu_i, velocity(d.wall_velocity[j]) - u_i, force);
    }
    using OfBody = V3<Real>;
    V3<Real> push(const V3<Real>& force) {
        const V3<Real> a = inv_rho * force;
        a_wall += a;
        return a;
    }
    void store(const Own& i) const {
        i.for_each([&](int own, int l) {
            PackedRate& r = d.rate[own];
            r.ax += inner.x[l] * inv_rho[l] + a_wall.x[l];
            r.ay += inner.y[l] * inv_rho[l] + a_wall.y[l];
            r.az += inner.z[l] * inv_rho[l] + a_wall.z[l];
        });
    }
};

struct StrainRate {
    const StrainRateData& d;
    const V3<Real> u_i;
    VectorGradient<Real> grad_u;

    StrainRate(const StrainRateData& data, const Own& i) : d(data), u_i(i.velocities(d.water.motion)) {}
    void sums(auto&& of) { of(grad_u); }
    void meet(std::int32_t j, const Met& ij) { grad_u.add(ij, velocity(d.water.motion[j]) - u_i); }
    void store(const Own& i) {
        grad_u.solve(d.water.kernel.support_length, d.water.two_dimensional);
        const Real S = simd::sqrt(strain_rate_squared(grad_u));
        i.for_each([&](int own, int l) { d.strain[own] = S[l]; });
    }
};

}  // namespace

template <>
void pass(const WaterVelocityData& d, const Cluster* clusters, int count) {
    run<WaterVelocity>(d, clusters, count);
}
template <>
void pass(const ViscousForceData& d, const Cluster* clusters, int count) {
    run<Friction>(d, clusters, count);
}
template <>
void pass(const StrainRateData& d, const Cluster* clusters, int count) {
    run<StrainRate>(d, clusters, count);
}

}  // namespace TW_ISA
}  // namespace tw
