#pragma once
#include <string>
#include <vector>

#include "compare/compare.h"
#include "text/unit_text.h"

namespace tw {

/// plain_number with a minus sign in place of the hyphen; for people, not for files.
std::string number_text(double value, int digits = 3);
/// unit_text within the brackets of a label: "area [m²]" of "area [m2]".
std::string label_text(const std::string& label);

/// A value to the digits its interval supports: 2722 +- 13, 0.412 +- 0.025; four digits where there is no interval.
std::string value_text(double value, double half_width);
/// "2722 ± 13" with the widest interval known, "2722, no interval" where sizes gave none, "–" when not known.
std::string mean_text(const MeanValue& mean);
std::string signed_text(double value, double half_width);  ///< with sign
std::string per_cent_text(double per_cent);                ///< "+3.2 %", "–" when not finite
/// "+3.2 ± 9.0 %", "+3.2 %, no interval" without one, "–" when not finite.
std::string per_cent_text(double per_cent, double interval);
inline constexpr double least_per_cent = 0.01;  ///< of a size in per cent that words tell from nothing
/// Whether per cent of `size` tell how far two values are apart. They do not where the difference is more than the size:
/// one value is then less than a third of the other, or of the other sign; nor where size is a scale above both.
bool told_in_per_cent(double a, double b, double size);
/// The same as per_cent_text of two methods' difference over a size: "too far apart for per cent" where it is more than
/// that. `of`: what the size is, where it is not the values' mean.
std::string difference_text(double per_cent, double interval, const std::string& of = {});
/// " of 0.088 m" where per cent refer to a scale of the quantity, since its values are smaller; else empty.
std::string of_scale(double size, double a, double b, const std::string& unit);
std::string share_text(double per_cent);  ///< a size in per cent without sign: "9.0 %", "23 %", at least "0.01 %"
/// "× 2.3", "more than × 1000", "less than × 0.001".
std::string factor_text(double factor);
/// Shorter times are "under 0.01 s", longer ones "more than a year" [s].
inline constexpr double least_time = 0.01, most_time = 3e7;
/// Seconds as people say them: "42 s", "13 min", "2.4 h", "9 days".
std::string time_text(double seconds);
std::string about_text(double seconds);      ///< "about 13 min"; without "about" where time_text gives a bound
std::string verdict_label(Verdict verdict);  ///< "agree", "not converged", "discretisation error not estimated", ...

}  // namespace tw
