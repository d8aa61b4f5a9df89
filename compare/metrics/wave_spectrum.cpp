#include "compare/metrics/wave_spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>

#include "statistics/chi_square.h"

namespace tw {

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
