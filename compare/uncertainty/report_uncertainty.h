#pragma once
#include <string>
#include <vector>

#include "compare/uncertainty/convergence.h"

namespace tw {

/// One quantity of a refinement study and what was found of it.
struct QuantityEstimate {
    std::string name;  ///< with its unit, as the user wrote it: "drag [N]"
    Estimate estimate;
};

/// For people: per quantity a heading, a markdown table with a row per method (levels used, observed order, class,
/// value at zero spacing, U in the value's unit and in per cent of the finest value), what was not computed and why,
/// and the verdict as one line.
std::string uncertainty_text(const std::vector<QuantityEstimate>& quantities, const std::string& spacing_name);

/// The same for programs: `quantities` with the methods in `trend_and_noise`, `eca_hoekstra`, `celik_gci` and
/// `factor_of_safety`, each with `order`, `limit`, `uncertainty`, `class` and what else the method knows. Where there is one quantity
/// they also stand at the top. Numbers that are not known are null.
std::string uncertainty_json(const std::vector<QuantityEstimate>& quantities, const std::string& spacing_name);

}  // namespace tw
