#pragma once
#include <optional>
#include <string>

#include "waves/wave_path.h"

namespace tw {

/// A regular wave, long-crested, on water of uniform depth.
struct RegularWave {
    enum class Theory { linear, stream_function } theory = Theory::stream_function;
    std::string why = {};           ///< this theory, with its numbers
    double height = 0, length = 0;  ///< [m]
    double depth = 0, gravity = 0;  ///< [m], [m/s2]
    double crest = 0, trough = 0;   ///< of the surface above still water [m]; trough < 0
    double speed_in_water = 0;      ///< of the crests, over water whose mean velocity below the troughs is zero [m/s]
    double transport = 0;           ///< volume that the wave carries along over such water [m2/s]
    double bernoulli = 0;           ///< p/rho + 1/2 |v|^2 + g z, v seen from the crest [m2/s2]
    WaveSum sum = {};               ///< velocities and surface

    double k() const { return sum.k; }
    /// Seen from the scene's axes, as a hull in a stream meets it [rad/s]; negative: it is overtaken.
    double encounter_frequency() const { return sum.k * sum.speed; }
    double encounter_period() const;  ///< [s]
    double group_speed_in_water() const;  ///< of its energy, by linear theory for its own speed [m/s]
    double period_in_water() const;   ///< of one who moves with the mean velocity below the troughs [s]
    /// p/rho at (x, 0, z, t), of the wave alone [m2/s2]: 0 at the surface.
    double pressure_over_density(double x, double z, double t) const;
};

/// What is asked for. One of length and period is given.
struct WaveOrder {
    double height = 0;                  ///< [m]
    std::optional<double> length = {};  ///< [m]
    std::optional<double> period =
        {};                            ///< seen from the scene's axes where the tank is closed, else from the water [s]
    double depth = 0, gravity = 9.81;  ///< [m], [m/s2]
    double direction = 1, across = 0;  ///< cosine and sine of the angle to x under which it runs: 1, 0 towards +x
    /// In a closed tank no water is carried along on the whole: a return current cancels the transport of the wave.
    bool closed = true;
    double stream = 0;  ///< of open water, along x [m/s]
    /// Empty: linear where that changes neither crest nor speed by more than 0.5 %, else the stream function.
    std::optional<RegularWave::Theory> theory = {};
};

/// Throws std::domain_error where the stream function has no solution; height, one of length and period, depth and
/// gravity are positive.
RegularWave regular_wave(const WaveOrder& order);

/// What carries water through an inlet under it.
RegularInStream in_stream(const RegularWave& wave);

}  // namespace tw
