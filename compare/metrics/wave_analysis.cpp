#include "compare/metrics/wave_analysis.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "statistics/chi_square.h"

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

void set_certainty(WaveSpectrum& s, std::span<const double> energy) {
    double sum = 0, squares = 0;
    for (const double e : energy) sum += e, squares += e * e;
    s.degrees = squares > 0 ? 2 * sum * sum / squares : 0;
    if (!(s.degrees > 0)) return;
    s.low = std::sqrt(s.degrees / chi_square(s.degrees, 1.959964));
    s.high = std::sqrt(s.degrees / chi_square(s.degrees, -1.959964));
}

WaveSpectrum spectrum_of(std::span<const double> levels, double T, double lowest, double highest) {
    WaveSpectrum s;
    const auto n = static_cast<double>(levels.size());
    double mean = 0;
    for (const double x : levels) mean += x / n;
    for (const double x : levels) s.variance += (x - mean) * (x - mean) / n;
    for (int line = static_cast<int>(std::ceil(lowest * T)); line <= highest * T; ++line) {
        std::complex<double> A = 0;
        for (std::size_t i = 0; i < levels.size(); ++i)
            A += (levels[i] - mean) * std::polar(2 / n, 2 * std::numbers::pi * line * static_cast<double>(i) / n);
        s.f.push_back(line / T);
        s.energy.push_back(std::norm(A) / 2);
    }
    set_certainty(s, s.energy);
    return s;
}

double peak_period_of(std::span<const double> f, std::span<const double> energy) {
    double most = 0, above = 0, below = 0;
    for (const double e : energy) most = std::max(most, e);
    for (std::size_t n = 0; n < f.size(); ++n) {
        const double weight = std::pow(energy[n] / most, 4);
        above += weight, below += f[n] * weight;
    }
    return above / below;
}

std::vector<double> smoothed(const WaveSpectrum& s, double reach) {
    std::vector<double> out;
    for (std::size_t n = 0; n < s.f.size(); ++n) {
        double sum = 0;
        int count = 0;
        for (std::size_t m = 0; m < s.f.size(); ++m)
            if (std::abs(s.f[m] - s.f[n]) <= reach) sum += s.energy[m], ++count;
        out.push_back(sum / count);
    }
    return out;
}

std::vector<double> crossing_heights(std::span<const double> levels) {
    double mean = 0;
    for (const double x : levels) mean += x / static_cast<double>(levels.size());
    std::vector<double> heights;
    std::optional<std::pair<double, double>> wave;  // lowest and highest since the last up-crossing
    for (std::size_t i = 1; i < levels.size(); ++i) {
        if (levels[i - 1] < mean && levels[i] >= mean) {
            if (wave) heights.push_back(wave->second - wave->first);
            wave.emplace(levels[i], levels[i]);
        }
        if (wave) wave->first = std::min(wave->first, levels[i]), wave->second = std::max(wave->second, levels[i]);
    }
    return heights;
}

std::vector<double> at_equal_steps(std::span<const double> t, std::span<const double> x, double from, double step,
                                   int count) {
    std::vector<double> out;
    std::size_t i = 1;  // interval t[i - 1] to t[i]
    for (int m = 0; m < count; ++m) {
        const double at = from + m * step;
        while (i + 1 < t.size() && t[i] < at) ++i;
        // Lagrange's cubic through the two samples to both sides, near the ends through the first or last four
        const std::size_t first = std::clamp<std::size_t>(i, 2, std::max<std::size_t>(2, t.size() - 2)) - 2;
        double value = 0;
        for (std::size_t a = first; a < first + 4; ++a) {
            double weight = 1;
            for (std::size_t b = first; b < first + 4; ++b)
                if (b != a) weight *= (at - t[b]) / (t[a] - t[b]);
            value += weight * x[a];
        }
        out.push_back(value);
    }
    return out;
}

}  // namespace tw
