#include "compare/reference/run_up_formulas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tw {
namespace {

using std::numbers::pi;

bool complete(const WavesOnSlope& w) {
    return w.height > 0 && w.period > 0 && w.depth > 0 && w.gravity > 0 && std::isfinite(w.cot_slope);
}

}  // namespace

double breaker_parameter(const WavesOnSlope& w) {
    const double deep = w.gravity * w.period * w.period / (2 * pi);
    return 1 / w.cot_slope / std::sqrt(w.height / deep);
}

std::optional<RunUp> ahrens_titus_run_up(const WavesOnSlope& w) {
    if (!complete(w) || !(w.length > 0) || !(w.cot_slope > 0)) return {};
    const double xi = breaker_parameter(w), angle = std::atan(1 / w.cot_slope),
                 shoal = std::pow(std::tanh(2 * pi * w.depth / w.length), 3);
    const double breaking = 1.002 * xi,
                 surging = 1.087 * std::sqrt(pi / (2 * angle)) + 0.775 * w.height / w.length / shoal;
    const double share = std::clamp((xi - 2) / 1.5, 0.0, 1.0);
    return RunUp{((1 - share) * breaking + share * surging) * w.height, 0, true};
}

std::optional<RunUp> long_wave_run_up(const WavesOnSlope& w) {
    if (!complete(w) || !(w.length > 0) || w.cot_slope < 0) return {};
    const double omega = 2 * pi / w.period, s = 2 * omega * w.cot_slope * std::sqrt(w.depth / w.gravity);
    const double height = w.height / std::hypot(std::cyl_bessel_j(0, s), std::cyl_bessel_j(1, s));
    const bool breaks = w.cot_slope > 0 && steepness_of_run_up(w, height) >= 1;
    return RunUp{height, 0, 2 * pi * w.depth / w.length <= 0.7 && !breaks};
}

double steepness_of_run_up(const WavesOnSlope& w, double run_up) {
    const double omega = 2 * pi / w.period;
    return run_up * omega * omega * w.cot_slope * w.cot_slope / w.gravity;
}

std::optional<RunUp> eurotop_run_up(const WavesOnSlope& w) {
    if (!complete(w) || w.cot_slope < 2 * (1 - 1e-6)) return {};
    const double xi = breaker_parameter(w), breaking = 1.65 * xi, most = 4 - 1.5 / std::sqrt(xi);
    const bool breaks = breaking < most;
    return RunUp{std::min(breaking, most) * w.height, 1.96 * w.height * (breaks ? 0.10 / 1.65 * breaking : 0.07 * most),
                 xi > 0.5 && xi < 10};
}

}  // namespace tw
