#include "compare/uncertainty/convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace tw {

namespace {

constexpr double smallest_p =
    0.5;  ///< observed order below which an oscillation counts as undamped, as in eca_hoekstra.h
constexpr double no_order = 0.1;  ///< below which values are not told from ones that diverge

struct Candidate {
    std::string method;
    double order, limit, uncertainty;
};

void take(Estimate& e, const Candidate& c) {
    e.method = c.method;
    e.order = c.order;
    e.limit = c.limit;
    e.uncertainty = c.uncertainty;
}

void from_one_level(Estimate& e) { e.why_not = "one level shows no change; expected two or more"; }

void from_two_levels(Estimate& e) {
    e.celik_gci = two_level_gci(e.levels, e.p_th);
    take(e, {"GCI of two levels, order assumed, Fs = 3", e.p_th, e.celik_gci.phi_ext, e.celik_gci.uncertainty});
}

void from_three_levels(Estimate& e) {
    e.convergence = e.celik_gci.convergence;
    if (e.convergence == Convergence::divergent) {
        e.why_not = e.celik_gci.why_not;
        return;
    }
    const double phi1 = e.levels[0].value, phi2 = e.levels[1].value, phi3 = e.levels[2].value;
    std::vector<Candidate> candidates;
    const double p = e.celik_gci.p;
    if (e.convergence == Convergence::oscillatory && p < smallest_p) {
        // Hardly damped: an extrapolation would divide by next to nothing. The values scatter about what they tend to.
        e.convergence = Convergence::scattered;
        const auto [low, high] = std::minmax({phi1, phi2, phi3});
        take(e, {"three times half the range of three levels", Estimate::nan, 0.5 * (low + high), 1.5 * (high - low)});
        return;
    }
    if (e.convergence == Convergence::monotone && p < no_order) {
        e.convergence = Convergence::divergent;
        e.why_not = fmt::format("the changes of the three finest levels hardly shrink (observed order {:.2g})", p);
        return;
    }
    if (e.celik_gci.known) candidates.push_back({"GCI", p, e.celik_gci.phi_ext, e.celik_gci.uncertainty});
    if (e.xing_stern.known) candidates.push_back({"factor of safety", p, e.xing_stern.limit, e.xing_stern.uncertainty});
    if (p > 1.05 * e.p_th) {
        const CelikGci assumed = two_level_gci(e.levels, e.p_th);
        candidates.push_back({"order of the scheme, Fs = 3", p, assumed.phi_ext, assumed.uncertainty});
    }
    if (e.convergence != Convergence::monotone) {
        const double limit = e.celik_gci.known ? e.celik_gci.phi_ext : phi1;
        candidates.push_back(
            {"half the range", p, limit, 0.5 * (std::max({phi1, phi2, phi3}) - std::min({phi1, phi2, phi3}))});
    }
    take(e, *std::ranges::max_element(candidates, {}, &Candidate::uncertainty));
    e.method += ", the widest of three levels";
}

void from_many_levels(Estimate& e) {
    const EcaHoekstra& best = e.eca_hoekstra;
    e.convergence = best.convergence;
    e.why_not = best.why_not;
    if (best.known) take(e, {"least squares (Eca & Hoekstra)", best.p, best.phi0, best.uncertainty});
}

std::vector<double> of_every_level(const Estimate& e) {
    if (!std::isfinite(e.uncertainty)) return {};
    if (e.levels.size() >= 4) return e.eca_hoekstra.uncertainties;
    std::vector<double> U;
    const double error = std::abs(e.levels[0].value - e.limit);
    for (const StudyLevel& l : e.levels)
        U.push_back(error > 0 ? e.uncertainty * std::abs(l.value - e.limit) / error : e.uncertainty);
    return U;
}

double disagreement(const Estimate& e) {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    int known = 0;
    for (const double U : {e.eca_hoekstra.uncertainty, e.celik_gci.uncertainty, e.xing_stern.uncertainty}) {
        if (!std::isfinite(U) || U <= 0) continue;
        ++known;
        low = std::min(low, U);
        high = std::max(high, U);
    }
    return known > 1 ? high / low : Estimate::nan;
}

/// "1.0511 +- 0.060 (5.7 %)": the value to the digits that its uncertainty supports.
std::string value_with_uncertainty(double value, double U) {
    const std::string share = value != 0 ? fmt::format(" ({:.2g} %)", 100 * U / std::abs(value)) : "";
    if (!(U > 1e-9 * std::abs(value))) return fmt::format("{:.6g} +- {:.2g}{}", value, U, share);
    const int last_digit = static_cast<int>(std::floor(std::log10(U))) - 1;  // the second of U
    const double size = std::max(std::abs(value), U);
    if (size >= 1e7 || size < 1e-3) return fmt::format("{:.6g} +- {:.2g}{}", value, U, share);
    const int places = std::clamp(-last_digit, 0, 9);
    return fmt::format("{:.{}f} +- {:.{}f}{}", value, places, U, places, share);
}

}  // namespace

Estimate estimate(std::vector<StudyLevel> levels, double p_th) {
    if (!(p_th >= 0.1 && p_th <= 10))
        throw InputError(fmt::format("order of the scheme {} found; expected a number from 0.1 to 10", p_th));
    Estimate e;
    e.levels = finest_first(std::move(levels));
    e.p_th = p_th;
    e.eca_hoekstra = eca_hoekstra(e.levels);
    e.celik_gci = celik_gci(e.levels);
    e.xing_stern = xing_stern(e.levels, p_th);
    switch (e.levels.size()) {
        case 1: from_one_level(e); break;
        case 2: from_two_levels(e); break;
        case 3: from_three_levels(e); break;
        default: from_many_levels(e);
    }
    e.converged = e.convergence == Convergence::unchanged || e.convergence == Convergence::monotone ||
                  e.convergence == Convergence::oscillatory;
    e.uncertainties = of_every_level(e);
    e.disagreement = disagreement(e);
    return e;
}

std::string verdict_sentence(const Estimate& e) {
    if (e.levels.size() == 1) return "no uncertainty: " + e.why_not;
    if (!std::isfinite(e.uncertainty))
        return fmt::format("not converged ({}): {}; no uncertainty can be given", to_string(e.convergence), e.why_not);
    if (e.uncertainty <= 1e-9 * std::abs(e.levels[0].value))
        return fmt::format("unchanged from size to size: {:.6g}; no discretisation error is seen", e.levels[0].value);
    const std::string value = value_with_uncertainty(e.levels[0].value, e.uncertainty);
    if (e.levels.size() == 2)
        return fmt::format("{} by an assumed order {:g} with Fs = 3: two levels cannot show whether it converges",
                           value, e.p_th);
    std::string text =
        e.convergence == Convergence::scattered
            ? fmt::format(
                  "not converged (scattered): {}, a bound: the values scatter by more than they change from "
                  "size to size",
                  value)
            : fmt::format("converged ({}{}): {} by {}", to_string(e.convergence),
                          std::isfinite(e.order) ? fmt::format(", order {:.2f}", e.order) : "", value, e.method);
    if (e.disagreement > 2) text += fmt::format("; the methods differ by a factor {:.1f}", e.disagreement);
    return text;
}

}  // namespace tw
