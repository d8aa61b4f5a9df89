#pragma once
#include <span>
#include <string>
#include <vector>

#include "base/numbers.h"

namespace tw {

/// A truth by formula: its parameters are keys of a quantity's [parameters].
struct TruthFormula {
    struct Parameter {
        std::string name, unit;
        double fallback = nan;  ///< nan: it has to be given [unit]
    };
    std::string name, unit;
    std::vector<Parameter> parameters;
    double (*value)(std::span<const double> parameters) = nullptr;
    std::string text;       ///< "rho g d"
    std::string source;     ///< of the formula
    double half_width = 0;  ///< of its 95 % interval, share of the value [-]; 0: exact
};
const std::vector<TruthFormula>& truth_formulas();
/// Null: there is none of this name.
const TruthFormula* find_formula(const std::string& name);
/// All of them with parameters and units, for people.
std::string formulas_text();

}  // namespace tw
