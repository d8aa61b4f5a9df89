#include "compare/metrics/wave_parts.h"

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace tw {

WaveParts split_waves(std::span<const double> x, std::span<const std::complex<double>> amplitude, double k) {
    using Complex = std::complex<double>;
    WaveParts parts;
    const double n = static_cast<double>(x.size());
    Complex cross = 0, of_incident = 0, of_reflected = 0;
    for (std::size_t m = 0; m < x.size(); ++m) {
        const Complex wave = std::polar(1.0, k * x[m]);
        cross += std::conj(wave) * std::conj(wave);
        of_incident += std::conj(wave) * amplitude[m];
        of_reflected += wave * amplitude[m];
    }
    const double determinant = n * n - std::norm(cross);
    parts.apart = x.size() >= 2 && determinant > 0.05 * n * n;
    if (!parts.apart) return parts;
    parts.incident = (n * of_incident - cross * of_reflected) / determinant;
    parts.reflected = (n * of_reflected - std::conj(cross) * of_incident) / determinant;
    double squares = 0;
    for (std::size_t m = 0; m < x.size(); ++m)
        squares += std::norm(amplitude[m] - parts.incident * std::polar(1.0, k * x[m]) -
                             parts.reflected * std::polar(1.0, -k * x[m]));
    if (x.size() > 2) parts.misfit = std::sqrt(squares / (n - 2)) / std::abs(parts.incident);
    return parts;
}

DecayingParts split_decaying_waves(std::span<const double> x, std::span<const std::complex<double>> amplitude,
                                   double k) {
    using Complex = std::complex<double>;
    constexpr Complex i(0, 1);
    DecayingParts parts;
    const auto n = static_cast<Eigen::Index>(x.size());
    if (n < 3) return parts;
    double middle = 0;
    for (const double at : x) middle += at / static_cast<double>(n);
    std::vector<double> from_middle;
    for (const double at : x) from_middle.push_back(at - middle);
    const WaveParts start = split_waves(from_middle, amplitude, k);
    if (!start.apart) return parts;
    Eigen::Vector3cd fit(start.incident, start.reflected, k);
    Eigen::MatrixXcd J(n, 3);
    Eigen::VectorXcd off(n);
    for (int step = 0; step < 30; ++step) {
        for (Eigen::Index m = 0; m < n; ++m) {
            const double at = from_middle[static_cast<std::size_t>(m)];
            const Complex with = std::exp(i * fit(2) * at), against = 1.0 / with;
            off(m) = amplitude[static_cast<std::size_t>(m)] - fit(0) * with - fit(1) * against;
            J(m, 0) = with, J(m, 1) = against, J(m, 2) = i * at * (fit(0) * with - fit(1) * against);
        }
        const Eigen::Vector3cd change = J.colPivHouseholderQr().solve(off);
        fit += change;
        if (!(std::abs(fit(2) - k) < 0.1 * k)) return parts;
        if (change.norm() < 1e-12 * std::abs(fit(0))) break;
    }
    parts.incident = fit(0), parts.reflected = fit(1), parts.kappa = fit(2);
    parts.apart = true;
    if (n > 3) parts.misfit = off.norm() / std::sqrt(static_cast<double>(n - 3)) / std::abs(fit(0));
    return parts;
}

}  // namespace tw
