#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sph_solver/equations/smagorinsky.h"
#include "sph_solver/equations/viscosity.h"
#include "sph_solver/loops/pack_state.h"

namespace tw {

struct SetViscosity {
    float* mu;  ///< [Pa s]
    float to;  ///< [Pa s]

    void operator()(std::size_t i) const { mu[i] = to; }
};

/// For images that move against the water.
struct CopyMotion {
    const PackedVelocityDensity* from;
    PackedVelocityDensity* to;

    void operator()(std::size_t i) const { to[i] = from[i]; }
};

/// Adds the eddy viscosity, and gives its nu_t [m2/s].
struct AddEddies {
    StateView p;
    const float* strain;           ///< |S| [1/s]
    const PackedWallNormal* wall;  ///< null: no body holds the water
    double low[3], high[3];        ///< of the tank [m]
    bool holds[3][2];              ///< its walls that hold the water, as Mirrors::holding
    double filter;                 ///< Cs dp [m]
    double rho0;
    float* mu;  ///< [Pa s]

    double operator()(std::size_t i) const {
        double length = filter;
        if (wall) length = mixing_length_at_wall(length, static_cast<double>(wall[i].distance));
        length = mixing_length_at_wall(length, from_tank(p.x[i], p.y[i], p.z[i]));
        const double nu = eddy_viscosity(length, static_cast<double>(strain[i]));
        mu[i] += static_cast<float>(rho0 * nu);
        return nu;
    }

private:
    /// Distance from the nearest wall of the tank that holds the water [m].
    double from_tank(double x, double y, double z) const {
        const double place[3] = {x, y, z};
        double distance = HUGE_VAL;
        for (int a = 0; a < 3; ++a) {
            if (holds[a][0]) distance = std::min(distance, place[a] - low[a]);
            if (holds[a][1]) distance = std::min(distance, high[a] - place[a]);
        }
        return distance;
    }
};

/// The water's velocity at the dummies becomes that of dummies that hold it, see no_slip_velocity().
struct HoldAtWalls {
    PackedVelocityDensity* velocity;
    const PackedVelocityDensity* sliding;  ///< null: no surface slides
    const WallVelocity* moving;            ///< null: all bodies are at rest

    void operator()(std::size_t k) const {
        PackedVelocityDensity& m = velocity[k];
        PackedVelocityDensity wall{0, 0, 0, 0};
        if (sliding) wall = sliding[k];
        if (moving) wall.u += moving[k].u, wall.v += moving[k].v, wall.w += moving[k].w;
        const V3<float> u_d = no_slip_velocity(V3<float>{wall.u, wall.v, wall.w}, V3<float>{m.u, m.v, m.w});
        m = {u_d.x, u_d.y, u_d.z, m.drho};
    }
};

}  // namespace tw
