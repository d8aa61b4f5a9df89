#pragma once
#include <cstdint>
#include <string>

#include "waves/wave_components.h"

namespace tw {

/// Several linear waves on one another, long-crested along x, on water of uniform depth, at rest or in a stream along x.
struct Sea {
    enum class Kind { jonswap, pierson_moskowitz, bichromatic, focused } kind = Kind::jonswap;
    WaveComponents waves = {};
    double gravity = 0;             ///< [m/s2]
    double significant_height = 0;  ///< 4 sqrt(m0) of the components [m]
    double peak_period = 0;         ///< of the spectrum, in the water; of two waves that of the higher one [s]
    /// After which the surface is everywhere what it was [s]: of a spectrum one over the distance of its frequencies, of
    /// two waves one over their difference (then height and phase of the beat, not the surface itself).
    double repeat_period = 0;
    double beyond = 0;  ///< share of the spectrum's energy outside the components' band, which they carry as well [-]
    double focus_place = 0, focus_time = 0;  ///< where all components of a focused wave have their crests [m], [s]

    double depth() const { return waves.depth; }
    double energy(int n) const { return waves.height[n] * waves.height[n] / 2; }  ///< of a component [m2]
    /// Moment of the components' spectrum, sum_n f_n^order energy_n [m2/s^order].
    double moment(int order) const;
    /// Place of the component up to which, from the lowest frequency on, a share of the energy lies.
    int component_at(double share_of_energy) const;
    double length(int n) const { return 6.283185307179586476925 / waves.k[n]; }         ///< [m]
    double frequency(int n) const { return waves.omega[n] * turns_per_radian; }         ///< in the water [1/s]
    double met(int n) const;         ///< as it is met in the scene's axes, omega + direction k stream [rad/s]
    double peak_period_met() const;  ///< likewise [s]
    double length_at_peak() const;                                                      ///< [m]
    /// p/rho at (x, z, t) without hydrostatic pressure, to first order, of z <= 0 [m2/s2].
    double pressure_over_density(double x, double z, double t) const;
};

/// What is asked for. Energies are those of the spectrum integrated over each component's band.
struct SeaOrder {
    Sea::Kind kind = Sea::Kind::jonswap;
    double depth = 0, gravity = 9.81;  ///< [m], [m/s2]
    double direction = 1;              ///< 1, -1
    double stream = 0;                 ///< of open water, along x [m/s]; 0: a closed tank
    double height = 0;        ///< significant height; of a focused wave its crest, the sum of the amplitudes [m]
    double peak_period = 0;   ///< [s]
    double peakedness = 3.3;  ///< JONSWAP's gamma [-]; 1: Pierson-Moskowitz
    int components = 60;      ///< 8 to 96
    std::uint64_t seed = 1;   ///< of the phases
    double focus_place = 0, focus_time = 0;           ///< [m], [s]
    double heights[2] = {0, 0}, periods[2] = {0, 0};  ///< of the two waves of a bichromatic one [m], [s]
};

/// Against a stream waves are made whose energy runs at 1/0.7 of its speed and faster.
inline constexpr double slowest_passing = 0.7;

/// Spectrum of JONSWAP over its value's scale [-], f and fp in the same unit (Hasselmann et al. 1973; gamma = 1:
/// Pierson & Moskowitz 1964):
///
///   S ~ f^-5 exp(-5/4 (fp/f)^4) gamma^exp(-(f/fp - 1)^2 / (2 sigma^2)),   sigma = 0.07 up to fp, 0.09 above
double jonswap_shape(double f, double fp, double gamma);

/// Components of equal distance in frequency as it is met, whole multiples of it, from half to 2.5 times the peak's in
/// the water (against a stream up to where their energy still passes, `slowest_passing`), with the energies of the spectrum and phases at random (splitmix64 from the seed, the same on every machine); of a focused
/// wave with amplitudes as the energies (NewWave: Tromans, Anaturk & Hagemeijer 1991) and a crest of all at one place
/// and time. A tank is closed: a return current cancels what the waves carry along on the whole.
Sea make_sea(const SeaOrder& order);

/// Kernels of the second-order surface of two long-crested waves, of wave numbers k_i and k_j [1/m] and R = omega^2/g
/// [1/m] on water of depth d [m] (Sharma & Dean 1981, as in Forristall 2000, J. Phys. Oceanogr. 30, eq. A1 to A8):
///
///   eta_2 = 1/4 sum_ij a_i a_j [K+ cos(theta_i + theta_j) + K- cos(theta_i - theta_j)]
struct BoundWaves {
    double sum = 0, difference = 0;  ///< K+, K- [1/m]; K- of a wave with itself, a mean level, is left out
};
BoundWaves bound_waves(double k_i, double R_i, double k_j, double R_j, double depth);

/// Surface to second order without the first, at one place and time [m].
double second_order_surface(const Sea& sea, double x, double t);
/// Significant height of the bound waves over that of the sea: what a sum of linear waves leaves out [-].
struct SecondOrderShare {
    double sum = 0, difference = 0;  ///< of the short ones and of the long ones [-]
    double both() const;
};
SecondOrderShare left_out_by_first_order(const Sea& sea);

/// The highest crest between two times at one place, to first or second order.
struct Crest {
    double height = 0, time = 0;  ///< [m], [s]
};
Crest highest_crest(const Sea& sea, double x, double from, double to, bool second_order);

std::string name_of(Sea::Kind kind);  ///< "JONSWAP", ...

}  // namespace tw
