#pragma once

namespace tw {

/// (1 + x)^n - 1 by series, where there is no mathematical library; to 1e-14 of it for |x| <= 1/2 and |n| <= 20 (a
/// liquid), and for -0.96 < x < 11 and |n| <= 2 (a gas):
///
///   log(1 + x) = 2 (s + s^3/3 + s^5/5 + ...),  s = x / (2 + x);   e^y - 1 = y + y^2/2! + ...,  y -> 2y by E -> E (E + 2)
///
/// Beyond |x| = 1/2 the factors of two are taken out of 1 + x first.
inline double power_less_one(double x, double n) {
    constexpr int of_log = 24, of_exp = 14, doublings = 5;
    constexpr double log_2 = 0.693147180559945309417;
    int twos = 0;
    for (; x > 0.5 && twos < 8; ++twos) x = (x - 1) / 2;
    for (; x < -0.5 && twos > -8; --twos) x = 2 * x + 1;
    const double s = x / (2 + x), s2 = s * s;
    double log = 0;
    for (int k = of_log; k >= 0; --k) log = log * s2 + 1.0 / (2 * k + 1);
    log = log * (2 * s) + twos * log_2;
    const double y = n * log / (1 << doublings);
    double e = 0;
    for (int k = of_exp; k >= 1; --k) e = (e + 1) * y / k;
    for (int k = 0; k < doublings; ++k) e *= e + 2;
    return e;
}

}  // namespace tw
