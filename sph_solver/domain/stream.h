#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "waves/wave_path.h"

namespace tw {

/// A uniform stream along +x between an inlet and an outlet plane (the x faces of the domain).
///
/// Inlet: a buffer of lattice particles upstream of the plane moves with the stream under hydrostatic pressure; one
/// that crosses the plane becomes fluid and a new one appears a buffer's length upstream. Outlet: a particle that
/// crosses the plane keeps its velocity and density until it has left the buffer. The stream starts from rest: during
/// the ramp a body force accelerates all water alike (the frame of an accelerating hull), which makes no pressure of
/// its own.
struct Stream {
    double speed = 0;   ///< [m/s]
    double ramp = 0;    ///< [s]; 0: at full speed from the start
    double buffer = 0;  ///< length of both buffers [m], a whole number of spacings
    /// Behind this x [m] the water is of another depth (scene/water/tailwater.h), and starts with this share of the
    /// speed and of the acceleration, so that as much leaves as enters.
    double behind_from = std::numeric_limits<double>::infinity(), behind_share = 1;

    /// A wave that enters with it: the inlet's particles move as the water under it, with its velocity and pressure
    /// (loops/inlet_wave.h).
    struct Wave {
        std::variant<RegularInStream, SeaInStream> of = {};
        double gravity = 0;          ///< [m/s2]
        double begin = 0, ramp = 0;  ///< of its height, as that of the stream [s]

        bool is_sum() const { return std::holds_alternative<SeaInStream>(of); }

        double share(double t) const { return t <= begin ? 0 : t >= begin + ramp ? 1 : smooth((t - begin) / ramp); }
    };
    std::optional<Wave> wave = {};

    double share_at(double x) const { return x > behind_from ? behind_share : 1; }
    double velocity(double t) const { return t >= ramp ? speed : speed * smooth(t / ramp); }
    /// Made by the stream until t, over that which it would have made at full speed since half of the ramp [m].
    double ahead_of_full_speed(double t) const {
        if (t >= ramp) return 0;
        const double q = t / ramp;
        return speed * ramp * (q * q * q * (1 - q / 2) - (q - 0.5));
    }
    WaveInStream wave_at(double t) const { return {t, wave ? wave->share(t) : 0, velocity(t)}; }
    double acceleration(double t) const { return t >= ramp ? 0 : speed * smooth_slope(t / ramp) / ramp; }

private:
    // s^2 (3 - 2 s): starts and ends without a jump of acceleration
    static double smooth(double s) { return s * s * (3 - 2 * s); }
    static double smooth_slope(double s) { return 6 * s * (1 - s); }
};

}  // namespace tw
