#pragma once
#include <algorithm>
#include <cmath>

#include "compare/compare.h"

namespace tw {

/// Whether an interval holds a value from elsewhere, however small the difference is: differ where it does not, else agree,
/// or undecided where it is wider than the target.
inline Verdict holds(double E, double U, double target, double S) {
    if (std::abs(E) > U) return Verdict::differ;
    return U <= target * S ? Verdict::agree : Verdict::undecided;
}

/// The decision behind every verdict of a grid study, of a difference E with the half width U of its 95 % interval and
/// a size S of the values (E and U as in ASME V&V 20 and ITTC 7.5-02-01-01):
///
///   |E| + U <= target S            agree: all that the interval holds is within the target
///   |E| >  U                       differ
///   |E| <= U  and  U <= target S   agree
///   |E| <= U  and  U >  target S   undecided
///
/// An interval wider than widest_answer of the value (and than the target) is judged in no way: it is known too roughly
/// to say whether a difference lies outside it.
inline constexpr double widest_answer = 0.3;
inline Verdict decide(double E, double U, double target, double S) {
    if (std::abs(E) + U <= target * S) return Verdict::agree;
    if (U > std::max(target, widest_answer) * S) return Verdict::no_answer;
    return holds(E, U, target, S);
}

/// Fills difference, interval, per_cent, verdict and remark of a quantity from its values:
///
///   E = S_B - S_A      U = sqrt(U_A^2 + U_B^2 + U_shared^2)      S = max(|mean of the two|, scale)
///   both values known              not estimated: U is statistics, so it says nothing of the discretisation error
///   a record too short             undecided, with the time that is missing
///   a value missing                not comparable
///
/// (ITTC / ASME V&V style E_n = |E| / U; shared inputs cancel and are not added.) `shared`: half width of what both
/// sides share and yet may hold differently, e.g. the draft [unit of the quantity]. Of more than two sources every pair
/// is judged, and the quantity as a whole is the pair with the largest |E| / U. Whether two methods agree is for a grid
/// study to say (grid_study/grid_study.h); where U alone is above the target, the remark names what makes it so wide.
void judge(Quantity& quantity, const std::vector<std::string>& names, double target, double shared = 0,
           const std::string& shared_name = {});

/// Every pair of more than two sources, in their order, with nothing known of it yet.
std::vector<Difference> pairs_of(std::size_t sources);
/// Of more than two sources: makes the pair that is farthest apart the quantity's own.
void take_farthest(Quantity& quantity);

/// For numbers that stand beside the verdict: difference and interval of two known values, no verdict.
void beside(Quantity& quantity);

/// The place among differences of the one that is farthest from 0 in units of its interval; 0 where none is known.
template <class Differences>
std::size_t farthest_apart(const Differences& all) {
    std::size_t at = 0;
    double largest = -1;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const double e = std::abs(all[k].difference), u = all[k].interval;
        const double ratio = e == 0 ? 0 : u > 0 ? e / u : HUGE_VAL;
        if (std::isfinite(e) && !std::isnan(u) && ratio > largest) largest = ratio, at = k;
    }
    return at;
}

}  // namespace tw
