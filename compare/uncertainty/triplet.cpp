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

}  // namespace tw
