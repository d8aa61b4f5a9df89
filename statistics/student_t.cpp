#include "statistics/student_t.h"

#include <boost/math/distributions/students_t.hpp>

namespace tw {
namespace {

namespace policies = boost::math::policies;
/// Double precision throughout, and NaN for NaN.
using Policy = policies::policy<policies::promote_double<false>, policies::domain_error<policies::ignore_error>>;
using StudentT = boost::math::students_t_distribution<double, Policy>;

template <class Mean, class Value>
Mean mean_and_half_width(std::span<const Value> values) {
    if (values.empty()) return {};
    const auto n = static_cast<double>(values.size());
    Value mean = 0;
    double squares = 0;
    for (const Value& v : values) mean += v / n;
    for (const Value& v : values) squares += std::norm(v - mean);
    return {mean, n > 1 ? student_t_95(n - 1) * std::sqrt(squares / (n - 1) / n) : NAN};
}

}  // namespace

double student_t_cdf(double t, double degrees) { return cdf(StudentT(degrees), t); }

double student_t_95(double degrees) { return quantile(StudentT(degrees), 0.975); }

IndependentMean mean_of_independent(std::span<const double> values) {
    return mean_and_half_width<IndependentMean>(values);
}

IndependentComplexMean mean_of_independent(std::span<const std::complex<double>> values) {
    return mean_and_half_width<IndependentComplexMean>(values);
}

}  // namespace tw
