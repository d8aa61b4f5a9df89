#include "record/planing_plate.h"

#include <array>
#include <cmath>
#include <numbers>

namespace tw {
namespace {

using std::numbers::pi;

/// Angle v with F(v, k) = part K(k): the amplitude that leaves this part of the quarter period, by bisection.
double amplitude(double part, double k) {
    double low = 0, high = 0.5 * pi;
    const double wanted = part * std::comp_ellint_1(k);
    for (int i = 0; i < 60; ++i) {
        const double v = 0.5 * (low + high);
        (std::ellint_1(k, v) < wanted ? low : high) = v;
    }
    return 0.5 * (low + high);
}

/// Gauss-Legendre of eight points on each of `parts` pieces of [low, high].
template <class Function>
double integral(double low, double high, int parts, Function f) {
    static constexpr std::array x{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363},
        w{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    const double half = 0.5 * (high - low) / parts;
    double sum = 0;
    for (int p = 0; p < parts; ++p)
        for (std::size_t i = 0; i < x.size(); ++i)
            for (const double side : {-1.0, 1.0}) sum += half * w[i] * f(low + (2 * p + 1 + side * x[i]) * half);
    return sum;
}

}  // namespace

PlaningPlate planing_plate(double alpha, double J) {
    // On the plate x = 1 + (J - 1) cos^2 v turns int dx / |R| with R = sqrt(t (t - 1) (t - J)) into elliptic integrals of
    // modulus k. That the flow is undisturbed far away, int theta / |R| dx = 0, puts s at F(v, k) = alpha / pi K(k).
    const double k = std::sqrt((J - 1) / J), v_s = amplitude(alpha / pi, k);
    PlaningPlate plate;
    plate.delta = std::pow(k * std::sin(v_s), 2);
    plate.force = plate.delta * (1 + std::cos(alpha)) / std::sin(alpha);
    const double s = J * (1 - plate.delta);
    // On the downstream surface theta = R(t) / pi int theta(x) / (|R(x)| (x - t)) dx, of the third kind:
    // x - t = (J - t) (1 - n sin^2 v).
    const auto theta = [&](double t) {
        const double n = (J - 1) / (J - t);
        return 2 / pi * std::sqrt(t * (1 - t) / (J * (J - t))) *
               (pi * std::ellint_3(k, n, v_s) - alpha * std::comp_ellint_3(k, n));
    };
    // t = sin^2 phi takes the root singularities from both ends: dt / t = 2 cot(phi) dphi.
    const double rise = integral(0, 0.5 * pi, 16, [&](double phi) {
        const double t = std::pow(std::sin(phi), 2);
        return std::sin(theta(t)) * (s - t) / (pi * (J - t)) * 2 / std::tan(phi);
    });
    plate.z_te = std::abs(rise) - plate.delta;
    return plate;
}

std::optional<PlaningPlate> planing_plate_at(double alpha, double z_te) {
    // From the largest J down, in ln(J - 1), to where the edge stands above z_te; then bisection.
    const auto at = [&](double l) { return planing_plate(alpha, 1 + std::exp(l)); };
    double high = std::log(1e9);
    if (!(at(high).z_te < z_te)) return {};
    double low = high;
    while (!(at(low).z_te > z_te)) {
        high = low;
        low -= 0.5;
        if (low < std::log(1e-6)) return {};
    }
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (at(middle).z_te > z_te ? low : high) = middle;
    }
    return at(0.5 * (low + high));
}

}  // namespace tw
