#pragma once
#include <cstddef>

#include "sph_solver/fields/field_list.h"
#include "sph_solver/loops/whole.h"
#include "sph_solver/neighbours/wide_place.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// From places in metres to those that the pair loops see, see FixedPoint.
struct ToFixedPoint {
    double x, y, z;    ///< origin [m]
    double per_metre;  ///< fixed-point units [1/m]
    float mass, rho0;  ///< of a particle [kg], [kg/m3]

    WidePlace wide(double px, double py, double pz) const {
        return {nearest_whole((px - x) * per_metre), nearest_whole((py - y) * per_metre),
                nearest_whole((pz - z) * per_metre)};
    }
    PackedPlace operator()(double px, double py, double pz, float drho) const {
        const WidePlace p = wide(px, py, pz);
        return {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y), static_cast<std::int32_t>(p.z),
                mass / (rho0 + drho)};
    }
};

/// The particles' state: one array for each quantity.
struct StateView {
    double *x = nullptr, *y = nullptr, *z = nullptr;                  ///< [m]
    float *u = nullptr, *v = nullptr, *w = nullptr, *drho = nullptr;  ///< [m/s], [kg/m3]
};
inline StateView state_of(const FieldsView& f) { return {f.x, f.y, f.z, f.u, f.v, f.w, f.drho}; }

/// What the pair loops read of the state.
struct PackState {
    StateView p;
    ToFixedPoint to_fixed_point;
    PackedPlace* place;
    PackedVelocityDensity* motion;

    void operator()(std::size_t i) const {
        place[i] = to_fixed_point(p.x[i], p.y[i], p.z[i], p.drho[i]);
        motion[i] = {p.u[i], p.v[i], p.w[i], p.drho[i]};
    }
};

}  // namespace tw
