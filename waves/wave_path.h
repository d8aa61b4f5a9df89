#pragma once
#include "wave_sum.h"

// Read by the particles' loops, on a GPU too.

namespace tw {

/// A moment of a wave in a stream that starts, and of a wave that grows to its height. Plain numbers.
struct WaveInStream {
    double time = 0;    ///< [s]
    double share = 1;   ///< of the wave's height [-]
    double stream = 0;  ///< along x [m/s]
};

/// The velocity of water at (x, z) [m/s], less `frame` along x.
struct WaterVelocity {
    double u, w = 0;
    WaterVelocity(const WaveSum& wave, const WaveInStream& now, double x, double z, double frame = 0) : u(now.stream) {
        if (now.share != 0) {
            wave_velocity(wave, x, z, now.time, u, w);
            u = now.stream + now.share * (u - wave.current);
            w *= now.share;
        }
        u -= frame;
    }
};

/// Where water at (x, z) at the moment `before` is at the moment `after`, dt later, seen from what moves with `frame`
/// along x: a step of the classical Runge-Kutta scheme.
inline void step_with_water(const WaveSum& wave, const WaveInStream& before, const WaveInStream& middle,
                            const WaveInStream& after, double dt, double frame, double& x, double& z) {
    const WaterVelocity a(wave, before, x, z, frame), b(wave, middle, x + dt / 2 * a.u, z + dt / 2 * a.w, frame),
        c(wave, middle, x + dt / 2 * b.u, z + dt / 2 * b.w, frame), d(wave, after, x + dt * c.u, z + dt * c.w, frame);
    x += dt / 6 * (a.u + 2 * b.u + 2 * c.u + d.u);
    z += dt / 6 * (a.w + 2 * b.w + 2 * c.w + d.w);
}

/// The same, seen from the scene's axes.
inline void go_with_water(const WaveSum& wave, const WaveInStream& before, const WaveInStream& middle,
                          const WaveInStream& after, double& x, double& z) {
    step_with_water(wave, before, middle, after, after.time - before.time, 0, x, z);
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
    for (int step = 0; step < steps; ++step) step_with_water(wave, now, now, now, way / V / steps, crests, x, z);
}

}  // namespace tw
