#pragma once
#include <cmath>
#include <complex>
#include <span>

namespace tw {

/// Two-sided 95 % quantile of Student's t with `degrees` (> 0, not only whole) degrees of freedom [-]; 1.96 for
/// infinity.
double student_t_95(double degrees);

/// Probability that Student's t with `degrees` (> 0) degrees of freedom is below `t` [-].
double student_t_cdf(double t, double degrees);

/// Mean of independent values and its half width, t_95 s / sqrt(n) with the sample's deviation s.
struct IndependentMean {
    double value = NAN;       ///< [unit of the values]; NaN of no values
    double half_width = NAN;  ///< [unit of the values]; NaN of fewer than two
};
IndependentMean mean_of_independent(std::span<const double> values);

/// The same of complex values, with the mean square of their distances from the mean as s^2.
struct IndependentComplexMean {
    std::complex<double> value = NAN;  ///< [unit of the values]; NaN of no values
    double half_width = NAN;           ///< [unit of the values]; NaN of fewer than two
};
IndependentComplexMean mean_of_independent(std::span<const std::complex<double>> values);

}  // namespace tw
