#pragma once
#include <span>
#include <string>
#include <vector>

namespace tw {

/// One run of a refinement study: its representative size h_i and the quantity phi_i found with it.
struct StudyLevel {
    double h = 0;      ///< h_i: cell size or particle spacing where it matters for the quantity, > 0 [any one unit]
    double value = 0;  ///< phi_i [any one unit]
    double half_width = 0;  ///< of the 95 % interval of phi_i's own noise, such as a time mean's [unit of the value]
    double rounding = 0;    ///< bound of what digits or arithmetic leave open of phi_i [unit of the value]
};

/// The levels with the finest first, as every estimator here wants them (the papers' index 1 is element 0).
/// Throws InputError for no level, a spacing that is not a finite number above zero, a value that is not finite, and
/// two levels of the same spacing (nearer than 1e-6 of it).
std::vector<StudyLevel> finest_first(std::vector<StudyLevel> levels);

/// How values behave as the spacing shrinks.
enum class Convergence {
    unknown,      ///< fewer than three levels
    unchanged,    ///< the values do not differ by more than their own noise: there is no order to find
    monotone,     ///< towards a limit, from one side
    oscillatory,  ///< towards a limit, from alternating sides
    divergent,    ///< the changes do not die out
    scattered,    ///< scatter hides the trend: the values have an interval, and no order
    irregular     ///< the changes die out, but not as a scheme's error does: see Estimate
};
/// The name of the enumerator.
std::string to_string(Convergence convergence);

/// True when two values of a set whose largest magnitude is `size` differ by rounding only: that of double precision and
/// the levels' own.
bool same_but_for_rounding(const StudyLevel& a, const StudyLevel& b, double size);

/// True when every two values differ by rounding only, or by less than the 95 % interval of their difference,
/// sqrt(half_width_a^2 + half_width_b^2).
bool equal_within_noise(std::span<const StudyLevel> levels);

/// Largest magnitude of the values [unit of the value].
double largest_magnitude(std::span<const StudyLevel> levels);

}  // namespace tw
