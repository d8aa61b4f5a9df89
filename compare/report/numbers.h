#pragma once
#include <string>

#include "compare/compare.h"

namespace tw {

/// A value to the digits its interval supports: 2722 +- 13, 0.412 +- 0.025; four digits where there is no interval.
std::string value_text(double value, double half_width);
std::string mean_text(const MeanValue& mean);              ///< "2722 ± 13", or "–" when not known
std::string signed_text(double value, double half_width);  ///< with sign
std::string per_cent_text(double per_cent);                ///< "+3.2 %", "–" when not finite
std::string verdict_label(Verdict verdict);  ///< "agree", "differ", "undecided", "not converged", "not comparable"

/// The verdict as one sentence: which of the main quantities (lift, drag, splash height) agree, differ or are
/// undecided.
std::string verdict_sentence(const Comparison& comparison);

}  // namespace tw
