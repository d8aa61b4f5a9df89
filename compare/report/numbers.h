#pragma once
#include <string>

#include "compare/compare.h"

namespace tw {

/// A value to the digits its interval supports: 2722 +- 13, 0.412 +- 0.025; four digits where there is no interval.
std::string value_text(double value, double half_width);
std::string mean_text(const MeanValue& mean);              ///< "2722 ± 13", or "–" when not known
std::string signed_text(double value, double half_width);  ///< with sign
std::string per_cent_text(double per_cent);                ///< "+3.2 %", "–" when not finite
std::string verdict_label(Verdict verdict);  ///< "agree", "not converged", "discretisation error not estimated", ...

/// The comparison as one sentence: how far apart the main quantities are (lift, drag, splash height). No word of
/// agreement: that needs a ladder.
std::string verdict_sentence(const Comparison& comparison);

}  // namespace tw
