#include "compare/uncertainty/triplet_estimates.h"

#include <cmath>

#include "compare/uncertainty/triplet.h"

namespace tw {

namespace {

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
