#pragma once
#include <limits>
#include <string>
#include <vector>

#include "compare/uncertainty/celik_gci.h"
#include "compare/uncertainty/eca_hoekstra.h"
#include "compare/uncertainty/study_level.h"
#include "compare/uncertainty/xing_stern.h"

namespace tw {

/// What a refinement study says of one quantity. The headline (order, limit, uncertainty) comes
/// - from four levels on from the least squares of Eca & Hoekstra;
/// - with three from the widest of: the factor of safety; the GCI; where the observed order is above 1.05 p_th, and so
///   too good to be trusted, the two finest levels with p_th and Fs = 3 (Roache 2011, J. Fluids Eng. 133, 115501);
///   where oscillatory half the range of the three values (ITTC 7.5-03-01-01). An oscillation of observed order below
///   0.5 is hardly damped: scattered, with three times half the range as its bound. A monotone order below 0.1 is not
///   told from divergence;
/// - with two from the GCI with the assumed order p_th and Fs = 3, which cannot show whether anything converges;
/// - with one: none.
/// "Not converged" is a result like any other: divergent values have no uncertainty, scattered ones have one that is a
/// bound on what the scatter hides.
struct Estimate {
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<StudyLevel> levels;  ///< finest first
    double p_th = 2;            ///< order of the scheme [-]
    Convergence convergence = Convergence::unknown;
    bool converged = false;    ///< three levels or more that are unchanged, monotone or oscillatory
    std::string method;        ///< where the headline comes from; empty where there is none
    double order = nan;        ///< [-]
    double limit = nan;        ///< value at zero spacing [unit of the value]
    double uncertainty = nan;  ///< U of the finest value, half width of a 95 % interval [unit of the value]; nan: none
    std::string why_not;       ///< why there is no uncertainty; empty where there is one
    /// U of every level, finest first [unit of the value]: the least squares' own; with fewer than four levels
    /// U_1 |phi_i - limit|/|phi_1 - limit|. Empty where there is no uncertainty.
    std::vector<double> uncertainties;
    /// Largest over smallest of the three methods' U, where two or more have one above 0 [-].
    double disagreement = nan;
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
