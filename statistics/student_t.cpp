#include "statistics/student_t.h"

#include <boost/math/distributions/students_t.hpp>

namespace tw {
namespace {

namespace policies = boost::math::policies;
/// Double precision throughout, and NaN for NaN.
using Policy = policies::policy<policies::promote_double<false>, policies::domain_error<policies::ignore_error>>;
using StudentT = boost::math::students_t_distribution<double, Policy>;

}  // namespace

double student_t_cdf(double t, double degrees) { return cdf(StudentT(degrees), t); }

double student_t_95(double degrees) { return quantile(StudentT(degrees), 0.975); }

IndependentMean mean_of_independent(std::span<const double> values) {
    if (values.empty()) return {};
    const auto n = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (const double v : values) mean += v / n;
    for (const double v : values) squares += (v - mean) * (v - mean);
    return {mean, n > 1 ? student_t_95(n - 1) * std::sqrt(squares / (n - 1) / n) : NAN};
}

}  // namespace tw
