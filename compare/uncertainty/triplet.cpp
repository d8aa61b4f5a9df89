#include "compare/uncertainty/triplet.h"

#include <cmath>

namespace tw {
namespace {

/// ln|eps32/eps21| of phi = phi0 + a h^p (s = 1), or with a of alternating sign (s = -1):
///   p ln r21 + ln[(r32^p - s)/(r21^p - s)]     written so that no power overflows
double log_change(double p, double r21, double r32, double s) {
    const double a = p * std::log(r21), b = p * std::log(r32);
    return b + std::log1p(-s * std::exp(-b)) - std::log1p(-s * std::exp(-a));
}

/// The p > 0 with log_change(p) = target. Celik's fixed point p <- (target + q(p)) / ln r21 runs away for r32 > r21^2;
/// the equation is the same and log_change grows with p, so the root is bracketed and halved.
double solve_order(double target, double r21, double r32, double s) {
    double low = 0, high = 1;
    while (log_change(high, r21, r32, s) < target) low = high, high *= 2;
    for (int k = 0; k < 200 && high - low > 1e-15 * high; ++k) {
        const double middle = 0.5 * (low + high);
        (log_change(middle, r21, r32, s) < target ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double relative(double difference, double value) { return value != 0 ? std::abs(difference / value) : nan; }

/// What follows from the two finest levels once p and Fs are known. r^p - 1 is taken as expm1(p ln r): p may be small.
void finest_pair(CelikGci& g, const StudyLevel& l1, const StudyLevel& l2) {
    const double r21_p_less_1 = std::expm1(g.p * std::log(l2.h / l1.h));
    const double eps21 = l2.value - l1.value;
    g.known = true;
    g.phi_ext = l1.value - eps21 / r21_p_less_1;
    g.e_a = relative(eps21, l1.value);
    g.e_ext = relative(g.phi_ext - l1.value, g.phi_ext);
    g.GCI21 = g.Fs * g.e_a / r21_p_less_1;
    g.uncertainty = g.Fs * std::abs(eps21) / r21_p_less_1;
}

}  // namespace

Triplet finest_triplet(std::span<const StudyLevel> levels) {
    const StudyLevel &l1 = levels[0], &l2 = levels[1], &l3 = levels[2];
    Triplet t;
    t.r21 = l2.h / l1.h;
    t.r32 = l3.h / l2.h;
    t.eps21 = l2.value - l1.value;
    t.eps32 = l3.value - l2.value;
    const double size = largest_magnitude(levels.first(3));
    if (same_but_for_rounding(l1, l2, size)) {
        t.convergence = Convergence::unchanged;
        return t;
    }
    if (same_but_for_rounding(l2, l3, size)) {
        t.convergence = Convergence::divergent;
        return t;
    }
    t.R = t.eps21 / t.eps32;
    const double s = t.R > 0 ? 1 : -1;
    const double largest_R = s > 0 ? std::log(t.r21) / std::log(t.r32) : 1;
    if (std::abs(t.R) >= largest_R * (1 - 1e-9)) {
        t.convergence = Convergence::divergent;
        return t;
    }
    t.convergence = s > 0 ? Convergence::monotone : Convergence::oscillatory;
    t.p = solve_order(-std::log(std::abs(t.R)), t.r21, t.r32, s);
    return t;
}

CelikGci celik_gci(std::span<const StudyLevel> levels) {
    CelikGci g;
    if (levels.size() < 3) {
        g.why_not = "needs three sizes";
        return g;
    }
    const Triplet t = finest_triplet(levels);
    g.convergence = t.convergence;
    if (t.convergence == Convergence::unchanged) {
        g.why_not = "the two finest values are equal: no order can be found";
        return g;
    }
    if (t.convergence == Convergence::divergent) {
        g.why_not = "the changes between the three finest sizes do not decrease";
        return g;
    }
    g.p = t.p;
    g.Fs = 1.25;
    finest_pair(g, levels[0], levels[1]);
    g.GCI32 = g.Fs * relative(t.eps32, levels[1].value) / std::expm1(t.p * std::log(t.r32));
    g.asymptotic = g.GCI32 / (std::pow(t.r21, t.p) * g.GCI21);
    return g;
}

CelikGci two_level_gci(std::span<const StudyLevel> levels, double p) {
    CelikGci g;
    g.p = p;
    g.Fs = 3;
    finest_pair(g, levels[0], levels[1]);
    return g;
}

XingStern xing_stern(std::span<const StudyLevel> levels, double p_th) {
    XingStern x;
    if (levels.size() < 3) {
        x.why_not = "needs three sizes";
        return x;
    }
    const Triplet t = finest_triplet(levels);
    x.convergence = t.convergence;
    if (t.convergence != Convergence::monotone) {
        x.why_not = "for monotone convergence only";
        return x;
    }
    x.known = true;
    x.p = t.p;
    x.P = t.p / p_th;
    x.delta_RE = t.eps21 / std::expm1(t.p * std::log(t.r21));
    x.factor = x.P <= 1 ? 2.45 - 0.85 * x.P : 16.4 * x.P - 14.8;
    x.limit = levels[0].value - x.delta_RE;
    x.uncertainty = x.factor * std::abs(x.delta_RE);
    return x;
}

}  // namespace tw
