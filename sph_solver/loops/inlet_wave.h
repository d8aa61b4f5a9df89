#pragma once
#include <cstddef>

#include "sph_solver/device/kernel_of.h"
#include "sph_solver/domain/kind.h"
#include "sph_solver/loops/pack_state.h"
#include "waves/wave_path.h"

namespace tw {

/// The wave that enters with a stream, for the particles of the inlet (domain/stream.h). `Wave`: a regular one, or a sum.
template <class Wave>
struct WaveOfInlet {
    Wave wave;
    double gravity;                ///< [m/s2]
    double rho0, compressibility;  ///< [kg/m3], 1/c0^2 [s2/m2]

    /// Density deviation of water at (x, z) [kg/m3]: p/rho0 = -g z + dynamic part, in a lattice to the second order as
    /// StateEquation::deviation_of_lattice has it, p/c0^2 (1 + 2 p/(rho0 c0^2)).
    double density(double x, double z, const WaveInStream& now) const {
        const double more = now.share == 0 ? 0 : now.share * added_pressure(wave, x, z, now.time),
                     k = (more - gravity * z) * compressibility;
        return rho0 * k * (1 + 2 * k);
    }
};

/// Puts a particle to (x, z), with the velocity of the water there. `was`: its density deviation where it was, by the wave.
template <class Wave>
inline void put_under_wave(const StateView& p, const WaveOfInlet<Wave>& of, const WaveInStream& now, std::size_t i,
                           double x, double z, double was) {
    p.x[i] = x, p.z[i] = z;
    const WaterVelocity here(of.wave, now, x, z);
    p.u[i] = static_cast<float>(here.u), p.w[i] = static_cast<float>(here.w);
    p.drho[i] = static_cast<float>(static_cast<double>(p.drho[i]) + (of.density(x, z, now) - was));
}

/// Gives the inlet's particles place, velocity and pressure of the water under the wave, after a step that has moved
/// them along their own velocities for `moved` [s].
template <class Wave>
struct CarryInlet {
    StateView p;
    const Kind* kind;
    WaveOfInlet<Wave> of;
    WaveInStream before, middle, after;
    double moved;

    void operator()(std::size_t i) const {
        if (kind[i] != Kind::inlet) return;
        double x = p.x[i] - moved * static_cast<double>(p.u[i]), z = p.z[i] - moved * static_cast<double>(p.w[i]);
        const double was = of.density(x, z, before);
        go_with_water(of.wave, before, middle, after, x, z);
        put_under_wave(p, of, after, i, x, z, was);
    }
};

/// New particles of the inlet, copies of those that have entered, `buffer` [m] upstream of them: puts them on the
/// lines of these, as far behind as that would be without the wave.
template <class Wave>
struct EnterUnderWave {
    StateView p;
    const float* calm_height;  ///< of a sum of waves alone
    WaveOfInlet<Wave> of;
    std::size_t first;  ///< of the new ones
    WaveInStream now;
    double buffer;

    void operator()(std::size_t k) const {
        const std::size_t i = first + k;
        double x = p.x[i] + buffer, z = p.z[i];
        const double was = of.density(x, z, now);
        go_behind_from(of.wave, i, x, z);
        put_under_wave(p, of, now, i, x, z, was);
        p.v[i] = 0;
    }

private:
    void go_behind_from(const RegularInStream& wave, std::size_t, double& x, double& z) const {
        go_behind(wave, now, buffer, x, z);
    }
    void go_behind_from(const SeaInStream& sea, std::size_t i, double& x, double& z) const {
        go_behind(sea, now, buffer, static_cast<double>(calm_height[i]), x, z);
    }
};
static_assert(sizeof(CarryInlet<SeaInStream>) <= 4096, "a device takes no more as the argument of a kernel");

#define TW_INLET_TASKS(task)                                                                                     \
    task(tw_carry_inlet, CarryInlet<RegularInStream>) task(tw_carry_inlet_of_sea, CarryInlet<SeaInStream>) task( \
        tw_enter_under_wave, EnterUnderWave<RegularInStream>) task(tw_enter_under_sea, EnterUnderWave<SeaInStream>)
TW_INLET_TASKS(TW_KERNEL_OF)

}  // namespace tw
