#pragma once
#include <functional>
#include <string>
#include <vector>

#include "compare/uncertainty/convergence.h"
#include "tests/verification/uncertainty/known_families.h"

namespace tw::test {

/// A family with what is estimated of it.
struct Estimated {
    KnownFamily family;
    Estimate estimate;
};
std::vector<Estimated> estimate_all(std::vector<KnownFamily> families);

/// One of the estimators: its U of the finest value; nan where it gives none.
struct Estimator {
    std::string name;
    std::function<double(const Estimate&)> U;
};
extern const std::vector<Estimator> estimators;  ///< the headline first

/// How often |phi_1 - truth| <= U.
struct Coverage {
    std::size_t families = 0, given = 0, held = 0;
    std::vector<double> widths;  ///< U of the families that have one [per cent of the truth, of 1 where it is 0]
    double share_given() const { return 100.0 * static_cast<double>(given) / static_cast<double>(families); }
    double share_held() const { return 100.0 * static_cast<double>(held) / static_cast<double>(given); }
    double median_width() const;  ///< nan where none is given
};
Coverage coverage_of(
    const std::vector<Estimated>& all, const Estimator& estimator,
    const std::function<bool(const Estimated&)>& which = [](const Estimated&) { return true; });

/// Whether the interval holds the truth, rounding aside.
bool holds_truth(const Estimated& e, double U);

}  // namespace tw::test
