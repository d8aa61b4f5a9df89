#pragma once
#include "wave_sum.h"

// Read by the particles' loops, on a GPU too.

namespace tw {

/// A moment of a wave in a stream that starts, and of a wave that grows to its height. Plain numbers.
struct WaveInStream {
    double time = 0;    ///< [s]
    double share = 1;   ///< of the wave's height [-]
    double stream = 0;  ///< along x [m/s]

    void velocity(const WaveSum& wave, double x, double z, double& u, double& w) const {
        if (share == 0) {
            u = stream, w = 0;
            return;
        }
        wave_velocity(wave, x, z, time, u, w);
        u = stream + share * (u - wave.current);
        w *= share;
    }
};

/// The velocity of water [m/s], less `frame` along x.
struct WaterVelocity {
    double u, w;
    WaterVelocity(const WaveSum& wave, const WaveInStream& now, double x, double z, double frame = 0) {
        now.velocity(wave, x, z, u, w);
        u -= frame;
    }
};

/// Where water at (x, z) at the moment `before` is at the moment `after`, by a step of the classical Runge-Kutta scheme.
inline void go_with_water(const WaveSum& wave, const WaveInStream& before, const WaveInStream& middle,
                          const WaveInStream& after, double& x, double& z) {
    const double dt = after.time - before.time;
    const WaterVelocity a(wave, before, x, z), b(wave, middle, x + dt / 2 * a.u, z + dt / 2 * a.w),
        c(wave, middle, x + dt / 2 * b.u, z + dt / 2 * b.w), d(wave, after, x + dt * c.u, z + dt * c.w);
    x += dt / 6 * (a.u + 2 * b.u + 2 * c.u + d.u);
    z += dt / 6 * (a.w + 2 * b.w + 2 * c.w + d.w);
}

/// From water at (x, z) to that on the same streamline, seen from the crests, that would be `way` behind it without the
/// wave. Seen so the flow is steady, and the area between two streamlines is their difference of psi times the time that
/// water takes from one end to the other. So particles of one size on streamlines between which as much water flows
/// follow one another in equal times, way / V, with V the mean flow over the depth seen from the crests. `carried`: mean
/// velocity of the water that the whole wave carries along, over the depth [m/s].
inline void go_behind(const WaveSum& wave, const WaveInStream& now, double carried, double way, double& x, double& z) {
    const double crests = wave.direction * wave.speed,
                 V = crests - now.stream - now.share * now.share * carried;  // what is carried grows as the energy
    constexpr int steps = 8;
    const double dt = way / V / steps;
    for (int step = 0; step < steps; ++step) {
        const WaterVelocity a(wave, now, x, z, crests), b(wave, now, x + dt / 2 * a.u, z + dt / 2 * a.w, crests),
            c(wave, now, x + dt / 2 * b.u, z + dt / 2 * b.w, crests), d(wave, now, x + dt * c.u, z + dt * c.w, crests);
        x += dt / 6 * (a.u + 2 * b.u + 2 * c.u + d.u);
        z += dt / 6 * (a.w + 2 * b.w + 2 * c.w + d.w);
    }
}

}  // namespace tw
