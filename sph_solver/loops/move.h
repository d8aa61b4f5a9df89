#pragma once
#include <cmath>
#include <cstddef>

#include "sph_solver/domain/kind.h"
#include "sph_solver/equations/shifting.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/pack_state.h"
#include "sph_solver/loops/stages.h"

namespace tw {

/// Largest values of some particles after a step, and which of them have these.
struct MovedExtremes {
    double speed2 = 0, acceleration2 = 0, relative2 = 0, relative2_before = 0, shift2 = 0;  ///< [m2/s2], ..., [m2]
    double low = 0, high = 0;                                                               ///< of drho [kg/m3]
    std::size_t fastest = 0, densest = 0, thinnest = 0;
    bool broken = false;  ///< the fastest has a number that is none

    void note_broken(std::size_t i) { broken = true, fastest = i; }
};

/// The last act of a step, of each particle by itself: it is kicked for the time `dt`, and moves for `drift`; `drifted`
/// of that it has moved before [s].
struct Move {
    /// A buffer particle is shifted only where it has this share of the coarser level's Shepard sum. Where less of
    /// it is there the buffer particles end within reach, and shifting would spread them outwards, because it takes the
    /// end for a void: the zone loses particles, and water whose kernel sums are a hundredth too small takes a
    /// hundredth more of pressure gradient to carry itself, so it sinks (docs/decisions/031).
    static constexpr double buffer_shifted_from = 0.98;
    static constexpr double held_at_wall_over_dp = 0.1;  ///< nearer than this a particle is not let towards a wall

    StateView p;
    const Kind* kind;
    const PackedRate* rate;
    const PackedShiftSupport* shift_support;
    const Trend* trend;  ///< null: there are no buffer particles
    double dt, drifted, drift;
    double stream_before, stream_after;  ///< velocity along x [m/s]
    double outlet_share;                 ///< of its change, which the water behind the outlet shares in [-]
    bool inlet_has_wave;                 ///< CarryInlet gives its particles their velocities
    bool shifts;
    double shifting_support;  ///< of LevelSetup
    ShiftStep shift_step;
    const StageMean* stages = nullptr;  ///< of a step in stages

    /// Kicks it, and notes that; gives what shifting adds to its way [m].
    V3<double> kick(std::size_t i, MovedExtremes& part) const {
        const double u0 = p.u[i], v0 = p.v[i], w0 = p.w[i];
        if (drifted > 0)
            part.relative2_before =
                larger(part.relative2_before, (u0 - stream_before) * (u0 - stream_before) + v0 * v0 + w0 * w0);
        V3<double> shift{0, 0, 0};
        const auto shift_towards_voids = [&] {
            const PackedShiftSupport& sum = shift_support[i];
            if (!shifts || static_cast<double>(sum.support) <= shifting_support) return;
            const auto [by, length2] = shift_step.of(sum.x, sum.y, sum.z);
            shift = by;
            part.shift2 = larger(part.shift2, length2);
        };
        const auto add = [&](double a, double b, double c) {
            p.u[i] = static_cast<float>(u0 + dt * a);
            p.v[i] = static_cast<float>(v0 + dt * b);
            p.w[i] = static_cast<float>(w0 + dt * c);
        };
        switch (kind[i]) {
            case Kind::fluid:
            case Kind::overlap: {
                const PackedRate& r = rate[i];
                if (kind[i] == Kind::fluid) part.acceleration2 = larger(part.acceleration2, squared(r.ax, r.ay, r.az));
                add(r.ax, r.ay, r.az);
                p.drho[i] = static_cast<float>(static_cast<double>(p.drho[i]) + dt * static_cast<double>(r.drho));
                shift_towards_voids();
                break;
            }
            case Kind::inlet:
                if (!inlet_has_wave) p.u[i] = static_cast<float>(stream_after);
                break;
            case Kind::outlet: p.u[i] = static_cast<float>(u0 + outlet_share * (stream_after - stream_before)); break;
            case Kind::buffer: {
                const Trend& t = trend[i];
                add(t.u, t.v, t.w);
                if (static_cast<double>(shift_support[i].support) >
                    buffer_shifted_from * static_cast<double>(t.support))
                    shift_towards_voids();
                break;
            }
            case Kind::slave: shift_towards_voids(); break;
        }
        return shift;
    }
    /// The velocity with which it moves on [m/s].
    V3<double> along(std::size_t i) const {
        if (stages) return {stages[i].u, stages[i].v, stages[i].w};
        return {p.u[i], p.v[i], p.w[i]};
    }
    /// Moves it with the velocity `along` and by `shift`.
    void drift_along(std::size_t i, const V3<double>& along, const V3<double>& shift) const {
        p.x[i] += drift * along.x + shift.x;
        p.y[i] += drift * along.y + shift.y;
        p.z[i] += drift * along.z + shift.z;
    }
    /// How it moves now.
    void note(std::size_t i, MovedExtremes& part) const {
        const double u = p.u[i], v = p.v[i], w = p.w[i], drho = p.drho[i], speed2 = u * u + v * v + w * w;
        const bool active = is_active(kind[i]);
        if (active && speed2 > part.speed2) part.speed2 = speed2, part.fastest = i;
        part.relative2 = larger(part.relative2, (u - stream_after) * (u - stream_after) + v * v + w * w);
        if (active && drho < part.low) part.low = drho, part.thinnest = i;
        if (active && drho > part.high) part.high = drho, part.densest = i;
        if (!is_finite(speed2 + drho + p.x[i] + p.y[i] + p.z[i])) part.note_broken(i);
    }

private:
    static double larger(double a, double b) { return a < b ? b : a; }
    static double squared(double a, double b, double c) { return a * a + b * b + c * c; }
    static bool is_finite(double x) { return x - x == 0; }
};

}  // namespace tw
