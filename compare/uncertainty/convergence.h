#pragma once
#include <string>
#include <vector>

#include "base/numbers.h"
#include "compare/uncertainty/eca_hoekstra.h"
#include "compare/uncertainty/study_level.h"
#include "compare/uncertainty/trend_noise.h"
#include "compare/uncertainty/triplet.h"

namespace tw {

struct Estimate;

/// The estimate of one method from the sizes of a study.
struct MethodEstimate {
    std::string method;      ///< one of uncertainty_methods()
    std::size_t levels = 0;  ///< how many sizes it uses
    double order = nan;      ///< [-]; nan: none
    Convergence convergence = Convergence::unknown;
    double limit = nan, uncertainty = nan;  ///< [unit of the value]; nan: none
    std::string why_not;                    ///< why there is no uncertainty; empty where there is one
};
/// "trend_and_noise", "eca_hoekstra", "gci", "factor_of_safety".
const std::vector<std::string>& uncertainty_methods();
/// "trend and noise", "Eça & Hoekstra", "GCI", "factor of safety".
std::string uncertainty_method_label(const std::string& method);
/// The estimate of every method, in that order.
std::vector<MethodEstimate> method_estimates(const Estimate& estimate);

/// What a refinement study says of one quantity. The headline (limit, uncertainty) comes
/// - from three levels on from trend and noise (trend_noise.h): of the estimators here the only one whose intervals hold
///   the truth in 90 to 99 % of the cases with and without scatter (docs/results/coverage.md). The bound of Eca &
///   Hoekstra, the GCI and the factor of safety stand beside it;
/// - with two from the GCI with the assumed order p_th and Fs = 3, which cannot show whether anything converges;
/// - with one: none.
/// The class is that of Eca & Hoekstra from four levels on, else that of the triplet. Scattered: no order can be found
/// (sigma of the fit above the mean change per level; of three levels an oscillation of order below 0.5, changes that
/// do not shrink); the interval then comes from the scatter. Irregular: the changes die out with an order p that is not
/// the scheme's, or the two finest values are equal and a coarser one is not. What remains of the error beyond the last
/// change is 1/(r^p - 1) of that change: with p below 0.5 min(1, p_th) more than twice it (r = 2), which is no
/// convergence (Eca & Hoekstra trust no p below 0.5 either); with p above 2 max(2, p_th) next to nothing, which only
/// happens where terms cancel or the coarser sizes do not resolve what carries the answer. The interval is that of trend
/// and noise, which does not use p. Divergent is left for values that run away (why_running_away in convergence.cpp): they have no uncertainty.
struct Estimate {
    std::vector<StudyLevel> levels;  ///< finest first
    double p_th = 2;                 ///< order of the scheme [-]
    Convergence convergence = Convergence::unknown;
    bool converged = false;    ///< three levels or more that are unchanged, monotone or oscillatory
    std::string method;        ///< where the headline comes from; empty where there is none
    double order = nan;        ///< [-]
    double limit = nan;        ///< value at zero spacing [unit of the value]
    double uncertainty = nan;  ///< U of the finest value, half width of a 95 % interval [unit of the value]; nan: none
    std::string why_not;       ///< why there is no uncertainty; empty where there is one
    /// U of every level, finest first [unit of the value]: trend_noise.h; with two levels
    /// U_1 |phi_i - limit|/|phi_1 - limit|. Empty where there is no uncertainty.
    std::vector<double> uncertainties;  ///< [unit of the value]; as many as levels, or none
    /// Largest over smallest U of Eca & Hoekstra, GCI and factor of safety, where two or more have one above 0 [-].
    double disagreement = nan;  ///< [-]
    TrendNoise trend_noise;
    EcaHoekstra eca_hoekstra;
    CelikGci celik_gci;  ///< the assumed order and Fs = 3 where there are two levels
    XingStern xing_stern;
};

/// `levels`: one or more, in any order. `p_th`: formal order of the scheme, from 0.1 to 10 [-].
/// Throws InputError for levels as in finest_first() and for a p_th outside its range.
Estimate estimate(std::vector<StudyLevel> levels, double p_th = 2);

/// The result as one sentence without the name of the quantity: "converged (monotone, order 1.56): 1.0511 +- 0.060
/// (5.7 %) by ...".
std::string verdict_sentence(const Estimate& estimate);

}  // namespace tw
