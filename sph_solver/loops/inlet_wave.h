#pragma once
#include <cstddef>

#include "sph_solver/device/kernel_of.h"
#include "sph_solver/domain/kind.h"
#include "sph_solver/loops/pack_state.h"
#include "waves/wave_path.h"

namespace tw {

/// The wave that enters with a stream, for the particles of the inlet (domain/stream.h).
struct WaveOfInlet {
    WaveSum sum;
    double bernoulli, gravity;     ///< of the wave [m2/s2], [m/s2]
    double carried;                ///< mean velocity of the water that it carries along, over the depth [m/s]
    double rho0, compressibility;  ///< [kg/m3], 1/c0^2 [s2/m2]

    /// Density deviation of water at (x, z) [kg/m3]: p/rho0 = -g z + dynamic part, in a lattice to the second order as
    /// StateEquation::deviation_of_lattice has it, p/c0^2 (1 + 2 p/(rho0 c0^2)).
    double density(double x, double z, const WaveInStream& now) const {
        double more = 0;
        if (now.share != 0) {
            double u, w;
            wave_velocity(sum, x, z, now.time, u, w);
            const double past = sum.direction * u - sum.speed;
            more = now.share * (bernoulli - (past * past + w * w) / 2);
        }
        const double k = (more - gravity * z) * compressibility;
        return rho0 * k * (1 + 2 * k);
    }
};

/// Puts a particle to (x, z), with the velocity of the water there. `was`: its density deviation where it was, by the wave.
inline void put_under_wave(const StateView& p, const WaveOfInlet& wave, const WaveInStream& now, std::size_t i,
                           double x, double z, double was) {
    p.x[i] = x, p.z[i] = z;
    const WaterVelocity here(wave.sum, now, x, z);
    p.u[i] = static_cast<float>(here.u), p.w[i] = static_cast<float>(here.w);
    p.drho[i] = static_cast<float>(static_cast<double>(p.drho[i]) + (wave.density(x, z, now) - was));
}

/// Gives the inlet's particles place, velocity and pressure of the water under the wave, after a step that has moved
/// them along their own velocities for `moved` [s].
struct CarryInlet {
    StateView p;
    const Kind* kind;
    WaveOfInlet wave;
    WaveInStream before, middle, after;
    double moved;

    void operator()(std::size_t i) const {
        if (kind[i] != Kind::inlet) return;
        double x = p.x[i] - moved * static_cast<double>(p.u[i]), z = p.z[i] - moved * static_cast<double>(p.w[i]);
        const double was = wave.density(x, z, before);
        go_with_water(wave.sum, before, middle, after, x, z);
        put_under_wave(p, wave, after, i, x, z, was);
    }
};

/// New particles of the inlet, copies of those that have entered, `buffer` [m] upstream of them: puts them on the
/// streamlines of these, as far behind as that would be without the wave.
struct EnterUnderWave {
    StateView p;
    WaveOfInlet wave;
    std::size_t first;  ///< of the new ones
    WaveInStream now;
    double buffer;

    void operator()(std::size_t k) const {
        const std::size_t i = first + k;
        double x = p.x[i] + buffer, z = p.z[i];
        const double was = wave.density(x, z, now);
        go_behind(wave.sum, now, wave.carried, buffer, x, z);
        put_under_wave(p, wave, now, i, x, z, was);
        p.v[i] = 0;
    }
};

#define TW_INLET_TASKS(task) task(tw_carry_inlet, CarryInlet) task(tw_enter_under_wave, EnterUnderWave)
TW_INLET_TASKS(TW_KERNEL_OF)

}  // namespace tw
