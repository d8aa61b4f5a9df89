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

}  // namespace tw
