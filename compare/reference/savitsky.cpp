#include "compare/reference/savitsky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"

namespace tw {

Savitsky savitsky(const PlaningState& s, double lambda) {
    const double trim_deg = s.trim / degree, deadrise_deg = s.deadrise / degree, b = s.beam;
    const double trim_power = std::pow(trim_deg, 1.1);
    const double Cv = s.speed / std::sqrt(s.gravity * b);
    const double CL0 = trim_power * (0.012 * std::sqrt(lambda) + 0.0055 * std::pow(lambda, 2.5) / (Cv * Cv));
    const double CLbeta = CL0 - 0.0065 * deadrise_deg * std::pow(CL0, 0.6);

    Savitsky r;
    r.lambda = lambda;
    const double keel_over_chine = b * std::tan(s.deadrise) / (std::numbers::pi * std::tan(s.trim));
    r.keel_wetted_length = lambda * b + 0.5 * keel_over_chine;
    r.chine_wetted_length = lambda * b - 0.5 * keel_over_chine;
    r.lift = CLbeta * 0.5 * s.density * s.speed * s.speed * b * b;
    r.pressure_drag = r.lift * std::tan(s.trim);

    // The dynamic part of the lift, spread over the wetted bottom, lowers the mean velocity along it (Bernoulli).
    const double dynamic0 = 0.012 * std::sqrt(lambda) * trim_power;
    const double dynamic = dynamic0 - 0.0065 * deadrise_deg * std::pow(dynamic0, 0.6);
    const double Vm = s.speed * std::sqrt(std::max(0.0, 1 - dynamic / (lambda * std::cos(s.trim))));
    const double Re = Vm * lambda * b / s.kinematic_viscosity;
    const double Cf = 0.075 / std::pow(std::log10(Re) - 2, 2);
    r.friction_drag = Cf * 0.5 * s.density * Vm * Vm * lambda * b * b / std::cos(s.deadrise);
    r.drag = r.pressure_drag + r.friction_drag / std::cos(s.trim);
    r.pressure_centre = lambda * b * (0.75 - 1 / (5.21 * Cv * Cv / (lambda * lambda) + 2.39));
    r.in_range = Cv >= 0.6 && Cv <= 13 && trim_deg >= 2 && trim_deg <= 15 && lambda > 0 && lambda <= 4 &&
                 r.chine_wetted_length > 0;
    return r;
}

std::optional<std::pair<PlaningState, Savitsky>> savitsky_free(PlaningState s, const PlaningMass& mass) {
    constexpr double least_trim = 0.5 * degree, most_trim = 15 * degree;
    constexpr double shortest = 0.05, longest = 6;  // wetted lengths over the beam
    constexpr int halvings = 60;
    const auto carried = [&](double trim) -> std::optional<Savitsky> {  // the lift grows with the wetted length
        s.trim = trim;
        double low = shortest, high = longest;
        if (savitsky(s, low).lift > mass.weight || savitsky(s, high).lift < mass.weight) return {};
        for (int k = 0; k < halvings; ++k)
            (savitsky(s, (low + high) / 2).lift < mass.weight ? low : high) = (low + high) / 2;
        return savitsky(s, (low + high) / 2);
    };
    const auto bow_up = [&](const Savitsky& at) {
        const double rubbing = mass.friction ? at.friction_drag * (mass.vcg - s.beam / 4 * std::tan(s.deadrise)) : 0;
        return at.lift / std::cos(s.trim) * (at.pressure_centre - mass.lcg) - rubbing;
    };
    // With more trim less of the bottom is wet, and the pressure moves aft. Too little trim does not carry the weight on
    // six beams; there the bow goes up, too.
    double low = least_trim, high = most_trim;
    for (int k = 0; k < halvings; ++k) {
        const double middle = (low + high) / 2;
        s.trim = middle;
        const bool sinks = savitsky(s, longest).lift < mass.weight;
        const std::optional<Savitsky> at = carried(middle);
        (sinks || (at && bow_up(*at) > 0) ? low : high) = middle;
    }
    const std::optional<Savitsky> found = carried(low);
    if (!found || std::abs(bow_up(*found)) > 1e-3 * mass.weight * s.beam) return {};
    return std::pair(s, *found);
}

Savitsky savitsky_at_keel(const PlaningState& s, double keel) {
    const double chine = keel - s.beam * std::tan(s.deadrise) / (std::numbers::pi * std::tan(s.trim));
    Savitsky r = savitsky(s, (keel + std::max(chine, 0.0)) / (2 * s.beam));
    r.keel_wetted_length = keel;
    r.chine_wetted_length = chine;
    r.in_range = r.in_range && chine > 0;
    return r;
}

Savitsky savitsky_at_draft(const PlaningState& s, double draft) {
    return savitsky_at_keel(s, draft / std::sin(s.trim));
}

}  // namespace tw
