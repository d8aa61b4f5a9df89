#include "motion/table_motion.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace tw {
namespace {

using Rows = std::span<const double>;

constexpr double at_rest = 0.05;  ///< velocity at an end, over the table's largest, that is taken for rest [-]

/// First derivatives at the knots of the cubic spline with those at both ends given: continuity of the second derivative,
///
///   m_{k-1} / h_{k-1} + 2 (1/h_{k-1} + 1/h_k) m_k + m_{k+1} / h_k
///     = 3 ((y_k - y_{k-1}) / h_{k-1}^2 + (y_{k+1} - y_k) / h_k^2),
///
/// by elimination.
std::vector<double> slopes(Rows t, Rows y, const EndsOfTable& ends) {
    const std::size_t n = t.size();
    std::vector<double> m(n, 0), diagonal(n, 1), right(n, 0);
    m[0] = right[0] = ends.begin;
    m[n - 1] = ends.end;
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const double before = 1 / (t[k] - t[k - 1]), after = 1 / (t[k + 1] - t[k]);
        diagonal[k] = 2 * (before + after);
        right[k] = 3 * ((y[k] - y[k - 1]) * before * before + (y[k + 1] - y[k]) * after * after);
        const double factor = before / diagonal[k - 1];
        if (k > 1) diagonal[k] -= factor * before;
        right[k] -= factor * right[k - 1];
    }
    for (std::size_t k = n - 1; k-- > 1;) m[k] = (right[k] - m[k + 1] / (t[k + 1] - t[k])) / diagonal[k];
    return m;
}

/// Behind knot `k`, with the slopes `m` at the knots.
PlaceOfMotion between_knots(Rows t, Rows y, Rows m, std::size_t k, double time) {
    const double h = t[k + 1] - t[k], q = (time - t[k]) / h, d = y[k + 1] - y[k];
    const double a = h * m[k], c = a + h * m[k + 1] - 2 * d, b = d - a - c;  // y_k + a q + b q^2 + c q^3
    return {y[k] + q * (a + q * (b + q * c)), (a + q * (2 * b + 3 * c * q)) / h, (2 * b + 6 * c * q) / (h * h)};
}

/// The derivative at `t[0]` of the polynomial through (t, y): Newton's divided differences.
double slope_at_first(std::vector<double> t, std::vector<double> y) {
    double slope = 0, product = 1;
    for (std::size_t order = 1; order < t.size(); ++order) {
        for (std::size_t k = 0; k + order < t.size(); ++k) y[k] = (y[k + 1] - y[k]) / (t[k + order] - t[k]);
        slope += product * y[0];
        product *= t[0] - t[order];
    }
    return slope;
}

/// At the first of the rows, which are those of an end from there inwards.
double slope_of_end(const std::vector<double>& t, const std::vector<double>& y, double largest) {
    if (t.size() < 3 || !((y[1] - y[0]) * (y[2] - y[1]) > 0)) return 0;
    const double way = (y[1] - y[0]) / (t[1] - t[0]);
    const double parabola = slope_at_first({t[0], t[1], t[2]}, {y[0], y[1], y[2]});
    if (!(parabola * way > 0) || !(std::abs(parabola) > at_rest * largest)) return 0;
    return t.size() > 3 ? slope_at_first(t, y) : parabola;
}

double fastest_from_row_to_row(Rows t, Rows y) {
    double largest = 0;
    for (std::size_t k = 1; k < t.size(); ++k)
        largest = std::max(largest, std::abs((y[k] - y[k - 1]) / (t[k] - t[k - 1])));
    return largest;
}

}  // namespace

EndsOfTable ends_of_table(const std::vector<double>& times, const std::vector<double>& values) {
    const auto count = static_cast<std::ptrdiff_t>(std::min<std::size_t>(times.size(), 4));
    const double largest = fastest_from_row_to_row(times, values);
    return {
        slope_of_end({times.begin(), times.begin() + count}, {values.begin(), values.begin() + count}, largest),
        slope_of_end({times.rbegin(), times.rbegin() + count}, {values.rbegin(), values.rbegin() + count}, largest)};
}

LargestOfTable largest_of_table(const std::vector<double>& times, const std::vector<double>& values) {
    LargestOfTable most;
    most.from_row_to_row = fastest_from_row_to_row(times, values);
    const std::vector<double> m = slopes(times, values, ends_of_table(times, values));
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
        for (int part = 0; part < 64; ++part) {
            const double t = times[k] + (times[k + 1] - times[k]) * part / 64;
            most.rate = std::max(most.rate, std::abs(between_knots(times, values, m, k, t).rate));
        }
        for (const std::size_t end : {k, k + 1})  // the acceleration is linear between the rows
            most.acceleration =
                std::max(most.acceleration, std::abs(between_knots(times, values, m, k, times[end]).acceleration));
    }
    most.rate = std::max(most.rate, std::abs(m.back()));
    return most;
}

/// By the knots around `time` alone: what a knot does to a slope is halved or more with every knot between them, so
/// those further off would change nothing above rounding, and a table of any length costs the same.
PlaceOfMotion on_table(const std::vector<double>& times, const std::vector<double>& values, double time) {
    constexpr std::size_t reach = 64;
    if (time < times.front()) return {values.front(), 0, 0};
    if (time >= times.back()) {
        const double end = ends_of_table(times, values).end;
        return {values.back() + end * (time - times.back()), end, 0};
    }
    const auto k = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin()) - 1;
    const std::size_t from = k - std::min(k, reach), count = std::min(times.size(), k + 2 + reach) - from;
    const Rows t = Rows(times).subspan(from, count), y = Rows(values).subspan(from, count);
    const bool inside = from > 0 && from + count < times.size();
    const EndsOfTable ends = inside ? EndsOfTable{} : ends_of_table(times, values);
    return between_knots(t, y, slopes(t, y, {from == 0 ? ends.begin : 0, from + count == times.size() ? ends.end : 0}),
                         k - from, time);
}

}  // namespace tw
