#pragma once

namespace tw {

/// (1 + x)^n - 1 by series, where there is no mathematical library; for |x| <= 1/2 and |n| <= 20, to 1e-14 of it:
///
///   log(1 + x) = 2 (s + s^3/3 + s^5/5 + ...),  s = x / (2 + x);   e^y - 1 = y + y^2/2! + ...,  y -> 2y by E -> E (E + 2)
inline double power_less_one(double x, double n) {
    constexpr int of_log = 24, of_exp = 14, doublings = 5;
    const double s = x / (2 + x), s2 = s * s;
    double log = 0;
    for (int k = of_log; k >= 0; --k) log = log * s2 + 1.0 / (2 * k + 1);
    log *= 2 * s;
    const double y = n * log / (1 << doublings);
    double e = 0;
    for (int k = of_exp; k >= 1; --k) e = (e + 1) * y / k;
    for (int k = 0; k < doublings; ++k) e *= e + 2;
    return e;
}

}  // namespace tw
