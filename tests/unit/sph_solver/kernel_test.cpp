#include "sph_solver/equations/kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tw {
namespace kernel_test {

/// Integral of f(r) over space by the midpoint rule in r.
template <class F>
double over_space(double support, int dimensions, F f) {
    const int n = 4000;
    double sum = 0;
    for (int k = 0; k < n; ++k) {
        const double r = (k + 0.5) * support / n;
        sum += f(r) * (dimensions == 3 ? 4 * std::numbers::pi * r * r : 2 * std::numbers::pi * r) * support / n;
    }
    return sum;
}

TEST(Kernel, IntegratesToOneInTwoAndThreeDimensions) {
    for (int dimensions : {2, 3}) {
        const Kernel k(0.3, dimensions);
        EXPECT_NEAR(over_space(k.support(), dimensions, [&](double r) { return k.W(r); }), 1, 1e-5);
    }
}

TEST(Kernel, GradientIsTheDerivativeOfW) {
    const Kernel k(0.3, 3);
    for (double r : {0.05, 0.2, 0.41, 0.55}) {
        const double e = 1e-4, derivative = (k.W(r + e) - k.W(r - e)) / (2 * e);
        EXPECT_NEAR(-k.F(r) * r, derivative, 1e-4 * std::abs(derivative));  // grad_i W_ij = F r_ji
    }
}

TEST(Kernel, FirstMomentOfTheGradientIsTheUnitTensor) {
    // integral of r_ji (x) grad_i W_ij = 1: what makes linear fields differentiate exactly
    for (int dimensions : {2, 3}) {
        const Kernel k(0.7, dimensions);
        EXPECT_NEAR(over_space(k.support(), dimensions, [&](double r) { return k.F(r) * r * r / dimensions; }), 1,
                    1e-5);
    }
}

TEST(Kernel, EndsAtTwoH) {
    const Kernel k(0.5, 3);
    EXPECT_EQ(k.W(1.0001), 0);
    EXPECT_EQ(k.F(1.0001), 0);
    EXPECT_GT(k.W(0.99), 0);
}

}  // namespace kernel_test
}  // namespace tw
