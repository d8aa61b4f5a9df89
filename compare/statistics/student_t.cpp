#include "compare/statistics/student_t.h"

#include <algorithm>
#include <cmath>

namespace tw {

namespace {

/// Regularised incomplete beta function I_x(a, b) by Lentz's continued fraction (Press et al., Numerical Recipes, 6.4).
double incomplete_beta(double a, double b, double x) {
    if (x <= 0) return 0;
    if (x >= 1) return 1;
    const double front =
        std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
    if (x > (a + 1) / (a + b + 2)) return 1 - incomplete_beta(b, a, 1 - x);
    constexpr double tiny = 1e-300;
    double c = 1, d = 1 - (a + b) * x / (a + 1);
    d = 1 / (std::abs(d) < tiny ? tiny : d);
    double fraction = d;
    for (int m = 1; m < 500; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        for (const double term : {even, odd}) {
            d = 1 + term * d;
            c = 1 + term / c;
            d = 1 / (std::abs(d) < tiny ? tiny : d);
            c = std::abs(c) < tiny ? tiny : c;
            fraction *= d * c;
        }
        if (std::abs(d * c - 1) < 1e-14) break;
    }
    return front * fraction / a;
}

}  // namespace

double student_t_cdf(double t, double degrees) {
    // P(|T| > t) = I_{nu / (nu + t^2)}(nu / 2, 1 / 2)
    const double beyond = 0.5 * incomplete_beta(0.5 * degrees, 0.5, degrees / (degrees + t * t));
    return t > 0 ? 1 - beyond : beyond;
}

double student_t_95(double degrees) {
    if (!(degrees < 1e6)) return 1.959963984540054;
    double low = 0, high = 1e7;
    for (int i = 0; i < 200 && high - low > 1e-12 * high; ++i) {
        const double t = 0.5 * (low + high);
        (student_t_cdf(t, degrees) < 0.975 ? low : high) = t;
    }
    return 0.5 * (low + high);
}

}  // namespace tw
