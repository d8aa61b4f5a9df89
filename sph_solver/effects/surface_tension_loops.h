#pragma once
#include <cmath>
#include <cstddef>

#include "sph_solver/equations/surface_tension.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// grad C becomes the normal, and its length is noted.
struct NormalOfSurface {
    PackedVelocityDensity* normal;
    float* length;  ///< |grad C| [1/m]
    double h;       ///< smoothing length [m]

    void operator()(std::size_t i) const {
        PackedVelocityDensity& r = normal[i];
        length[i] = std::sqrt(r.u * r.u + r.v * r.v + r.w * r.w);
        const bool counts = static_cast<double>(length[i]) * h > smallest_colour_gradient;
        const float inv = counts ? 1 / length[i] : 0;
        r = {r.u * inv, r.v * inv, r.w * inv, counts ? 1.0f : 0.0f};
    }
};

/// Adds the surface's force to the rates.
struct PullAtSurface {
    SurfaceForce force;
    const PackedPlace* place;
    const PackedVelocityDensity* normal;
    const float *curvature, *length;  ///< [1/m], |grad C| [1/m]
    PackedRate* rate;

    void operator()(std::size_t i) const {
        const float f = force.along_normal(place[i].volume, curvature[i], length[i]);
        PackedRate& r = rate[i];
        r.ax += f * normal[i].u;
        r.ay += f * normal[i].v;
        r.az += f * normal[i].w;
    }
};

}  // namespace tw
