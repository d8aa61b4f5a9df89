#include "tests/verification/uncertainty/coverage.h"

#include <algorithm>
#include <cmath>

namespace tw::test {

const std::vector<Estimator> estimators{
    {"headline: trend and noise", [](const Estimate& e) { return e.uncertainty; }},
    {"Eca & Hoekstra", [](const Estimate& e) { return e.eca_hoekstra.uncertainty; }},
    {"GCI", [](const Estimate& e) { return e.celik_gci.uncertainty; }},
    {"factor of safety", [](const Estimate& e) { return e.xing_stern.uncertainty; }},
};

std::vector<Estimated> estimate_all(std::vector<KnownFamily> families) {
    std::vector<Estimated> all;
    for (KnownFamily& family : families) {
        Estimate e = estimate(family.levels);
        all.push_back({std::move(family), std::move(e)});
    }
    return all;
}

bool holds_truth(const Estimated& e, double U) {
    return std::abs(e.estimate.levels[0].value - e.family.truth) <= U * (1 + 1e-9);
}

double Coverage::median_width() const {
    if (widths.empty()) return nan;
    std::vector<double> sorted = widths;
    std::ranges::sort(sorted);
    return 0.5 * (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]);
}

Coverage coverage_of(const std::vector<Estimated>& all, const Estimator& estimator,
                     const std::function<bool(const Estimated&)>& which) {
    Coverage c;
    for (const Estimated& e : all) {
        if (!which(e)) continue;
        ++c.families;
        const double U = estimator.U(e.estimate);
        if (!std::isfinite(U)) continue;
        ++c.given;
        c.held += holds_truth(e, U);
        c.widths.push_back(100 * U / (e.family.truth != 0 ? std::abs(e.family.truth) : 1));
    }
    return c;
}

}  // namespace tw::test
