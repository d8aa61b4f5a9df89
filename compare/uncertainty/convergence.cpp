#include "compare/uncertainty/convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.h"
#include "compare/report/numbers.h"
#include "compare/uncertainty/triplet.h"
#include "statistics/student_t.h"
#include "text/plain_number.h"

namespace tw {

namespace {

constexpr double least_order = 0.5;         ///< observed order below which changes hardly die out, as in eca_hoekstra.h
constexpr double no_order = 0.1;            ///< below which a change from size to size is not told from one that stays
constexpr double largest_of_order = 2;      ///< observed order over the scheme's above which it is coincidence
constexpr double rounding_of_order = 1e-6;  ///< so that exact values of h^0.5 count as inside

std::string of_three(std::span<const StudyLevel> levels) {
    const Triplet t = finest_triplet(levels);
    const double l21 = std::log(t.r21), l32 = std::log(t.r32), finest = t.eps21 / l21, coarser = t.eps32 / l32;
    if (t.convergence == Convergence::unchanged || coarser == 0 || !(finest / coarser >= 2 * (1 - 1e-9))) return {};
    // The half width of finest - 2 coarser, of the values' own noise and rounding.
    const double of_1 = 1 / l21, of_2 = 1 / l21 + 2 / l32, of_3 = 2 / l32;
    const double U = std::hypot(levels[0].half_width * of_1, levels[1].half_width * of_2, levels[2].half_width * of_3) +
                     levels[0].rounding * of_1 + levels[1].rounding * of_2 + levels[2].rounding * of_3;
    if (std::abs(finest - 2 * coarser) < U) return {};
    return fmt::format("the changes grow {:.2g}-fold from the coarser pair of sizes to the finest", finest / coarser);
}

/// |b|/s_b of phi = c + b ln h by least squares; infinite where the values lie on the line.
double significance_of_slope(std::span<const StudyLevel> levels) {
    const auto n = static_cast<double>(levels.size());
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (const StudyLevel& l : levels) x += std::log(l.h) / n, y += l.value / n;
    for (const StudyLevel& l : levels) {
        const double dx = std::log(l.h) - x, dy = l.value - y;
        xx += dx * dx, xy += dx * dy, yy += dy * dy;
    }
    const double RSS = std::max(0.0, yy - xy * xy / xx);
    return std::abs(xy / xx) / std::sqrt(RSS / (n - 2) / xx);
}

/// Why the values run away as the spacing shrinks, and have no limit that could be estimated; empty where they do not,
/// and where they are equal within their own noise and rounding (equal_within_noise in study_level.h).
/// - three levels: they change to one side, and per factor in h the finest pair by twice as much as the coarser one or
///   more: eps21/ln r21 >= 2 eps32/ln r32, the growth of 1/h between h and 2 h. (Three values of pure noise do that in
///   one trial of ten; with the ITTC's R >= 1 it is one of six.) Where the values have noise of their own, as time means
///   do, the excess has to lie beyond its 95 % interval.
/// - more: the free fit of Eca & Hoekstra has p <= 0, and phi = c + b ln h, the border of divergence, has a slope
///   beyond its 95 % interval, t = |b|/s_b > t_95(n - 2); without that test one family of seven that only scatters
///   would be refused.
/// `eca` of the same levels, which are as from finest_first.
std::string why_running_away(std::span<const StudyLevel> levels, const EcaHoekstra& eca) {
    if (equal_within_noise(levels)) return {};
    if (levels.size() == 3) return of_three(levels);
    if (eca.convergence != Convergence::divergent) return {};
    const double t = significance_of_slope(levels), t_95 = student_t_95(static_cast<double>(levels.size()) - 2);
    return t > t_95 ? eca.why_not : "";
}

void from_one_level(Estimate& e) {
    e.why_not = "one size alone does not show the discretisation error; two or more are needed";
}

void from_two_levels(Estimate& e) {
    e.celik_gci = two_level_gci(e.levels, e.p_th);
    e.method = "GCI of two sizes, order assumed, Fs = 3";
    e.order = e.p_th;
    e.limit = e.celik_gci.phi_ext;
    e.uncertainty = e.celik_gci.uncertainty;
    const double error = std::abs(e.levels[0].value - e.limit);
    for (const StudyLevel& l : e.levels)
        e.uncertainties.push_back(error > 0 ? e.uncertainty * std::abs(l.value - e.limit) / error : e.uncertainty);
}

double smallest_order(const Estimate& e) { return least_order * std::min(1.0, e.p_th); }
double largest_order(const Estimate& e) { return largest_of_order * std::max(2.0, e.p_th); }

/// Observed order: of Eca & Hoekstra's fit where there is one; of alternating values, to which it does not apply, that of
/// the three finest.
double order_of(const Estimate& e, Convergence found) {
    return e.levels.size() > 3 && found != Convergence::oscillatory ? e.eca_hoekstra.p : e.celik_gci.p;
}

/// The class by the three finest levels alone, or by Eca & Hoekstra's fit; where their order says nothing: scattered.
Convergence class_of(const Estimate& e) {
    if (equal_within_noise(e.levels)) return Convergence::unchanged;
    const bool many = e.levels.size() > 3;
    const Convergence found = many ? e.eca_hoekstra.convergence : e.celik_gci.convergence;
    const double p = order_of(e, found);
    switch (found) {
        case Convergence::divergent: return Convergence::scattered;
        case Convergence::unchanged: return Convergence::irregular;  // the two finest are equal, a coarser one is not
        case Convergence::oscillatory:
            if (p < smallest_order(e)) return Convergence::scattered;
            break;
        case Convergence::monotone:
            if (!many && p < std::min(no_order, smallest_order(e))) return Convergence::scattered;
            break;
        default: return found;
    }
    const bool credible = p > smallest_order(e) - rounding_of_order && p < largest_order(e) + rounding_of_order;
    return credible ? found : Convergence::irregular;  // NaN: beyond the search
}

void from_many_levels(Estimate& e) {
    e.why_not = why_running_away(e.levels, e.eca_hoekstra);
    if (!e.why_not.empty()) {
        e.convergence = Convergence::divergent;
        return;
    }
    e.convergence = class_of(e);
    e.method = "trend and noise";
    if (e.convergence != Convergence::scattered && e.convergence != Convergence::unchanged)
        e.order = order_of(e, e.levels.size() > 3 ? e.eca_hoekstra.convergence : e.celik_gci.convergence);
    e.limit = e.trend_noise.phi0;
    e.uncertainty = e.trend_noise.uncertainty;
    e.uncertainties = e.trend_noise.uncertainties;
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
    return known > 1 ? high / low : nan;
}

/// "1.0511 ± 0.060 (5.7 %)": the value to the digits that its uncertainty supports. Per cent of a value that is nothing
/// beside its uncertainty say nothing.
std::string value_with_uncertainty(double value, double U) {
    const std::string share = U <= std::abs(value) && value != 0
                                  ? " (" + plain_number(100 * U / std::abs(value), 2) + " %)"
                              : U > 0 ? " (more than the value)"
                                      : "";
    const auto in_digits = [&] { return fmt::format("{} ± {}{}", number_text(value, 6), plain_number(U, 2), share); };
    if (!(U > 1e-9 * std::abs(value))) return in_digits();
    const int last_digit = static_cast<int>(std::floor(std::log10(U))) - 1;  // the second of U
    const double size = std::max(std::abs(value), U);
    if (size >= 1e7 || size < 1e-3) return in_digits();
    const int places = std::clamp(-last_digit, 0, 9);
    if (std::abs(value) < 0.5 * std::pow(10.0, -places)) return fmt::format("0 ± {:.{}f}{}", U, places, share);
    return fmt::format("{}{:.{}f} ± {:.{}f}{}", value < 0 ? "−" : "", std::abs(value), places, U, places, share);
}

/// Two digits, without a power of ten where there is a plain form.
std::string two_digits(double x) { return x >= 99.5 && x < 1e7 ? fmt::format("{:.0f}", x) : fmt::format("{:.2g}", x); }

std::string scatter_sentence(const Estimate& e, const std::string& value) {
    const double size = std::abs(e.levels[0].value), sigma = e.trend_noise.sigma;
    const std::string share = size > 0 ? " (" + plain_number(100 * sigma / size, 2) + " %)" : "";
    const double bound = e.eca_hoekstra.uncertainty;
    return fmt::format("no order is seen (scatter of {}{} from size to size): {} by {}{}", two_digits(sigma), share,
                       value, e.method,
                       std::isfinite(bound) ? "; the bound of Eca & Hoekstra is ± " + two_digits(bound) : "");
}

std::string irregular_sentence(const Estimate& e, const std::string& value) {
    const std::string found = std::isfinite(e.order) ? fmt::format("{:.2f}", e.order)
                              : e.celik_gci.convergence == Convergence::unchanged
                                  ? std::string("none, the two finest values being equal,")
                                  : std::string("one beyond 10");
    return fmt::format("not converged (order {} found, {:.2g} to {:.2g} expected of a scheme of order {:g}): {} by {}",
                       found, smallest_order(e), largest_order(e), e.p_th, value, e.method);
}

}  // namespace

const std::vector<std::string>& uncertainty_methods() {
    static const std::vector<std::string> methods{"trend_and_noise", "eca_hoekstra", "gci", "factor_of_safety"};
    return methods;
}

std::string uncertainty_method_label(const std::string& method) {
    static const std::array labels{"trend and noise", "Eça & Hoekstra", "GCI", "factor of safety"};
    const auto at = std::ranges::find(uncertainty_methods(), method);
    return at == uncertainty_methods().end() ? method
                                             : labels.at(static_cast<std::size_t>(at - uncertainty_methods().begin()));
}

std::vector<MethodEstimate> method_estimates(const Estimate& e) {
    const std::vector<std::string>& names = uncertainty_methods();
    const TrendNoise& trend = e.trend_noise;
    const EcaHoekstra& eca = e.eca_hoekstra;
    const CelikGci& gci = e.celik_gci;
    const XingStern& fs = e.xing_stern;
    const std::size_t n = e.levels.size(), three = std::min<std::size_t>(n, 3);
    return {{names[0], n, nan, e.convergence, trend.phi0, trend.uncertainty, trend.why_not},
            {names[1], n, eca.p, eca.convergence, eca.phi0, eca.uncertainty, eca.why_not},
            {names[2], three, gci.p, gci.convergence, gci.phi_ext, gci.uncertainty, gci.why_not},
            {names[3], three, fs.p, fs.convergence, fs.limit, fs.uncertainty, fs.why_not}};
}

Estimate estimate(std::vector<StudyLevel> levels, double p_th) {
    if (!(p_th >= 0.1 && p_th <= 10))
        throw InputError(fmt::format("order of the scheme {} found; expected a number from 0.1 to 10", p_th));
    Estimate e;
    e.levels = finest_first(std::move(levels));
    e.p_th = p_th;
    e.eca_hoekstra = eca_hoekstra(e.levels);
    e.celik_gci = celik_gci(e.levels);
    e.xing_stern = xing_stern(e.levels, p_th);
    e.trend_noise = trend_noise(e.levels, p_th);
    switch (e.levels.size()) {
        case 1: from_one_level(e); break;
        case 2: from_two_levels(e); break;
        default: from_many_levels(e);
    }
    e.converged = e.convergence == Convergence::unchanged || e.convergence == Convergence::monotone ||
                  e.convergence == Convergence::oscillatory;
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
        return fmt::format("{} by an assumed order {:g} with Fs = 3: two sizes cannot show whether it converges", value,
                           e.p_th);
    if (e.convergence == Convergence::scattered) return scatter_sentence(e, value);
    if (e.convergence == Convergence::irregular) return irregular_sentence(e, value);
    if (e.convergence == Convergence::unchanged)
        return fmt::format(
            "converged (unchanged from size to size within the values' own {}): {} by {}",
            std::ranges::any_of(e.levels, [](const StudyLevel& l) { return l.half_width > 0; }) ? "noise" : "rounding",
            value, e.method);
    std::string text =
        fmt::format("converged ({}{}): {} by {}", to_string(e.convergence),
                    std::isfinite(e.order) ? fmt::format(", order {:.2f}", e.order) : "", value, e.method);
    if (e.disagreement > 2) text += fmt::format("; the other methods differ by a factor {:.1f}", e.disagreement);
    return text;
}

}  // namespace tw
