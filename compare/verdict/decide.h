#pragma once
#include <cmath>

#include "compare/compare.h"

namespace tw {

/// The decision behind every verdict of a ladder, of a difference E with the half width U of its 95 % interval and a size S of the
/// values (E and U as in ASME V&V 20 and ITTC 7.5-02-01-01):
///
///   |E| >  U                       differ
///   |E| <= U  and  U <= target S   agree
///   |E| <= U  and  U >  target S   undecided
inline Verdict decide(double E, double U, double target, double S) {
    if (std::abs(E) > U) return Verdict::differ;
    return U <= target * S ? Verdict::agree : Verdict::undecided;
}

}  // namespace tw
