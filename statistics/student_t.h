#pragma once

namespace tw {

/// Two-sided 95 % quantile of Student's t with `degrees` (> 0, not only whole) degrees of freedom [-]; 1.96 for
/// infinity.
double student_t_95(double degrees);

/// Probability that Student's t with `degrees` (> 0) degrees of freedom is below `t` [-].
double student_t_cdf(double t, double degrees);

}  // namespace tw
