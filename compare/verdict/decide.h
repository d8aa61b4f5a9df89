#pragma once
#include <cmath>

#include "compare/compare.h"

namespace tw {

/// Whether an interval holds a value from elsewhere, however small the difference is: differ where it does not, else agree,
/// or undecided where it is wider than the target.
inline Verdict holds(double E, double U, double target, double S) {
    if (std::abs(E) > U) return Verdict::differ;
    return U <= target * S ? Verdict::agree : Verdict::undecided;
}

/// The decision behind every verdict of a ladder, of a difference E with the half width U of its 95 % interval and a size S of the
/// values (E and U as in ASME V&V 20 and ITTC 7.5-02-01-01):
///
///   |E| + U <= target S            agree: all that the interval holds is within the target
///   |E| >  U                       differ
///   |E| <= U  and  U <= target S   agree
///   |E| <= U  and  U >  target S   undecided
inline Verdict decide(double E, double U, double target, double S) {
    if (std::abs(E) + U <= target * S) return Verdict::agree;
    return holds(E, U, target, S);
}

}  // namespace tw
