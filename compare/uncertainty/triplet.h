#pragma once
#include <span>
#include <string>

#include "base/numbers.h"
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
    double r21 = 0, r32 = 0;                         ///< [-]
    double eps21 = 0, eps32 = 0;                     ///< [unit of the value]
    double R = nan;                                  ///< [-]
    Convergence convergence = Convergence::unknown;  ///< unchanged, monotone, oscillatory or divergent
    double p = nan;                                  ///< [-], > 0; only where monotone or oscillatory
};
/// `levels`: three or more, as from finest_first; only the first three count.
Triplet finest_triplet(std::span<const StudyLevel> levels);

// What the literature makes of the three finest levels. Shown beside the estimate, and not used in it, but for
// two levels.

/// Grid convergence index, Celik et al., J. Fluids Eng. 130, 078001 (2008), doi 10.1115/1.2960953, on the three finest
/// levels, with p, r21, eps21 as in Triplet:
///
///   phi_ext = (r21^p phi1 - phi2)/(r21^p - 1)      e_a = |eps21/phi1|      e_ext = |(phi_ext - phi1)/phi_ext|
///   GCI21   = Fs e_a/(r21^p - 1)                   GCI32 = Fs |eps32/phi2|/(r32^p - 1)             Fs = 1.25
///
/// GCI32/(r21^p GCI21) is near 1 in the asymptotic range. Oscillatory convergence goes in with s = -1, as the paper
/// does; divergence and two equal finest values have no order and no index.
struct CelikGci {
    bool known = false;
    std::string why_not;  ///< empty where known
    Convergence convergence = Convergence::unknown;
    double p = nan;            ///< observed order; the assumed one where only two levels are used [-]
    double Fs = nan;           ///< [-]
    double phi_ext = nan;      ///< extrapolated value [unit of the value]
    double e_a = nan;          ///< approximate relative error [-]
    double e_ext = nan;        ///< extrapolated relative error [-]
    double GCI21 = nan;        ///< of the finest level [-]; not a number where phi1 = 0
    double GCI32 = nan;        ///< of the second level [-]
    double asymptotic = nan;   ///< GCI32/(r21^p GCI21) [-]
    double uncertainty = nan;  ///< GCI21 |phi1|: of the finest value [unit of the value]
};
/// `levels`: as from finest_first; fewer than three: not known.
CelikGci celik_gci(std::span<const StudyLevel> levels);

/// The index of the two finest levels with an assumed order p > 0: Fs = 3, class unknown (Roache 1994,
/// doi 10.1115/1.2910291). `levels`: two or more, as from finest_first.
CelikGci two_level_gci(std::span<const StudyLevel> levels, double p);

/// Factor of safety method, Xing & Stern, J. Fluids Eng. 132, 061403 (2010), doi 10.1115/1.4001771, on the three finest
/// levels, with p, r21, eps21 as in Triplet:
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
    double limit = nan;        ///< phi1 - delta_RE, the sign as in Triplet [unit of the value]
    double uncertainty = nan;  ///< U of the finest value [unit of the value]
};
/// `levels`: as from finest_first; fewer than three: not known. `p_th` > 0: the order of the scheme [-].
XingStern xing_stern(std::span<const StudyLevel> levels, double p_th);

}  // namespace tw
