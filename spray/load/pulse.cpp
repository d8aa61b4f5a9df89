#include "spray/load/pulse.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tw::spray {
namespace {

/// Integral of sqrt(x) (1 - x)^4 from 0 to x.
double root_integral(double x) {
    const double r = std::sqrt(x);
    return x * r * (2.0 / 3 + x * (-8.0 / 5 + x * (12.0 / 7 + x * (-8.0 / 9 + x * 2.0 / 11))));
}
const double root_scale = 3 / std::pow(8.0 / 9, 4);  // 1 over the largest value, at x = 1/9

/// Coefficients of t in ms, from t^0 to t^9, as printed.
constexpr std::array<double, 10> printed{-0.001519, 0.8038, -5.326, 17.65, -34.73, 42.33, -31.91, 14.55, -3.66, 0.3901};
constexpr double study_peak = 0.04423;  ///< largest value of the printed polynomial [N], at 0.164 ms
constexpr double study_end = 6e-4;      ///< [s]

double study_integral(double t) {
    const double ms = t * 1e3;
    double sum = 0;
    for (std::size_t k = printed.size(); k-- > 0;) sum = sum * ms + printed[k] / static_cast<double>(k + 1);
    return sum * ms * 1e-3;
}

}  // namespace

double study_polynomial(double t) {
    double sum = 0;
    for (std::size_t k = printed.size(); k-- > 0;) sum = sum * t * 1e3 + printed[k];
    return sum;
}

Pulse::Pulse(PulseShape shape, double peak, double impulse)
    : shape_(shape),
      peak_(peak),
      duration_(shape == PulseShape::root ? impulse / (peak * root_scale * root_integral(1)) : study_end) {}

double Pulse::force(double t) const {
    if (!(t > 0) || t >= duration_) return 0;
    if (shape_ == PulseShape::study) return peak_ / study_peak * std::max(0.0, study_polynomial(t));
    const double x = t / duration_, rest = (1 - x) * (1 - x);
    return peak_ * root_scale * std::sqrt(x) * rest * rest;
}

double Pulse::impulse_until(double t) const {
    if (!(t > 0)) return 0;
    t = std::min(t, duration_);
    if (shape_ == PulseShape::study) return peak_ / study_peak * study_integral(t);
    return peak_ * duration_ * root_scale * root_integral(t / duration_);
}

}  // namespace tw::spray
