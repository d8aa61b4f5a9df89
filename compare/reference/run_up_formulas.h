#pragma once
#include <optional>

namespace tw {

/// What meets a smooth slope, and the slope.
struct WavesOnSlope {
    double height = 0;     ///< of a regular wave; Hm0 of irregular ones [m]
    double period = 0;     ///< of a regular wave; Tm-1,0 [s]
    double length = 0;     ///< of a regular wave before the slope [m]
    double depth = 0;      ///< of the water before it [m]
    double cot_slope = 0;  ///< cotangent of its angle with the horizontal [-]
    double gravity = 0;    ///< [m/s2]
};
struct RunUp {
    double height = 0;      ///< above still water [m]
    double half_width = 0;  ///< 1.96 standard deviations where they are known, else 0 [m]
    bool in_range = false;
};

/// xi = tan a / sqrt(H / L0), L0 = g T^2 / (2 pi) (Iribarren & Nogales 1949) [-]: below about 2 waves break on the slope.
double breaker_parameter(const WavesOnSlope& waves);

/// Regular waves on smooth slopes, Ahrens & Titus 1985 (J. Waterw. Port Coast. Ocean Eng. 111, 128) as in the Corps of
/// Engineers' ACES:
///
///   R/H = 1.002 xi                                                                    xi <= 2
///   R/H = 1.087 sqrt(pi / (2 a)) + 0.775 (H/L) / tanh^3(2 pi d / L)                   xi >= 3.5
///
/// and linear in xi between them; a: the slope's angle. Below xi = 2 that is Hunt's formula of 1959. Nothing of a
/// vertical wall.
std::optional<RunUp> ahrens_titus_run_up(const WavesOnSlope& waves);

/// Linear long waves on a plane slope that rises from water of uniform depth, with all of the wave coming back (Keller
/// & Keller 1964, ONR report NONR-3828(00); Shuto 1967):
///
///   R/H = 1 / sqrt(J0(s)^2 + J1(s)^2),   s = 2 omega cot(a) sqrt(d / g)
///
/// of a vertical wall 1: the standing wave. In range up to k d = 0.7, where long waves are 8 % too fast, and where the
/// wave does not break, R omega^2 / (g tan^2 a) < 1 (Carrier & Greenspan 1958).
std::optional<RunUp> long_wave_run_up(const WavesOnSlope& waves);
/// R omega^2 / (g tan^2 a) [-].
double steepness_of_run_up(const WavesOnSlope& waves, double run_up);

/// What 2 % of the run-ups of irregular waves exceed, EurOtop 2018, eq. 5.1 and 5.2, mean values, smooth slopes of 1 in
/// 2 and gentler:
///
///   R_2% / Hm0 = 1.65 xi, at most 1.00 (4 - 1.5 / sqrt(xi))
///
/// Standard deviations 0.10 of 1.65 and 0.07 of 1.00.
std::optional<RunUp> eurotop_run_up(const WavesOnSlope& waves);

}  // namespace tw
