#pragma once
#include <span>
#include <string>

#include "base/numbers.h"
#include "compare/uncertainty/study_level.h"

namespace tw {

/// Factor of safety method, Xing & Stern, J. Fluids Eng. 132, 061403 (2010), doi 10.1115/1.4001771, on the three finest
/// levels, with p, r21, eps21 as in triplet.h:
///
///   delta_RE = eps21/(r21^p - 1)        P = p/p_th
///   U = (2.45 - 0.85 P) |delta_RE|      0 < P <= 1
///   U = (16.4 P - 14.8) |delta_RE|      P > 1
///
/// The factors hold the true error in 95 % of the paper's cases, where the GCI held 86 %. For monotone convergence
/// only: the paper's P says nothing about alternating signs.
struct XingStern {
    bool known = false;
    std::string why_not;  ///< empty where known
    Convergence convergence = Convergence::unknown;
    double p = nan;            ///< observed order [-]
    double P = nan;            ///< p over the scheme's order [-]
    double delta_RE = nan;     ///< error of the finest value by Richardson's extrapolation [unit of the value]
    double factor = nan;       ///< U over |delta_RE| [-]
    double limit = nan;        ///< phi1 - delta_RE, the sign as in triplet.h [unit of the value]
    double uncertainty = nan;  ///< U of the finest value [unit of the value]
};
/// `levels`: as from finest_first; fewer than three: not known. `p_th` > 0: the order of the scheme [-].
XingStern xing_stern(std::span<const StudyLevel> levels, double p_th);

}  // namespace tw
