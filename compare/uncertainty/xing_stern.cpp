#include "compare/uncertainty/xing_stern.h"

#include <cmath>

#include "compare/uncertainty/triplet.h"

namespace tw {

XingStern xing_stern(std::span<const StudyLevel> levels, double p_th) {
    XingStern x;
    if (levels.size() < 3) {
        x.why_not = "needs three levels";
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
