#include "motion/motion_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/errors.h"
#include "base/numbers.h"

namespace tw {
namespace {

/// First derivatives at the knots of the cubic spline at rest at both ends: continuity of the second derivative,
///
///   m_{k-1} / h_{k-1} + 2 (1/h_{k-1} + 1/h_k) m_k + m_{k+1} / h_k
///     = 3 ((y_k - y_{k-1}) / h_{k-1}^2 + (y_{k+1} - y_k) / h_k^2),   m_0 = m_n = 0,
///
/// by elimination.
std::vector<double> slopes(std::span<const double> t, std::span<const double> y) {
    const std::size_t n = t.size();
    std::vector<double> m(n, 0), diagonal(n, 1), right(n, 0);
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const double before = 1 / (t[k] - t[k - 1]), after = 1 / (t[k + 1] - t[k]);
        diagonal[k] = 2 * (before + after);
        right[k] = 3 * ((y[k] - y[k - 1]) * before * before + (y[k + 1] - y[k]) * after * after);
        if (k > 1) {
            const double factor = before / diagonal[k - 1];
            diagonal[k] -= factor * before;
            right[k] -= factor * right[k - 1];
        }
    }
    for (std::size_t k = n - 1; k-- > 1;) m[k] = (right[k] - m[k + 1] / (t[k + 1] - t[k])) / diagonal[k];
    return m;
}

/// Behind knot `k`, with the slopes `m` at the knots.
MotionLaw::At between_knots(std::span<const double> t, std::span<const double> y, std::span<const double> m,
                            std::size_t k, double time) {
    const double h = t[k + 1] - t[k], q = (time - t[k]) / h, d = y[k + 1] - y[k];
    const double a = h * m[k], c = a + h * m[k + 1] - 2 * d, b = d - a - c;  // y_k + a q + b q^2 + c q^3
    return {y[k] + q * (a + q * (b + q * c)), (a + q * (2 * b + 3 * c * q)) / h, (2 * b + 6 * c * q) / (h * h)};
}

/// By the knots around `time` alone: what a knot does to a slope is halved or more with every knot between them, so
/// those further off would change nothing above rounding, and a table of any length costs the same.
MotionLaw::At on_spline(const std::vector<double>& times, const std::vector<double>& values, double time) {
    constexpr std::size_t reach = 64;
    if (time <= times.front()) return {values.front(), 0, 0};
    if (time >= times.back()) return {values.back(), 0, 0};
    const auto k = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin()) - 1;
    const std::size_t from = k - std::min(k, reach), count = std::min(times.size(), k + 2 + reach) - from;
    const auto t = std::span(times).subspan(from, count), y = std::span(values).subspan(from, count);
    return between_knots(t, y, slopes(t, y), k - from, time);
}

}  // namespace

MotionLaw::At MotionLaw::at(double t) const {
    switch (kind) {
        case Kind::constant: return {rate * t, rate, 0};
        case Kind::ramp: {
            if (t >= ramp) return {rate * (t - ramp / 2), rate, 0};
            const double w = pi / ramp;  // sin^2(w t / 2) = (1 - cos(w t)) / 2
            return {rate / 2 * (t - std::sin(w * t) / w), rate / 2 * (1 - std::cos(w * t)),
                    rate / 2 * w * std::sin(w * t)};
        }
        case Kind::sinusoid: {
            const double w = 2 * pi / period, s = std::sin(w * t + phase), c = std::cos(w * t + phase);
            if (ramp > 0) {  // about its middle, from rest: the amplitude rises as the rate of a ramp
                const double p = pi / ramp;
                const bool up = t < ramp;
                const double f = up ? (1 - std::cos(p * t)) / 2 : 1, df = up ? p / 2 * std::sin(p * t) : 0,
                             ddf = up ? p * p / 2 * std::cos(p * t) : 0;
                return {amplitude * f * s, amplitude * (df * s + f * w * c),
                        amplitude * (ddf * s + 2 * df * w * c - f * w * w * s)};
            }
            return {amplitude * (s - std::sin(phase)), amplitude * w * c, -amplitude * w * w * s};
        }
        case Kind::table: return on_spline(times, values, t);
    }
    return {};
}

double MotionLaw::fastest() const {
    if (kind == Kind::sinusoid) {
        double most = std::abs(2 * pi / period * amplitude);
        const int places = ramp > 0 ? static_cast<int>(64 * std::ceil(std::max(1.0, ramp / period))) : 0;
        for (int k = 0; k < places; ++k) most = std::max(most, std::abs(at(ramp * k / places).rate));
        return most;
    }
    if (kind != Kind::table) return std::abs(rate);
    double most = 0;
    const std::vector<double> m = slopes(times, values);
    for (std::size_t k = 0; k + 1 < times.size(); ++k)
        for (int part = 0; part < 64; ++part) {
            const double t = times[k] + (times[k + 1] - times[k]) * part / 64;
            most = std::max(most, std::abs(between_knots(times, values, m, k, t).rate));
        }
    return most;
}

void MotionLaw::check_table() const {
    if (times.size() != values.size())
        throw InputError(
            fmt::format("{} times and {} values; expected one value for each time", times.size(), values.size()));
    if (times.size() < 2) throw InputError("a table of motion needs two rows or more");
    for (std::size_t k = 1; k < times.size(); ++k)
        if (!(times[k] > times[k - 1]))
            throw InputError(fmt::format("row {} is at {:.6g} s and row {} at {:.6g} s; expected times that rise", k,
                                         times[k - 1], k + 1, times[k]));
}

}  // namespace tw
