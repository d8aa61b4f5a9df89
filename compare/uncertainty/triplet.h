#pragma once
#include <limits>
#include <span>

#include "compare/uncertainty/study_level.h"

namespace tw {

/// What the three finest levels show, h1 < h2 < h3, r21 = h2/h1, r32 = h3/h2, eps21 = phi2 - phi1, eps32 = phi3 - phi2:
/// the class by R = eps21/eps32 (ITTC 7.5-03-01-01), and the observed order p (Celik et al. 2008,
/// doi 10.1115/1.2960953):
///
///   p = |ln|eps32/eps21| + q(p)| / ln r21       q(p) = ln[(r21^p - s)/(r32^p - s)]       s = sign(eps32/eps21)
///
/// The ITTC's limit between monotone convergence and divergence is R = 1, for equal ratios. For unequal ones the same
/// limit, p = 0, lies at R = ln r21 / ln r32: a value that goes as ln h changes by that much and has no limit. For
/// alternating signs p = 0 is |R| = 1 with any ratios.
struct Triplet {
    double r21 = 0, r32 = 0;      ///< [-]
    double eps21 = 0, eps32 = 0;  ///< [unit of the value]
    double R = std::numeric_limits<double>::quiet_NaN();
    Convergence convergence = Convergence::unknown;       ///< unchanged, monotone, oscillatory or divergent
    double p = std::numeric_limits<double>::quiet_NaN();  ///< > 0; only where monotone or oscillatory
};
/// `levels`: three or more, as from finest_first; only the first three count.
Triplet finest_triplet(std::span<const StudyLevel> levels);

}  // namespace tw
