#include "statistics/error_of_mean.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "statistics/student_t.h"

namespace tw {

double integrated_autocorrelation_time(std::span<const double> x, int fitted) {
    const std::size_t n = x.size();
    if (n < 2) return 0.5;
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(n);
    const auto covariance = [&](std::size_t lag) {
        double sum = 0;
        for (std::size_t i = 0; i + lag < n; ++i) sum += (x[i] - mean) * (x[i + lag] - mean);
        return sum / static_cast<double>(n - lag);
    };
    const double variance = covariance(0);
    if (!(variance > 1e-24 * mean * mean)) return 0.5;  // constant but for rounding
    double tau = 0.5;
    std::size_t lag = 1;
    for (; lag < n / 2; ++lag) {
        tau += covariance(lag) / variance;
        if (static_cast<double>(lag) > 5 * tau) break;
    }
    // Every rho up to the window is short by 2 tau / n for each fitted parameter.
    const double shortfall = 2 * fitted * static_cast<double>(lag) / static_cast<double>(n);
    tau /= std::max(0.2, 1 - shortfall);
    return std::clamp(tau, 0.5, static_cast<double>(n) / 2);
}

double correlated_t_95(double n_eff, int fitted) { return student_t_95(std::max(1.0, (n_eff - fitted) / 6)); }

double half_width_of_mean(std::span<const double> x) {
    const auto n = static_cast<double>(x.size());
    if (n < 2) return 0;
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
    double squares = 0;
    for (const double v : x) squares += (v - mean) * (v - mean);
    const double s = std::sqrt(squares / (n - 1)), n_eff = n / (2 * integrated_autocorrelation_time(x));
    return s * std::min(correlated_t_95(n_eff, 1) / std::sqrt(n_eff), 2.0);
}

double batch_means_error(std::span<const double> x, std::size_t b) {
    const std::size_t n = x.size();
    if (b < 1 || 2 * b > n) return 0;
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(n);
    double batch = std::accumulate(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(b), 0.0), squares = 0;
    for (std::size_t j = 0;; ++j) {
        const double deviation = batch / static_cast<double>(b) - mean;
        squares += deviation * deviation;
        if (j + b >= n) break;
        batch += x[j + b] - x[j];
    }
    return std::sqrt(static_cast<double>(b) / (static_cast<double>(n - b + 1) * static_cast<double>(n - b)) * squares);
}

}  // namespace tw
