#pragma once
#include "scene/scene.h"

namespace tw {

/// What a scene's wave asks of tank or stream, zones, sizes and times. Of a sum of waves the peak is what a regular one is as a
/// whole; waves below and above which 5 % of the energy lie are the longest and the shortest that count.
struct WaveScales {
    double direction = 1;                      ///< in the water, its cosine; 1: towards +x, -1: towards -x [-]
    double height = 0;                         ///< significant height of a sum, twice the crest of a focused wave [m]
    double crest = 0;                          ///< as high as the surface comes, in a sum about [m]
    double length = 0, period = 0, speed = 0;  ///< [m], [s], [m/s]
    double longest = 0, lowest_frequency = 0;  ///< [m]; of encounter, of following waves see below [rad/s]
    double shortest = 0, slowest = 0;          ///< [m]; speed of the energy of the shortest in the scene's axes [m/s]
    bool comes_from_low_x = true;              ///< its energy
    double measured = 0;                       ///< over which means are taken [s]: seven periods, a sea's repeat period
};
inline constexpr double waves_that_count = 0.05;  ///< share of the energy left out at each end
/// Of a scene that has a wave; of a sum in a stream period and speed are those of encounter at the peak. A following wave (direction -1 in a stream U) is carried by its group speed cg against the
/// stream: where the stream is faster, its energy comes from ahead of the hull, else from behind. How long it stays in a
/// zone is told by U - cg and not by its frequency of encounter, which is zero where U is its own speed; in place of that
/// stands omega |U - cg| / cg, omega in the water.
WaveScales wave_scales(const Scene& scene);
bool begins_in_zone(const Scene& scene);  ///< with solids in the tank, and in an empty twin
/// In a tank. A stream begins calm: what its zone has not yet made leaves it with the water.
bool begins_with_wave(const Scene& scene);

/// The wave of [wave] in the tank as the water begins: everywhere but at the end that absorbs it, where its height
/// falls to nothing as 1 - s^2 (s as in scene/box/forcing_zones.h). With solids in the tank it begins in the zone that
/// makes it alone, and its front runs from there. The level is moved so that the tank holds as much water as without
/// the wave.
class TankWave {
public:
    explicit TankWave(const Scene& scene);    ///< that begins with a wave
    double share(double x) const;             ///< of the wave's height there, 0 to 1
    double surface(double x) const;           ///< at the start [m]
    Vec3 velocity(double x, double z) const;  ///< at the start [m/s]
    /// p / (rho g) at the start [m]; z below the surface.
    double pressure_head(double x, double z) const;

    /// Where water at rest goes: whole columns are drawn apart and up or pressed together and down, so that no volume
    /// changes, x0 = integral of (d + eta)/d dx, z + d = (z0 + d) (d + eta)/d.
    Vec3 moved(const Vec3& at_rest) const;

private:
    double integral(double x) const;       ///< of the surface from the tank's low end to x, by the table
    double whole_surface(double x) const;  ///< of the wave itself, at the start [m]

    const Scene& scene_;
    std::optional<WaveMoment> sea_;  ///< at the start
    double depth_;                   ///< [m]
    double low_, high_;              ///< of the tank along x [m]
    double begin_[2], end_[2];       ///< of the two zones, making first
    bool in_zone_only_ = false;
    double level_ = 0;              ///< [m]
    double step_ = 0;               ///< of the table [m]
    std::vector<double> integral_;  ///< [m2]
};

/// Loss of height over a length by the particles' artificial viscosity [-], a fraction: 1 - exp(-2 nu k^2 x / cg) with
/// nu = alpha c0 h / 8 in two dimensions, / 10 in three (Lamb 348 for the rate in time). Waves lose more, by the kernel's
/// sums (docs/decisions/088-waves.md).
double loss_by_artificial_viscosity(const Scene& scene, double distance);

}  // namespace tw
