#pragma once
#include "compare/compare.h"

namespace tw {

/// Fills difference, interval, per_cent, verdict and remark of a quantity from its values:
///
///   E = S_B - S_A      U = sqrt(U_A^2 + U_B^2 + U_shared^2)      S = max(|mean of the two|, scale)
///   both values known              not estimated: U is statistics, so it says nothing of the discretisation error
///   a record too short             undecided, with the time that is missing
///   a value missing                not comparable
///
/// (ITTC / ASME V&V style E_n = |E| / U; shared inputs cancel and are not added.) `shared`: half width of what both
/// sides share and yet may hold differently, e.g. the draft [unit of the quantity]. With more than two known sources
/// the pair with the largest |E| / U is taken. Whether two methods agree is for a ladder to say (ladder/ladder.h); where
/// U alone is above the target, the remark names what makes it so wide.
void judge(Quantity& quantity, const std::vector<std::string>& names, double target, double shared = 0,
           const std::string& shared_name = {});

/// For numbers that stand beside the verdict: difference and interval of two known values, no verdict.
void beside(Quantity& quantity);

}  // namespace tw
