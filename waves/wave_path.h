#pragma once
#include "sea_in_stream.h"
#include "wave_sum.h"

// Read by the particles' loops, on a GPU too.

namespace tw {

/// A moment of a wave in a stream that starts, and of a wave that grows to its height. Plain numbers.
struct WaveInStream {
    double time = 0;    ///< [s]
    double share = 1;   ///< of the wave's height [-]
    double stream = 0;  ///< along x [m/s]
};

/// A regular wave that a steady stream along +x carries.
struct RegularInStream {
    WaveSum sum = {};
    double bernoulli = 0;  ///< of the wave [m2/s2]
    double carried = 0;    ///< mean velocity of the water that it carries along, over the depth [m/s]
};

/// u and w at (x, z, t) that the wave adds to the stream [m/s].
inline void added_velocity(const RegularInStream& wave, double x, double z, double t, double& u, double& w) {
    wave_velocity(wave.sum, x, z, t, u, w);
    u -= wave.sum.current;
}
inline void added_velocity(const SeaInStream& sea, double x, double z, double t, double& u, double& w) {
    sea_sums<0>(sea, x, z, t, u, w);
}

/// p/rho there without the hydrostatic pressure below still water [m2/s2]: of a regular wave by Bernoulli's equation, of
/// a sum to first order.
inline double added_pressure(const RegularInStream& wave, double x, double z, double t) {
    double u, w;
    wave_velocity(wave.sum, x, z, t, u, w);
    const double past = wave.sum.direction * u - wave.sum.speed;
    return wave.bernoulli - (past * past + w * w) / 2;
}
inline double added_pressure(const SeaInStream& sea, double x, double z, double t) {
    double p, other;
    sea_sums<1>(sea, x, z, t, p, other);
    return p;
}

/// The velocity of water at (x, z) [m/s], less `frame` along x.
struct WaterVelocity {
    double u, w = 0;
    template <class Wave>
    WaterVelocity(const Wave& wave, const WaveInStream& now, double x, double z, double frame = 0) : u(now.stream) {
        if (now.share != 0) {
            double more;
            added_velocity(wave, x, z, now.time, more, w);
            u = now.stream + now.share * more;
            w *= now.share;
        }
        u -= frame;
    }
};

/// Where water at (x, z) at the moment `before` is at the moment `after`, dt later, seen from what moves with `frame`
/// along x: a step of the classical Runge-Kutta scheme.
template <class Wave>
inline void step_with_water(const Wave& wave, const WaveInStream& before, const WaveInStream& middle,
                            const WaveInStream& after, double dt, double frame, double& x, double& z) {
    const WaterVelocity a(wave, before, x, z, frame), b(wave, middle, x + dt / 2 * a.u, z + dt / 2 * a.w, frame),
        c(wave, middle, x + dt / 2 * b.u, z + dt / 2 * b.w, frame), d(wave, after, x + dt * c.u, z + dt * c.w, frame);
    x += dt / 6 * (a.u + 2 * b.u + 2 * c.u + d.u);
    z += dt / 6 * (a.w + 2 * b.w + 2 * c.w + d.w);
}

/// The same, seen from the scene's axes.
template <class Wave>
inline void go_with_water(const Wave& wave, const WaveInStream& before, const WaveInStream& middle,
                          const WaveInStream& after, double& x, double& z) {
    step_with_water(wave, before, middle, after, after.time - before.time, 0, x, z);
}

/// From water at (x, z) to that on the same streamline, seen from the crests, that would be `way` behind it without the
/// wave. Seen so the flow is steady, and the area between two streamlines is their difference of psi times the time that
/// water takes from one end to the other. So particles of one size on streamlines between which as much water flows
/// follow one another in equal times, way / V, with V the mean flow over the depth seen from the crests.
inline void go_behind(const RegularInStream& wave, const WaveInStream& now, double way, double& x, double& z) {
    const double crests = wave.sum.direction * wave.sum.speed,
                 V = crests - now.stream - now.share * now.share * wave.carried;  // what is carried grows as the energy
    constexpr int steps = 8;
    for (int step = 0; step < steps; ++step) step_with_water(wave, now, now, now, way / V / steps, crests, x, z);
}

/// The same under a sum of waves, which is steady in no frame. To first order water that without waves is at (A, Z) lies
/// on the line of
///
///   (Z + d) / s = z + d - sum_n psi_n / C_n,   dx/dA = s (1 - sum_n u_n / C_n),   s = 1 + sum_n carried_n / C_n
///
/// at its moment, psi_n the stream function of component n. Between lines at equal distances in Z and points at equal
/// distances in A areas are equal, exactly; by s the mean level is that of calm water. Water stays on its line but for
/// terms of second order without a mean; of one wave the lines are the streamlines above. `calm`: Z [m].
inline void go_behind(const SeaInStream& sea, const WaveInStream& now, double way, double calm, double& x, double& z) {
    if (now.share == 0) {
        x -= way;
        return;
    }
    const double share = now.share, s = 1 + share * share * sea.carried;
    struct Slope {
        double along, up;
        Slope(const SeaInStream& of, double t, double part, double px, double pz) {
            sea_sums<-1>(of, px, pz, t, along, up);
            along = 1 - part * along, up *= -part;
        }
    };
    constexpr int steps = 8;
    const double h = -s * way / steps;
    for (int step = 0; step < steps; ++step) {
        const Slope a(sea, now.time, share, x, z), b(sea, now.time, share, x + h / 2 * a.along, z + h / 2 * a.up),
            c(sea, now.time, share, x + h / 2 * b.along, z + h / 2 * b.up),
            d(sea, now.time, share, x + h * c.along, z + h * c.up);
        x += h / 6 * (a.along + 2 * b.along + 2 * c.along + d.along);
        z += h / 6 * (a.up + 2 * b.up + 2 * c.up + d.up);
    }
    for (int step = 0; step < 3; ++step) {  // back to its line, from which the water has gone a little: Newton's steps
        double lifted, per_z;
        sea_lift(sea, x, z, now.time, lifted, per_z);
        z -= (z + sea.depth - share * lifted - (calm + sea.depth) / s) / (1 - share * per_z);
    }
}

}  // namespace tw
